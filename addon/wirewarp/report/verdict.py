# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut: the lines in the sidebar, the message of a run, and its reports as one."""

from typing import NamedTuple

from ..words import counted
from .cloth import aspect_ratio, largest, ready_text, strain_text, strain_words, strained_pieces
from .hints import TORN
from .names import piece_names
from .report import SCHEMA

SHOWN_NAMES = 4
SHOWN_SENTENCES = 4


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


def run_report(version: str, units: dict, reports: list[dict]) -> dict:
    return {
        "schema": SCHEMA,
        "wirewarp": version,
        "units": units,
        "ok": all(report["ok"] for report in reports),
        "objects": reports,
    }


def run_message(reports: list[dict]) -> tuple[str, str]:
    """How loudly Blender shows what became of the run (INFO, WARNING or ERROR), and the text."""
    notes = [note for report in reports for note in report["notes"]]
    if not all(report["ok"] for report in reports):
        warnings = [note["text"] for note in notes if note["is_warning"]]
        torn = {hint["sentence"] for report in reports for hint in report["hints"] if hint["code"] == TORN}
        return "ERROR", "\n".join([failure_text(reports), *warnings, *torn])
    strained = strained_text(reports)
    level = "WARNING" if strained or any(note["is_warning"] for note in notes) else "INFO"
    return level, "\n".join([strained or success_text(reports), *(note["text"] for note in notes)])


def failure_text(reports: list[dict]) -> str:
    """What failed, one line each."""
    lines = [
        f"{_place(report, issue['piece'])}: {issue['sentence']}" for report in reports for issue in report["issues"]
    ]
    return _capped(lines)


def strained_text(reports: list[dict]) -> str:
    """Which of the pieces that keep their lengths no cloth can follow, one line each; "" if none."""
    strained = [(report, piece) for report in reports for piece in strained_pieces(report)]
    strained.sort(key=lambda entry: aspect_ratio(entry[1]), reverse=True)
    return _capped([strain_text(_subject(report, piece), piece) for report, piece in strained])


def success_text(reports: list[dict]) -> str:
    """Of reports without an issue and without a strained piece."""
    pieces = [piece for report in reports for piece in report["pieces"]]
    count = counted(len(pieces), "flat piece")
    return f"{ready_text(pieces)}: {count}, {kept_text(reports)} ({reports[0]['method_name']})"


def kept_text(reports: list[dict]) -> str:
    """What is true of the lengths in reports without an issue."""
    loose = any(
        wire["tolerance"] != 0 for report in reports if report["method"] != "wirewarping" for wire in report["wires"]
    )
    return "every length kept or within its tolerance" if loose else "every length kept"


def _capped(lines: list[str]) -> str:
    hidden = len(lines) - SHOWN_SENTENCES
    more = [f"And {hidden} more: see the report in the sidebar."] if hidden > 0 else []
    return "\n".join(lines[:SHOWN_SENTENCES] + more)


def _subject(report: dict, piece: dict) -> str:
    """As _place, in the middle of a sentence."""
    place = _place(report, piece["index"])
    return place if place == report["object"] else f"{place},"


def _place(report: dict, piece: int | None) -> str:
    """The object and the piece, where it is one and does not have the name of the object."""
    name = report["object"] if piece is None else report["pieces"][piece]["name"]
    return name if name == report["object"] else f"{report['object']}, {name}"
