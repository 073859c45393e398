# SPDX-License-Identifier: GPL-3.0-or-later
"""Notes of a report: what is good to know, and what may be wrong with the pieces. No Blender in here."""


def note(text: str) -> dict:
    return {"text": text, "is_warning": False}


def warning(text: str) -> dict:
    return {"text": text, "is_warning": True}
