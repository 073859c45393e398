# SPDX-License-Identifier: GPL-3.0-or-later
"""The helper wires as two objects of edges alone, one on the model and one on the flat pieces, that move with them.

Blender itself does not show the objects: as thin lines in a surface they would be seen in part, or through it.
"""

import bpy
import numpy as np

from .foreach import read, read_attribute
from .helper_lines import HelperLines
from .mesh_to_arrays import linear_part
from .mesh_topology import edge_vertices
from .owners import find_helper_wires, helper_name
from .remove_object import remove_object
from .write_uv import UvFrame

IN_MAP = "in_map"  # point attribute of the object on the model: the place in the UV layer


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
