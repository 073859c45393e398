# SPDX-License-Identifier: GPL-3.0-or-later
"""The helper wires of a flattening: objects of edges on the model and on the flat pieces."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np
from bpy.app.handlers import persistent

from ..blender.mesh import edge_vertices, read, read_attribute
from ..blender.objects import linear_part, remove_object
from ..model.owners import find_helper_wires, helper_name, is_helper
from ..solve.places import Motion
from .uv import UvFrame

IN_MAP = "in_map"  # point attribute of the object on the model: the place in the UV layer


@dataclass(frozen=True)
class HelperLines:
    """Point k on the model is point k on the pieces. Helper wires number through all pieces, as in the report."""

    on_model: np.ndarray  # (n,3) float64, Blender units, the object's rotation, scale and shear applied
    on_pieces: np.ndarray  # (n,2) float64, where the pieces lie
    as_packed: np.ndarray  # (n,2) float64, where the library has laid them, as in the UV layer
    edges: np.ndarray  # (k,2) int32
    helper: np.ndarray  # (k,) int32, helper wire of each edge


def helper_lines(result: Any, motions: Sequence[Motion]) -> HelperLines:  # noqa: ANN401
    """Of all pieces of a FlattenResult that have a layout; motions: one per piece, to where it lies."""
    wires = [
        (wire.points_3d, motion(wire.points_2d), wire.points_2d)
        for piece, motion in zip(result.pieces, motions, strict=True)
        for wire in piece.helper_wires
        if np.isfinite(wire.points_2d).all()
    ]
    sizes = np.array([len(points) for points, *_ in wires], dtype=np.int32)
    on_model, on_pieces, as_packed = (
        np.concatenate([np.empty((0, columns)), *(wire[part] for wire in wires)])
        for part, columns in enumerate((3, 2, 2))
    )
    last = np.cumsum(sizes) - 1
    first = np.delete(np.arange(sizes.sum(), dtype=np.int32), last)  # every point but the last of each wire
    return HelperLines(
        on_model=on_model,
        on_pieces=on_pieces,
        as_packed=as_packed,
        edges=np.column_stack([first, first + 1]).astype(np.int32),
        helper=np.repeat(np.arange(len(wires), dtype=np.int32), sizes - 1),
    )


def write_helper_wires(
    collection: bpy.types.Collection,
    source: bpy.types.Object,
    flat: bpy.types.Object,
    lines: HelperLines,
    uv_frame: UvFrame | None,
) -> None:
    """Makes or replaces both objects; without any helper wire they are removed. uv_frame: of the map, if written."""
    if not len(lines.edges):
        remove_helper_wires(source, flat)
        return
    local = lines.on_model @ np.linalg.inv(linear_part(source)).T
    for owner, points in ((source, local), (flat, _in_space(lines.on_pieces))):
        target = find_helper_wires(owner) or _new_object(collection, owner)
        _write_mesh(target.data, points, lines)
    if uv_frame:
        in_map = _in_space(uv_frame(lines.as_packed)).astype(np.float32)
        attribute = find_helper_wires(source).data.attributes.new(IN_MAP, "FLOAT_VECTOR", "POINT")
        attribute.data.foreach_set("vector", in_map.ravel())


def remove_helper_wires(*owners: bpy.types.Object) -> None:
    for owner in owners:
        target = find_helper_wires(owner)
        if target:
            remove_object(target)


def helper_ends(owner: bpy.types.Object) -> np.ndarray | None:
    """(2k,3) float32, the ends of all edges of helper wires; None if there are none."""
    helpers = find_helper_wires(owner)
    return read(helpers.data.vertices, "co", np.float32, 3)[_edge_vertices(helpers.data)] if helpers else None


def helper_ends_in_map(model: bpy.types.Object) -> np.ndarray | None:
    """The same in the model's UV layer; None where that is not of the same run."""
    helpers = find_helper_wires(model)
    is_read = helpers and not helpers.data.is_editmode  # in Edit Mode Blender hides attributes
    places = read_attribute(helpers.data, IN_MAP, "FLOAT_VECTOR", "POINT") if is_read else None
    return None if places is None else places[_edge_vertices(helpers.data)]


def _edge_vertices(mesh: bpy.types.Mesh) -> np.ndarray:
    return edge_vertices(mesh).ravel()


def _in_space(points: np.ndarray) -> np.ndarray:
    """(n,2) to (n,3)"""
    return np.column_stack([points, np.zeros(len(points))])


def _new_object(collection: bpy.types.Collection, owner: bpy.types.Object) -> bpy.types.Object:
    name = helper_name(owner.name)
    target = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    target.wirewarp_helpers_of = target.parent = owner
    target.hide_viewport = target.hide_select = target.hide_render = True  # the overlay draws them
    collection.objects.link(target)
    return target


def _write_mesh(mesh: bpy.types.Mesh, points: np.ndarray, lines: HelperLines) -> None:
    mesh.clear_geometry()
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", points.astype(np.float32).ravel())
    mesh.edges.add(len(lines.edges))
    mesh.edges.foreach_set("vertices", lines.edges.ravel())
    mesh.attributes.new("helper_wire", "INT", "EDGE").data.foreach_set("value", lines.helper)
    mesh.update(calc_edges_loose=True)  # or Blender 3.4 draws none, should the user unhide them


@persistent
def _drop(*_: object) -> None:
    for target in [each for each in bpy.data.objects if is_helper(each) and _is_gone(each.wirewarp_helpers_of)]:
        if target.library is None:
            remove_object(target)


def _is_gone(owner: bpy.types.Object) -> bool:
    return not (owner.users_collection or owner.use_fake_user)


def attach() -> None:
    bpy.app.handlers.save_pre.append(_drop)


def detach() -> None:
    bpy.app.handlers.save_pre.remove(_drop)
