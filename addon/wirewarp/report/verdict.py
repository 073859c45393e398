# SPDX-License-Identifier: GPL-3.0-or-later
"""Which pieces may be cut: the lines in the sidebar, the message of a run, and its reports as one."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ..words import counted, paragraph
from .cloth import aspect_ratio, is_strained, is_unsewable, largest, ready_text, strain_words
from .hints import TORN
from .report import SCHEMA
from .threads import beyond_text, ready_words

SHOWN_NAMES = 4
SHOWN_SENTENCES = 4
Entry = tuple[dict, dict]  # a report and one of its pieces


class VerdictLine(NamedTuple):
    text: str
    icon: str  # CANCEL: do not cut; AMBER: not before you have looked; TICK: cut


def verdict(*reports: dict) -> list[VerdictLine]:
    """Of reports of models as they are, the worst first: in the sidebar of one, after a run of all."""
    entries = [(report, piece) for report in reports for piece in report["pieces"]]
    if not entries:
        return [VerdictLine("Not flattened", "CANCEL")]
    unsewable = [entry for entry in entries if is_unsewable(entry[1])]
    strained = [entry for entry in entries if is_strained(entry[1]) and entry not in unsewable]
    good = [entry for entry in entries if entry[1]["ok"] and not is_strained(entry[1])]
    failed = [entry for entry in entries if not entry[1]["ok"]]
    count = counted(len(entries), "piece")
    lines = []
    if failed:
        which = f"{len(failed)} of {count}" if len(entries) > 1 else "the piece"
        lines.append(VerdictLine(f"Do not cut: {which} failed", "CANCEL"))
    if unsewable:
        names = _shown_names(_worst_first(unsewable), len(reports) > 1)
        lines.append(VerdictLine(f"{names}: no cloth stretches that far. Add seams.", "AMBER"))
    of_cloth = [entry for entry in strained if entry[1].get("threads")]
    lines += [VerdictLine(text, "AMBER") for text in _beyond_texts(_worst_first(of_cloth), len(reports) > 1)]
    others = [entry for entry in strained if entry not in of_cloth]
    if others:
        lines.append(_strained_line(_worst_first(others), len(reports) > 1))
    if not good:
        return lines
    which = f"{count}, {kept_text(reports)}" if len(good) == len(entries) else _others(good, len(reports) > 1)
    threads = [piece["threads"] for _, piece in good if piece.get("threads")]
    ready = ready_words(threads) if threads else ready_text([piece for _, piece in good])
    return [*lines, VerdictLine(f"{ready}: {which}", "TICK")]


def as_seen(lines: list[VerdictLine], makers: Iterable[str]) -> list[VerdictLine]:
    """The verdict where modifiers or shape keys, which were left out, make the model look otherwise."""
    makers = list(dict.fromkeys(makers))
    if not makers:
        return lines
    text = f"{' and '.join(makers).capitalize()} were ignored, so sizes differ from what you see"
    return [line for line in lines if line.icon != "TICK"] + [VerdictLine(text, "AMBER")]


def left_out_of(report: dict) -> list[str]:
    """What was left out of a run, though it changes what is seen."""
    return [] if report.get("with_modifiers") else report.get("shaped_by", [])


def _worst_first(entries: list[Entry]) -> list[Entry]:
    return sorted(entries, key=lambda entry: -aspect_ratio(entry[1]))


def _strained_line(strained: list[Entry], with_objects: bool) -> VerdictLine:
    pieces = [piece for _, piece in strained]
    words = strain_words(*(max(largest(piece[name]) for piece in pieces) for name in ("stretch_max", "ease_max")))
    keep, remedy = ("keeps its", "a dart or seam") if len(strained) == 1 else ("keep their", "darts or seams")
    names = _shown_names(strained, with_objects)
    return VerdictLine(f"{names} {keep} lengths, but the cloth must {words}. Add {remedy} there.", "AMBER")


def _beyond_texts(strained: list[Entry], with_objects: bool) -> list[str]:
    """Of pieces that need more than their cloth gives, a sentence each."""
    shown = [beyond_text(_names([entry], with_objects), entry[1]["threads"]) for entry in strained[:SHOWN_NAMES]]
    hidden = len(strained) - len(shown)
    return shown + ([f"And {counted(hidden, 'more piece')}"] if hidden else [])


def _shown_names(entries: list[Entry], with_objects: bool) -> str:
    hidden = len(entries) - SHOWN_NAMES
    if hidden > 0 or with_objects:
        return _names(entries[:SHOWN_NAMES], with_objects) + (f" and {hidden} more" if hidden > 0 else "")
    *others, last = dict.fromkeys(piece["name"] for _, piece in entries)
    return f"{', '.join(others)} and {last}" if others else last


def _others(good: list[Entry], with_objects: bool) -> str:
    """The good pieces among others."""
    return f"the other {len(good)} pieces" if len(good) > SHOWN_NAMES else _names(good, with_objects)


def _names(entries: list[Entry], with_objects: bool) -> str:
    """Each once."""
    names = [_place(report, piece["index"]) if with_objects else piece["name"] for report, piece in entries]
    return "; ".join(dict.fromkeys(names)) if with_objects else ", ".join(dict.fromkeys(names))


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
        left_out = as_seen([], (maker for report in reports for maker in left_out_of(report)))
        return "ERROR", paragraph([failure_text(reports), *(line.text for line in left_out), *warnings, *torn])
    lines = as_seen(verdict(*reports), (maker for report in reports for maker in left_out_of(report)))
    is_fine = all(line.icon == "TICK" for line in lines) and not any(note["is_warning"] for note in notes)
    sentences = [line.text for line in lines] + [note["text"] for note in notes]
    return "INFO" if is_fine else "WARNING", paragraph(sentences)


def failure_text(reports: list[dict]) -> str:
    """What failed, a sentence each."""
    lines = [
        f"{_place(report, issue['piece'])}: {issue['sentence']}" for report in reports for issue in report["issues"]
    ]
    return _capped(lines)


def kept_text(reports: Sequence[dict]) -> str:
    """What is true of the lengths in reports without an issue."""
    loose = any(
        wire["tolerance"] != 0 for report in reports if report["method"] != "wirewarping" for wire in report["wires"]
    )
    return "every length kept or within its tolerance" if loose else "every length kept"


def _capped(lines: list[str]) -> str:
    hidden = len(lines) - SHOWN_SENTENCES
    more = [f"And {hidden} more: see the report in the sidebar."] if hidden > 0 else []
    return paragraph(lines[:SHOWN_SENTENCES] + more)


def _place(report: dict, piece: int | None) -> str:
    """The object and the piece, where it is one and does not have the name of the object."""
    name = report["object"] if piece is None else report["pieces"][piece]["name"]
    return name if name == report["object"] else f"{report['object']}, {name}"
