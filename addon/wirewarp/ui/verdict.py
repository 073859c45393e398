# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut, in a few lines with their icons. No Blender in here."""

from typing import NamedTuple

from ..cloth import largest, ready_text, strain_words, strained_pieces
from ..report_file import kept_text
from ..report_names import piece_names
from ..words import counted

SHOWN_NAMES = 4


class VerdictLine(NamedTuple):
    text: str
    icon: str


def verdict(report: dict) -> list[VerdictLine]:
    """Of a report of the model as it is, the worst first."""
    pieces = report["pieces"]
    if not pieces:
        return [VerdictLine("Not flattened", "CANCEL")]
    strained = strained_pieces(report)
    good = [piece for piece in pieces if piece["ok"] and piece not in strained]
    count = counted(len(pieces), "piece")
    lines = []
    if not report["ok"]:
        failed = f"{sum(not piece['ok'] for piece in pieces)} of {count}" if len(pieces) > 1 else "the piece"
        lines.append(VerdictLine(f"Do not cut: {failed} failed", "CANCEL"))
    if strained:
        lines.append(_strained_line(report, strained))
    if len(good) == len(pieces):
        lines.append(VerdictLine(f"{ready_text(good)}: {count}, {kept_text([report])}", "TICK"))
    elif good:
        lines.append(VerdictLine(f"{ready_text(good)}: {_others(report, good)}", "TICK"))
    return lines


def _strained_line(report: dict, strained: list[dict]) -> VerdictLine:
    names = piece_names(report, [piece["index"] for piece in strained[:SHOWN_NAMES]])
    hidden = len(strained) - SHOWN_NAMES
    more = f" and {hidden} more" if hidden > 0 else ""
    words = strain_words(*(max(largest(piece[name]) for piece in strained) for name in ("stretch_max", "ease_max")))
    return VerdictLine(f"{names}{more}: lengths kept, but the cloth must {words}", "ERROR")


def _others(report: dict, good: list[dict]) -> str:
    """The good pieces among others."""
    if len(good) > SHOWN_NAMES:
        return f"the other {len(good)} pieces"
    return piece_names(report, [piece["index"] for piece in good])
