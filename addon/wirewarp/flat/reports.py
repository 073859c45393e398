# SPDX-License-Identifier: GPL-3.0-or-later
"""The reports of each object: that of its flat pieces, and that of a run since then that wrote nothing.

A run that wrote something leaves its report on the object, so that it is saved with it. A run that wrote nothing must
leave the file alone: its report is kept here, until the next run or file, and goes to the object, beside that of the
pieces, when the user saves. A report that was changed by anything else is not shown: what it says need not be true, nor
can it be read safely.
"""

import hashlib
import json

import bpy
from bpy.app.handlers import persistent

from ..blender.mesh import element_counts
from ..issues import Issue
from ..model.wire_names import present_names
from ..report.names import rename_wires
from ..report.report import SCHEMA, failure_report
from .pieces import piece_names

# Custom properties of the object: JSON. Beside each another, with the digest of that text.
REPORT, FAILURE = "wirewarp_report", "wirewarp_failure"
SEAL = "_seal"
_failures: dict[object, dict] = {}  # by object, see _key
# Text and seal, and what they say, so that drawing the panel need not parse it.
_parsed: dict[tuple[str, str], tuple[tuple[str, str], dict]] = {}


def store(source: bpy.types.Object, report: dict) -> None:
    """Keeps the report of a run that wrote results."""
    _failures.pop(_key(source), None)
    for name in (FAILURE, FAILURE + SEAL):
        if name in source:
            del source[name]
    _write(source, REPORT, report)


def remember(source: bpy.types.Object, report: dict) -> None:
    """Keeps the report of a run that wrote nothing for this object."""
    _failures[_key(source)] = report


def last_report(source: bpy.types.Object) -> dict | None:
    """The report of the last run, its pieces and wires by the names they have now. None if there was none."""
    failure = _failures.get(_key(source)) or _read(source, FAILURE)
    return with_names(source, failure) or pieces_report(source)


def pieces_report(source: bpy.types.Object) -> dict | None:
    """The report of the run that wrote the flat pieces, whatever has failed since. None if there was none."""
    return with_names(source, _read(source, REPORT))


def flattened_name(source: bpy.types.Object) -> str:
    """What the model was called when its flat pieces were made; its present name where there are none."""
    return (_read(source, REPORT) or {}).get("object", source.name)


def with_names(source: bpy.types.Object, report: dict | None) -> dict | None:
    """The report itself, its pieces and wires called as in the lists of the model."""
    if report and report["pieces"]:
        names = piece_names(source)
        for piece in report["pieces"]:
            piece["name"] = names.get(piece["piece_id"], piece["name"])
        rename_wires(report, present_names(source.data, report["wires"]))
    return report


def _key(source: bpy.types.Object) -> object:
    """The same for one object whatever it is called, and for no later one of its name.

    Before Blender 4.1 objects have addresses only, which later ones may get: their meshes tell them apart.
    """
    if hasattr(source, "session_uid"):
        return source.session_uid
    return source.as_pointer(), *element_counts(source.data).values()


def _write(source: bpy.types.Object, name: str, report: dict) -> None:
    text = json.dumps(report)
    source[name], source[name + SEAL] = text, _digest(text)


def _read(source: bpy.types.Object, name: str) -> dict | None:
    if name not in source:
        return None
    stored = _text(source, name), _text(source, name + SEAL)
    known, report = _parsed.get((source.name_full, name), (None, None))
    if report is None or known != stored:
        report = _parse(*stored)
        _parsed[source.name_full, name] = stored, report
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
def _store_failures(*_: object) -> None:
    for source in bpy.data.objects if _failures else ():
        if source.type == "MESH" and source.library is None and _key(source) in _failures:
            _write(source, FAILURE, _failures[_key(source)])


@persistent
def _forget_incomparable(*_: object) -> None:
    """After undo: a report stays if it can tell whether the model is still, or again, the one it is of."""
    for key in [key for key, report in _failures.items() if report.get("model_state") is None]:
        del _failures[key]


@persistent
def _forget(*_: object) -> None:
    _failures.clear()
    _parsed.clear()


def attach() -> None:
    bpy.app.handlers.save_pre.append(_store_failures)
    bpy.app.handlers.undo_post.append(_forget_incomparable)
    bpy.app.handlers.redo_post.append(_forget_incomparable)
    bpy.app.handlers.load_post.append(_forget)


def detach() -> None:
    bpy.app.handlers.save_pre.remove(_store_failures)
    bpy.app.handlers.undo_post.remove(_forget_incomparable)
    bpy.app.handlers.redo_post.remove(_forget_incomparable)
    bpy.app.handlers.load_post.remove(_forget)
    _forget()
