# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers and names in sentences. No Blender in here."""

from collections.abc import Iterable


def counted(count: int, one: str, many: str = "") -> str:
    """ "1 edge", "2 edges". many: the words of the plural where an s does not make them, "edges lie"."""
    return f"{count} {one if count == 1 else many or f'{one}s'}"


def quoted(names: Iterable[str]) -> str:
    """ "Front", "Back": each with its quotation marks."""
    return ", ".join(f'"{name}"' for name in names)
