# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut, in a few lines with their icons. No Blender in here."""

from typing import NamedTuple

from ..cloth import piece_strain_words, strained_pieces
from ..report_file import SHOWN_SENTENCES, kept_text
from ..report_names import piece_name, piece_names

SHOWN_NAMES = 12


class VerdictLine(NamedTuple):
    text: str
    icon: str


def verdict(report: dict) -> list[VerdictLine]:
    """Of a report of the model as it is, the worst first."""
    pieces = report["pieces"]
    if not pieces:
        return [VerdictLine("Not flattened", "CANCEL")]
    strained = strained_pieces(report)
    good = [piece["index"] for piece in pieces if piece["ok"] and piece not in strained]
    count = "1 piece" if len(pieces) == 1 else f"{len(pieces)} pieces"
    lines = []
    if not report["ok"]:
        failed = f"{sum(not piece['ok'] for piece in pieces)} of {count}" if len(pieces) > 1 else "the piece"
        lines.append(VerdictLine(f"Do not cut: {failed} failed", "CANCEL"))
    lines += _strained_lines(report, strained)
    if len(good) == len(pieces):
        lines.append(VerdictLine(f"Ready to cut: {count}, {kept_text([report])}", "TICK"))
    elif good:
        lines.append(VerdictLine(f"Ready to cut: {_capped(report, good)}", "TICK"))
    return lines


def _strained_lines(report: dict, strained: list[dict]) -> list[VerdictLine]:
    lines = []
    for piece in strained[:SHOWN_SENTENCES]:
        name = piece_name(report, piece["index"])
        lines.append(VerdictLine(f"{name}: lengths kept, but the cloth must {piece_strain_words(piece)}", "ERROR"))
    hidden = len(strained) - SHOWN_SENTENCES
    more = [VerdictLine(f"And {hidden} more: see Area, Stretch below", "BLANK1")] if hidden > 0 else []
    return lines + more


def _capped(report: dict, pieces: list[int]) -> str:
    hidden = len(pieces) - SHOWN_NAMES
    return piece_names(report, pieces[:SHOWN_NAMES]) + (f" and {hidden} more" if hidden > 0 else "")
