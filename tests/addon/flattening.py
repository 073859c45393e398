# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens models, changes them as scripts do, and measures models and flat pieces."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType

import bmesh
import bpy
import numpy as np
import pytest
from mathutils import Vector
from surfaces import flat_of, grid, read, select_only


def fails(operator: Callable, match: str, **settings: object) -> None:
    """Call an operator, which must raise an error whose text matches `match`."""
    with pytest.raises(RuntimeError, match=match):
        operator(**settings)


def flatten(source: bpy.types.Object, **settings: object) -> None:
    """Select only this object, and flatten it."""
    select_only(source)
    bpy.ops.object.wirewarp_flatten(**settings)


def flattened(*arguments: object, **settings: object) -> bpy.types.Object:
    """Make a grid with these arguments of surfaces.grid(), flatten it, and return it."""
    source = grid(*arguments, **settings)
    bpy.ops.object.wirewarp_flatten()
    return source


def report_after(addon: ModuleType, source: bpy.types.Object, **settings: object) -> object:
    """Flatten the selection, and return the report of this object."""
    bpy.ops.object.wirewarp_flatten(**settings)
    return addon.state.reports.last_report(source)


def flatten_fails(match: str, **settings: object) -> None:
    """Flatten the selection, which must fail with an error whose text matches `match`."""
    fails(bpy.ops.object.wirewarp_flatten, match, **settings)


@contextmanager
def edited(mesh: bpy.types.Mesh) -> Iterator[bmesh.types.BMesh]:
    """Yield a copy of the mesh. At the end, the mesh gets the edits of the copy."""
    edit = bmesh.new()
    edit.from_mesh(mesh)
    for elements in (edit.verts, edit.edges, edit.faces):
        elements.ensure_lookup_table()
    yield edit
    edit.to_mesh(mesh)
    edit.free()


def notify(target: bpy.types.Object) -> None:
    """Let Blender notice changes of the mesh by a script."""
    target.data.update()
    bpy.context.view_layer.update()


def raise_vertex(target: bpy.types.Object, by: float = 0.1, vertex: int = 40) -> None:
    """Move a vertex up, in Object Mode or Edit Mode, and let Blender notice the change."""
    if target.mode != "EDIT":
        target.data.vertices[vertex].co.z += by
        notify(target)
        return
    edit = bmesh.from_edit_mesh(target.data)
    edit.verts.ensure_lookup_table()
    edit.verts[vertex].co.z += by
    bmesh.update_edit_mesh(target.data)
    bpy.context.view_layer.update()


def edge_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    return read(mesh.edges, "vertices", np.int32, 2)


def edge_lengths(target: bpy.types.Object) -> np.ndarray:
    """Return every edge's length in world space, computed in double precision from float32 coordinates."""
    mesh = target.data
    linear = np.array(target.matrix_world, dtype=np.float64)[:3, :3]
    positions = read(mesh.vertices, "co", np.float32, 3).astype(np.float64) @ linear.T
    a, b = edge_vertices(mesh).T
    return np.linalg.norm(positions[a] - positions[b], axis=1)


def wire_marks(mesh: bpy.types.Mesh) -> dict[tuple[int, float], int]:
    """Return the number of wire edges for each pair of id and tolerance."""
    if "wirewarp_wire" not in mesh.attributes:
        return {}
    ids = read(mesh.attributes["wirewarp_wire"].data, "value", np.int32)
    tolerances = read(mesh.attributes["wirewarp_tolerance"].data, "value", np.float32)
    keys, counts = np.unique(np.column_stack([ids, tolerances.astype(float)])[ids != 0], axis=0, return_counts=True)
    return {(int(wire), float(tolerance)): int(count) for (wire, tolerance), count in zip(keys, counts, strict=True)}


def uv_of(mesh: bpy.types.Mesh, layer: str = "WireWarp") -> np.ndarray:
    return read(mesh.uv_layers[layer].data, "uv", np.float32, 2)


def flat_sources(source: bpy.types.Object) -> np.ndarray:
    """Return the vertex of the model for each flat vertex."""
    return read(flat_of(source).data.attributes["source_vertex"].data, "value", np.int32)


def flat_places(source: bpy.types.Object) -> np.ndarray:
    """Return positions (n,2) of the flat vertices in the space of the flat object."""
    return read(flat_of(source).data.vertices, "co", np.float32, 3)[:, :2]


def world_box(target: bpy.types.Object) -> np.ndarray:
    """Return the lowest and the highest corner (2,2) of the object in the world, without z."""
    bpy.context.view_layer.update()
    corners = np.array([(target.matrix_world @ Vector(corner))[:2] for corner in target.bound_box])
    return np.array([corners.min(axis=0), corners.max(axis=0)])
