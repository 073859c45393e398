# SPDX-License-Identifier: GPL-3.0-or-later
"""The last report of each object, for the panel and for Select Problems.

A run that wrote something leaves its report on the object, so that it is saved with it. A run that wrote nothing must
leave the file alone: its report is kept here, until the next run or file, and goes to the object when the user saves.
A report that was changed by anything else is not shown: what it says need not be true, nor can it be read safely.
"""

import hashlib
import json

import bpy
from bpy.app.handlers import persistent

from .issues import Issue
from .pieces.records import piece_names
from .rename_wires import rename_wires
from .report import SCHEMA, failure_report
from .wire_names import present_names

REPORT = "wirewarp_report"  # custom property of the object: JSON
SEAL = "wirewarp_report_seal"  # another: the digest of that text
_unwritten: dict[str, dict] = {}
# Text and seal, and what they say, so that drawing the panel need not parse it.
_parsed: dict[str, tuple[tuple[str, str], dict]] = {}


def store(source: bpy.types.Object, report: dict) -> None:
    """Keeps the report of a run that wrote results."""
    _unwritten.pop(source.name_full, None)
    text = json.dumps(report)
    source[REPORT], source[SEAL] = text, _digest(text)


def remember(source: bpy.types.Object, report: dict) -> None:
    """Keeps the report of a run that wrote nothing for this object."""
    _unwritten[source.name_full] = report


def last_report(source: bpy.types.Object) -> dict | None:
    """The report of the last run, its pieces and wires by the names they have now. None if there was none."""
    report = _find(source)
    if report and report["pieces"]:
        names = piece_names(source)
        for piece in report["pieces"]:
            piece["name"] = names.get(piece["piece_id"], piece["name"])
        rename_wires(report, present_names(source.data, {wire["wire_id"]: wire["name"] for wire in report["wires"]}))
    return report


def _find(source: bpy.types.Object) -> dict | None:
    if source.name_full in _unwritten:
        return _unwritten[source.name_full]
    if REPORT not in source:
        return None
    stored = _text(source, REPORT), _text(source, SEAL)
    known, report = _parsed.get(source.name_full, (None, None))
    if report is None or known != stored:
        report = _parse(*stored)
        _parsed[source.name_full] = stored, report
    return report


def _text(source: bpy.types.Object, name: str) -> str:
    """Of a custom property; "" where it is no text."""
    stored = source.get(name)
    return stored if isinstance(stored, str) else ""


def _digest(text: str) -> str:
    return hashlib.blake2b(text.encode(errors="replace"), digest_size=12).hexdigest()


def _parse(text: str, seal: str) -> dict:
    report = json.loads(text) if seal == _digest(text) else {}
    if report.get("schema") == SCHEMA:
        return report
    return failure_report(
        Issue("unreadable_report", "The stored report is not one of this version of WireWarp: flatten again.")
    )


@persistent
def _store_unwritten(*_: object) -> None:
    for source in bpy.data.objects:
        if source.name_full in _unwritten and source.library is None:
            store(source, _unwritten[source.name_full])


@persistent
def _forget_incomparable(*_: object) -> None:
    """After undo: a report stays if it can tell whether the model is still, or again, the one it is of."""
    for name in [name for name, report in _unwritten.items() if report.get("model_state") is None]:
        del _unwritten[name]


@persistent
def _forget(*_: object) -> None:
    _unwritten.clear()
    _parsed.clear()


def attach() -> None:
    bpy.app.handlers.save_pre.append(_store_unwritten)
    bpy.app.handlers.undo_post.append(_forget_incomparable)
    bpy.app.handlers.redo_post.append(_forget_incomparable)
    bpy.app.handlers.load_post.append(_forget)


def detach() -> None:
    bpy.app.handlers.save_pre.remove(_store_unwritten)
    bpy.app.handlers.undo_post.remove(_forget_incomparable)
    bpy.app.handlers.redo_post.remove(_forget_incomparable)
    bpy.app.handlers.load_post.remove(_forget)
    _forget()
