# SPDX-License-Identifier: GPL-3.0-or-later
"""The reports of one run as one JSON file, and as the sentences Blender shows. No Blender in here."""

import json
from pathlib import Path

from .cloth import aspect_ratio, ready_text, strain_text, strained_pieces
from .replace_file import replaced_file
from .report import SCHEMA
from .torn_edges import TORN
from .words import counted

SHOWN_SENTENCES = 4


def run_report(version: str, units: dict, reports: list[dict]) -> dict:
    return {
        "schema": SCHEMA,
        "wirewarp": version,
        "units": units,
        "ok": all(report["ok"] for report in reports),
        "objects": reports,
    }


def write_json(path: Path, report: dict) -> None:
    """Raises OSError, and leaves the file as it was, if it cannot be written."""
    with replaced_file(path) as unfinished:
        unfinished.write_text(json.dumps(report, indent=1, allow_nan=False) + "\n", encoding="utf-8")


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
