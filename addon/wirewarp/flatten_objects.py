# SPDX-License-Identifier: GPL-3.0-or-later
"""Flatten as a whole: everything is computed before anything is written."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from types import ModuleType
from typing import Any

import bpy
import numpy as np

from .flat_mesh import FlatMesh, flat_mesh
from .flatten_job import FlattenChoices, Progress, flatten_arrays, has_layout
from .foreach import read
from .helper_lines import helper_lines
from .issues import ObjectError
from .left_out import left_out
from .mesh_to_arrays import MeshArrays, element_counts, object_to_arrays
from .model_maps import model_maps
from .model_state import model_state
from .pieces.identity import PieceIdentity, identify_pieces
from .pieces.records import known_pieces, write_pieces
from .properties import FlattenSettings
from .report import failure_report, object_report
from .report_store import remember, store
from .targets import check_target
from .unit_text import meters_per_blender_unit
from .wire_attributes import wires_on
from .wire_names import update_names
from .write_flat_object import find_flat_object, our_collection, show_flat_object, write_flat_object
from .write_helper_wires import remove_helper_wires, write_helper_wires
from .write_maps import remove_model_maps, write_model_maps
from .write_uv import UV_LAYER, write_uv


@dataclass
class Outcome:
    """What became of one object; without arrays and result it could not be flattened at all."""

    source: bpy.types.Object
    report: dict
    arrays: MeshArrays | None = None
    result: Any = None
    pieces: Sequence[PieceIdentity] = ()

    @property
    def has_layout(self) -> bool:
        return self.result is not None and bool(has_layout(self.result.corner_uv).any())


def compute(
    context: bpy.types.Context,
    library: ModuleType,
    sources: list[bpy.types.Object],
    choices: FlattenChoices,
    use_modifiers: bool,
    progress: Callable[[float], None],
) -> list[Outcome]:
    """Flattens every object, in Object Mode; writes nothing."""
    context.view_layer.update()
    depsgraph = context.evaluated_depsgraph_get() if use_modifiers else None
    meters = meters_per_blender_unit(context.scene)
    outcomes = []
    for index, source in enumerate(sources):
        state = None
        try:
            check_target(source, writes_uv=not use_modifiers)
            arrays = object_to_arrays(source, depsgraph)
            state = model_state(source)
            result = flatten_arrays(library, arrays, choices, _share(progress, index, len(sources)))
        except ObjectError as error:
            outcome = Outcome(source, failure_report(error.issue))
        else:
            # Results with modifiers are not written to the model: only the flat pieces know the last ids.
            known = known_pieces(source, arrays, find_flat_object(source) if use_modifiers else None)
            pieces = identify_pieces(result, arrays, known)
            outcome = Outcome(source, object_report(result, arrays, pieces, meters), arrays, result, pieces)
        outcome.report = _identify(outcome.report, source, use_modifiers)
        outcome.report |= {"options": asdict(choices), "model_state": state}
        outcome.report["notes"] += left_out(source, outcome.arrays, use_modifiers)
        outcomes.append(outcome)
    return outcomes


def write(context: bpy.types.Context, outcomes: list[Outcome], settings: FlattenSettings) -> None:
    """Writes UV layer, flat object, maps, helper wires and report of every object that has a layout."""
    for outcome in outcomes:
        if not outcome.has_layout:
            if find_flat_object(outcome.source):
                outcome.report["notes"].append("Nothing was written: the flat pieces are those of an earlier run.")
            remember(outcome.source, outcome.report)
            continue
        pieces = flat_mesh(outcome.result, outcome.arrays, outcome.pieces)
        if outcome.source.data.library is None:
            update_names(outcome.source.data, wires_on(outcome.source.data))
        write_pieces(outcome.source, outcome.result, outcome.arrays, outcome.pieces, not settings.use_modifiers)
        flat = write_flat_object(context.scene, outcome.source, pieces, outcome.arrays)
        if not settings.use_modifiers:
            _write_to_model(outcome, pieces, flat, settings.maps_on_model)
        _write_helper_wires(context.scene, outcome, flat, settings.helper_wires)
        context.view_layer.update()
        outcome.report["flat_object"] = flat.name
        outcome.report["notes"] += show_flat_object(context.view_layer, flat)
        store(outcome.source, outcome.report)


def _write_to_model(outcome: Outcome, pieces: FlatMesh, flat: bpy.types.Object, maps: bool) -> None:
    mesh = outcome.source.data
    scale = write_uv(mesh, outcome.result.corner_uv, outcome.arrays)
    outcome.report |= {"uv_layer": UV_LAYER, "uv_scale": scale}
    if maps:
        write_model_maps(mesh, model_maps(pieces, read(flat.data.edges, "vertices", np.int32, 2), outcome.arrays))
    else:
        remove_model_maps(mesh)


def _write_helper_wires(scene: bpy.types.Scene, outcome: Outcome, flat: bpy.types.Object, shown: bool) -> None:
    if shown:
        write_helper_wires(our_collection(scene), outcome.source, flat, helper_lines(outcome.result))
    else:
        remove_helper_wires(outcome.source, flat)


def _share(progress: Callable[[float], None], index: int, count: int) -> Progress:
    """The library's progress of one object as a part of the whole; never cancels."""

    def report(_stage: str, fraction: float) -> bool:
        progress((index + fraction) / count)
        return True

    return report


def _identify(report: dict, source: bpy.types.Object, use_modifiers: bool) -> dict:
    """The report with the object's names in front."""
    names = {"object": source.name, "mesh": source.data.name, "with_modifiers": use_modifiers}
    return names | {"counts": element_counts(source.data)} | report
