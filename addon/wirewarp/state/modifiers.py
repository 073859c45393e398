# SPDX-License-Identifier: GPL-3.0-or-later
"""What the model has and the flat pieces have not."""

import bpy
import numpy as np

from ..blender.mesh import edge_vertices, evaluated_mesh, faces_at_edges, vertex_places
from ..core import Note
from ..issues import note, object_error, warning
from ..names import UV_LAYER
from ..solve.arrays import MeshArrays
from ..words import counted

LEVELS = 2  # a turn of 60 degrees, the largest that a curve has, becomes four of 15
MOST_LEVELS = 4  # each has four times the faces of the one before
ROUNDING = 1e-5  # of the model's size: what matrices of single precision move a vertex that an armature at rest holds


def left_out(source: bpy.types.Object, arrays: MeshArrays | None, use_modifiers: bool) -> list[Note]:
    notes = []
    if use_modifiers and UV_LAYER in source.data.uv_layers:
        text = f'The UV map "{UV_LAYER}" is from an earlier run without Modifiers. It does not show these pieces.'
        notes.append(note(text))
    if arrays and arrays.loose_marks:
        ignored = counted(arrays.loose_marks, "marked edge ignored: it has", "marked edges ignored: they have")
        notes.append(warning(f"{ignored} no face."))
    if arrays and arrays.loose_eases:
        edges = counted(
            arrays.loose_eases, "edge has an ease but is not a wire", "edges have an ease but are not wires"
        )
        notes.append(warning(f"{edges}: it was not used. Mark them with Ease."))
    return notes


def shaped_by(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> list[str]:
    """What makes the object look other than its base mesh: modifiers, shape keys. In Object Mode.

    By its shape as it is evaluated: an armature at rest changes nothing, nor does a modifier of normals.
    """
    makers = ["modifiers"] if any(modifier.show_viewport for modifier in source.modifiers) else []
    makers += ["shape keys"] if source.data.shape_keys else []
    if not makers:
        return []
    return [] if _is_same_shape(source.data, source.evaluated_get(depsgraph).data) else makers


def subdivide(source: bpy.types.Object, is_used: bool) -> None:
    """Adds a level of subdivision, by a modifier; corners of outlines stay. is_used: the last run had modifiers."""
    found = [modifier for modifier in source.modifiers if modifier.type == "SUBSURF" and modifier.show_viewport]
    if found and is_used:
        found[-1].levels = max(found[-1].levels, min(found[-1].levels + 1, MOST_LEVELS))
    elif not found:
        added = source.modifiers.new("Subdivision", "SUBSURF")
        added.levels = added.render_levels = LEVELS
        added.boundary_smooth = "PRESERVE_CORNERS"


def outline_change(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> float:
    """By which share modifiers make the outlines longer; below 0 shorter, as subdivision does. In Object Mode."""
    before = _outline_length(source.data)
    with evaluated_mesh(source, depsgraph) as mesh:
        return _outline_length(mesh) / before - 1 if before else 0.0


def _outline_length(mesh: bpy.types.Mesh) -> float:
    ends = vertex_places(mesh)[edge_vertices(mesh)[faces_at_edges(mesh) == 1]]
    return float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum())


def apply_modifiers(source: bpy.types.Object) -> None:
    """All that are shown. In Object Mode. Raises ObjectError, with nothing changed, where Blender cannot apply them."""
    if source.data.shape_keys or source.data.users > 1:
        why = "has shape keys" if source.data.shape_keys else "shares its mesh with other objects"
        raise object_error("modifiers", f'"{source.name}" {why}, so modifiers cannot be applied.')
    with bpy.context.temp_override(object=source, active_object=source):
        for name in [modifier.name for modifier in source.modifiers if modifier.show_viewport]:
            bpy.ops.object.modifier_apply(modifier=name)


def _is_same_shape(base: bpy.types.Mesh, seen: bpy.types.Mesh) -> bool:
    """Where a modifier splits edges, the same places are there several times."""
    if len(base.polygons) != len(seen.polygons):
        return False
    places, seen_places = (vertex_places(mesh) for mesh in (base, seen))
    if len(places) != len(seen_places):
        return np.array_equal(np.unique(places, axis=0), np.unique(seen_places, axis=0))
    size = float(np.abs(places).max(initial=0))
    return bool(np.allclose(places, seen_places, rtol=0, atol=ROUNDING * size, equal_nan=True))
