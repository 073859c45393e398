# SPDX-License-Identifier: GPL-3.0-or-later
"""Switches between Object Mode and Edit Mode, makes undo work in both, and selects given elements."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import bmesh
import bpy
import numpy as np
from numpy.typing import ArrayLike

from ..core import Elements
from ..issues import changed_error, object_error
from ..solve.chains import are_among
from .mesh import corner_edges, current_mesh, edge_vertices, faces_of_corners, read
from .objects import check_local
from .views import show_place, work_area

# Modes in which the operators may start. Operators that need Object Mode use in_object_mode.
WORKING_MODES = frozenset({"OBJECT", "EDIT_MESH"})


def edited_meshes(context: bpy.types.Context) -> set[bpy.types.Mesh]:
    """Return the meshes in Edit Mode in this view layer; none unless the active object is in Edit Mode."""
    if context.mode != "EDIT_MESH":  # in_object_mode could not leave Edit Mode
        return set()
    # context.objects_in_mode is not used, because it may list objects of the window instead.
    return {each.data for each in context.view_layer.objects if each.type == "MESH" and each.mode == "EDIT"}


@contextmanager
def in_object_mode(context: bpy.types.Context) -> Iterator[None]:
    """Leave Edit Mode, so that mesh data is current and can be written. Return to Edit Mode at the end."""
    if context.mode != "EDIT_MESH":
        yield
        return
    edited = list(context.objects_in_mode)
    selected = list(context.selected_objects)
    bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        _select(context, edited)
        bpy.ops.object.mode_set(mode="EDIT")
        _select(context, selected)


def _select(context: bpy.types.Context, objects: list[bpy.types.Object]) -> None:
    for other in context.view_layer.objects:
        other.select_set(other in objects)


def select_only(context: bpy.types.Context, target: bpy.types.Object) -> None:
    """Make the object active, and select no other object."""
    for other in context.selected_objects:
        other.select_set(False)
    context.view_layer.objects.active = target
    target.select_set(True)


def hold_whole_file() -> None:
    """Makes the operator's undo step contain the whole file. Call it while the operator writes.

    In Edit Mode, undo would otherwise restore only the edited meshes, and not the flat pieces.
    """
    # After a data-block was added or removed, Blender stores the whole file with the next undo step.
    bpy.data.meshes.remove(bpy.data.meshes.new("WireWarp"))


LEAST_SHARE = 0.3  # least extent of a view, as a share of the object's size, so that surroundings of a face are visible


def select_elements(context: bpy.types.Context, target: bpy.types.Object, elements: Elements) -> None:
    """Make `target` active, select only these elements in its Edit Mode, and move the view to them.

    Raises ObjectError, with nothing changed, if the object cannot be shown or edited, or has no such elements.
    """
    check_local(target, target.data)
    with current_mesh(target) as current:
        edge_mask, loose_vertices = _find_edges(current, elements.edges)
        face_mask = _mask(target, current.polygons, elements.faces)
        # A pair without an edge (the diagonal of a quad) selects its two vertices.
        vertex_mask = _mask(target, current.vertices, [*elements.vertices, *loose_vertices])
    mesh = target.data
    _show(context, target)
    if context.mode == "EDIT_MESH":
        bpy.ops.object.mode_set(mode="OBJECT")
    deselect_all(mesh)
    select_only(context, target)

    # This is the coarsest selection mode that can show everything.
    level = 0 if vertex_mask.any() else 1 if edge_mask.any() else 2
    context.tool_settings.mesh_select_mode = tuple(level == each for each in range(3))

    edge_mask[corner_edges(mesh)[face_mask[faces_of_corners(mesh)]]] = True
    vertex_mask[edge_vertices(mesh)[edge_mask].ravel()] = True
    for every, mask in ((mesh.vertices, vertex_mask), (mesh.edges, edge_mask), (mesh.polygons, face_mask)):
        every.foreach_set("select", mask)
        every.foreach_set("hide", read(every, "hide", bool) & ~mask)
    if vertex_mask.any():
        _frame(context, target, vertex_mask)
    bpy.ops.object.mode_set(mode="EDIT")


def select_edges_in_edit_mode(mesh: bpy.types.Mesh, pairs: Iterable[tuple[int, int]]) -> None:
    """Select only the edges between these pairs of vertices, and show them, in a mesh that stays in Edit Mode."""
    edit = bmesh.from_edit_mesh(mesh)
    for element in (*edit.verts, *edit.edges, *edit.faces):
        element.select_set(False)
    edit.verts.ensure_lookup_table()
    for a, b in pairs:
        ends = edit.verts[a], edit.verts[b]
        edge = edit.edges.get(ends)
        for element in (*ends, edge):
            element.hide = False
        edge.select_set(True)
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def _frame(context: bpy.types.Context, target: bpy.types.Object, vertex_mask: np.ndarray) -> None:
    area = work_area(context)
    if area is None or bpy.app.background:  # in the background, views are not drawn and cannot be turned
        return
    matrix = np.array(target.matrix_world)
    linear = matrix[:3, :3]
    places = read(target.data.vertices, "co", np.float32, 3)[vertex_mask] @ linear.T + matrix[:3, 3]
    normals = read(target.data.vertices, "normal", np.float32, 3)[vertex_mask]
    if not target.dimensions.z:
        normals = np.abs(normals)  # flat pieces are viewed from above, even if they are mirrored
    normals = normals @ np.linalg.pinv(linear)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(np.float32).tiny)
    show_place(context, area, places, normals, LEAST_SHARE * max(target.dimensions))


def _show(context: bpy.types.Context, target: bpy.types.Object) -> None:
    """Make the object visible, because only visible objects can be active and edited. Raises ObjectError if it
    stays hidden."""
    if target not in context.view_layer.objects.values():
        raise object_error(
            "not_in_view_layer",
            f'"{target.name}" is not in this view layer: it was deleted, or its collection is excluded. '
            "Tick the collection in the Outliner.",
        )
    hidden = target.hide_get()
    target.hide_set(False)
    if not target.visible_get():
        target.hide_set(hidden)
        raise object_error(
            "not_visible",
            f'"{target.name}" is disabled in viewports, or its collection is hidden. Show it in the Outliner.',
        )


def _find_edges(mesh: bpy.types.Mesh, pairs: ArrayLike) -> tuple[np.ndarray, list[int]]:
    """Return a mask (e,) of the mesh's edges between these pairs of vertices, and the vertices of pairs without an
    edge."""
    edges, ends = edge_vertices(mesh), np.asarray(pairs, dtype=np.int64).reshape(-1, 2)
    return are_among(edges, ends), ends[~are_among(ends, edges)].ravel().tolist()


def _mask(target: bpy.types.Object, elements: bpy.types.bpy_prop_collection, indices: ArrayLike) -> np.ndarray:
    """Return a mask of the elements with these indices. Raises ObjectError if an index is beyond the object's
    elements."""
    wanted, mask = np.asarray(indices, dtype=np.int64), np.zeros(len(elements), dtype=bool)
    if np.any((wanted < 0) | (wanted >= len(elements))):
        raise changed_error(target.name)
    mask[wanted] = True
    return mask


def deselect_all(mesh: bpy.types.Mesh) -> None:
    """Deselect all elements of a mesh in Object Mode, because Blender selects new elements."""
    # On new meshes, Blender 5.0 gives the attribute of edges a wrong type. Writing this attribute or entering Edit Mode
    # then crashes Blender.
    for name in (".select_vert", ".select_edge", ".select_poly"):
        if attribute := mesh.attributes.get(name):
            mesh.attributes.remove(attribute)
