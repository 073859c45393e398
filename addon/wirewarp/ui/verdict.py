# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut, in a line or two with their icons. No Blender in here."""

from ..report_file import kept_text


def verdict(report: dict) -> list[tuple[str, str]]:
    """(sentence, icon) of a report of the model as it is."""
    pieces = report["pieces"]
    if not pieces:
        return [("Not flattened", "CANCEL")]
    count = "1 piece" if len(pieces) == 1 else f"{len(pieces)} pieces"
    if report["ok"]:
        return [(f"Ready to cut: {count}, {kept_text([report])}", "TICK")]
    failed = f"{sum(not piece['ok'] for piece in pieces)} of {count}" if len(pieces) > 1 else "the piece"
    lines = [(f"Do not cut: {failed} failed", "CANCEL")]
    good = [str(piece["index"] + 1) for piece in pieces if piece["ok"]]
    if good:
        lines.append((f"Ready to cut: piece{'s' if len(good) > 1 else ''} {', '.join(good)}", "TICK"))
    return lines
