# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut, in a few lines with their icons. No Blender in here."""

from typing import NamedTuple

from ..cloth import strain_text, strained_pieces
from ..report_file import SHOWN_SENTENCES, kept_text


class VerdictLine(NamedTuple):
    text: str
    icon: str
    piece: int | None = None  # for the button that selects it


def verdict(report: dict) -> list[VerdictLine]:
    """Of a report of the model as it is, the worst first."""
    pieces = report["pieces"]
    if not pieces:
        return [VerdictLine("Not flattened", "CANCEL")]
    strained = strained_pieces(report)
    good = [piece["name"] for piece in pieces if piece["ok"] and piece not in strained]
    count = "1 piece" if len(pieces) == 1 else f"{len(pieces)} pieces"
    lines = []
    if not report["ok"]:
        failed = f"{sum(not piece['ok'] for piece in pieces)} of {count}" if len(pieces) > 1 else "the piece"
        lines.append(VerdictLine(f"Do not cut: {failed} failed", "CANCEL"))
    lines += _strained_lines(strained)
    if len(good) == len(pieces):
        lines.append(VerdictLine(f"Ready to cut: {count}, {kept_text([report])}", "TICK"))
    elif good:
        lines.append(VerdictLine(f"Ready to cut: {', '.join(good)}", "TICK"))
    return lines


def _strained_lines(strained: list[dict]) -> list[VerdictLine]:
    lines = [
        VerdictLine(strain_text(piece["name"], piece), "ERROR", piece["index"]) for piece in strained[:SHOWN_SENTENCES]
    ]
    hidden = len(strained) - SHOWN_SENTENCES
    more = [VerdictLine(f"And {hidden} more: see Pieces below", "BLANK1")] if hidden > 0 else []
    return lines + more
