# SPDX-License-Identifier: GPL-3.0-or-later
"""The helper wires as two objects of edges alone, one on the model and one on the flat pieces, that move with them.

Blender itself does not show the objects: as thin lines in a surface they would be seen in part, or through it.
"""

import bpy
import numpy as np

from .helper_lines import HelperLines
from .mesh_to_arrays import linear_part


def write_helper_wires(
    collection: bpy.types.Collection, source: bpy.types.Object, flat: bpy.types.Object, lines: HelperLines
) -> None:
    """Makes or replaces both objects; without any helper wire they are removed."""
    if not len(lines.edges):
        remove_helper_wires(source, flat)
        return
    local = lines.on_model @ np.linalg.inv(linear_part(source)).T
    plane = np.column_stack([lines.on_pieces, np.zeros(len(lines.on_pieces))])
    for owner, points in ((source, local), (flat, plane)):
        target = find_helper_wires(owner) or _new_object(collection, owner)
        _write_mesh(target.data, points, lines)


def remove_helper_wires(*owners: bpy.types.Object) -> None:
    for owner in owners:
        target = find_helper_wires(owner)
        if target:
            bpy.data.meshes.remove(target.data)  # and with it the object


def find_helper_wires(owner: bpy.types.Object) -> bpy.types.Object | None:
    return next((candidate for candidate in bpy.data.objects if candidate.wirewarp_helpers_of == owner), None)


def _new_object(collection: bpy.types.Collection, owner: bpy.types.Object) -> bpy.types.Object:
    name = f"{owner.name} Helper Wires"
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
