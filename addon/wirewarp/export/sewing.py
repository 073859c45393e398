# SPDX-License-Identifier: GPL-3.0-or-later
"""Copies the flat pieces for cloth simulation, with sewing edges along seams and with shape keys for the flat form
and for the form on the model.
"""

from collections.abc import Iterable, Iterator

import bpy
import numpy as np

from ..blender.mesh import edge_vertices, evaluated_mesh, vertex_places
from ..blender.objects import name_with, remove_object
from ..blender.selection import select_only
from ..issues import object_error
from ..names import FLAT_LENGTH, MARKS, SEAM
from ..solve.outlines import FlatPieces, outline_of
from ..state.flat_pieces import OF_ELEMENTS, current_pieces, read_flat_pieces
from ..state.owners import model_or_self
from ..ui.editing import OnMesh, reporting_refusals
from .read import EDITED

FLAT, WORN = "Flat", "On the Model"  # names of the shape keys
OURS = (*MARKS, *OF_ELEMENTS, SEAM, FLAT_LENGTH)


def add_sewing_object(source: bpy.types.Object) -> bpy.types.Object:
    """Add an object for sewing simulations at the place of the flat pieces, in Object Mode. Raises ObjectError if
    the pieces are missing or outdated."""
    report, flat = current_pieces(source)
    pieces = read_flat_pieces(flat.data)
    is_flat = [piece.has_layout for piece in report.pieces]  # pieces without a flat shape are not sewn
    seams = [seam.edges for seam in report.seams if any(is_flat[piece] for piece in seam.pieces)]
    sewn = sewing_edges(pieces, seams)
    worn = _worn(source, flat, pieces, report.with_modifiers)
    mesh = flat.data.copy()
    target = bpy.data.objects.new(name_with(source.name, " Sewing"), mesh)
    try:
        _forget_origin(mesh)
        _add_edges(mesh, sewn)
        target.matrix_world = flat.matrix_world
        target.shape_key_add(name=FLAT, from_mix=False)
        key = target.shape_key_add(name=WORN, from_mix=False)
        key.data.foreach_set("co", worn.astype(np.float32).ravel())
        key.value = 0.0  # Blender 5 creates keys with the value 1
        for collection in flat.users_collection:
            collection.objects.link(target)
    except BaseException:
        remove_object(target)
        raise
    return target


def sewing_edges(pieces: FlatPieces, seams: Iterable[list]) -> np.ndarray:
    """Return pairs (k,2) of flat vertices to sew together. Both vertices of a pair are the same vertex of the model.

    seams: edges of each seam as vertex pairs of the model
    Raises ObjectError if the pieces lack a seam.
    """
    outline = outline_of(pieces)
    sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for ends in outline.edges.tolist():
        a, b = sorted(ends, key=lambda vertex: int(pieces.source_vertex[vertex]))
        sides.setdefault((int(pieces.source_vertex[a]), int(pieces.source_vertex[b])), []).append((a, b))
    found = {pair for seam in seams for edge in seam for pair in _joining(sides, (min(edge), max(edge)))}
    return np.array(sorted(found), dtype=np.int32).reshape(-1, 2)


def _joining(sides: dict[tuple[int, int], list[tuple[int, int]]], edge: tuple[int, int]) -> Iterator[tuple[int, int]]:
    if edge not in sides:
        raise object_error("edited_pieces", EDITED)
    own = sides[edge]  # if a seam has more than two sides, each side is joined to the next side
    for first, second in zip(own[:-1], own[1:], strict=True):
        for a, b in zip(first, second, strict=True):
            if a != b:  # both sides of a dart share the vertex at its tip
                yield min(a, b), max(a, b)


def _worn(source: bpy.types.Object, flat: bpy.types.Object, pieces: FlatPieces, with_modifiers: bool) -> np.ndarray:
    """Return the places (n,3) of the pieces' vertices on the model, in the space of the flat object."""
    if with_modifiers:
        with evaluated_mesh(source, bpy.context.evaluated_depsgraph_get()) as mesh:
            places = vertex_places(mesh)
    else:
        places = vertex_places(source.data)
    matrix = np.array(flat.matrix_world.inverted() @ source.matrix_world)
    return places[pieces.source_vertex].astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]


def _forget_origin(mesh: bpy.types.Mesh) -> None:
    """Remove the data by which a copy of the flat mesh would count as flat pieces."""
    for attribute in OURS:
        if attribute.name in mesh.attributes:
            mesh.attributes.remove(mesh.attributes[attribute.name])
    for name in [name for name in mesh.keys() if name.startswith("wirewarp_")]:  # noqa: SIM118
        del mesh[name]
    mesh.wirewarp_names.clear()


def _add_edges(mesh: bpy.types.Mesh, added: np.ndarray) -> None:
    edges = np.concatenate([edge_vertices(mesh), added]).astype(np.int32)
    mesh.edges.add(len(added))
    mesh.edges.foreach_set("vertices", edges.ravel())
    mesh.update(calc_edges_loose=True)


class OBJECT_OT_wirewarp_sewing(OnMesh, bpy.types.Operator):
    """Copy the flat pieces with sewing edges between the sides of each seam, and a shape key that folds them onto the
    model"""

    bl_idname = "object.wirewarp_sewing"
    bl_label = "Add Sewing Edges"
    bl_options = {"REGISTER", "UNDO"}
    modes = frozenset({"OBJECT"})
    refusal = "Select a model that has been flattened, or its flat pieces, in Object Mode"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        target = add_sewing_object(model_or_self(context.active_object))
        context.view_layer.update()  # so that the view layer contains the new object
        if target.name not in context.view_layer.objects:  # the view layer excludes the collection
            context.scene.collection.objects.link(target)
        select_only(context, target)
        text = (
            f'"{target.name}" is ready for Physics > Cloth with Shape > Sewing. To see it on the model, use its shape '
            f'key "{WORN}".'
        )
        self.report({"INFO"}, text)
        return {"FINISHED"}
