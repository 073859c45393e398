# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks the fitted top as readers of the tutorials do, for the tours of take_pictures.py."""

from collections.abc import Callable, Collection

import bmesh
import bpy
import drive
from mathutils import Vector

HIP = 0.075  # meters: approximate height of the hip line above the hem
OWN_WIRES = {"Bust line", "Waist line", "Center front"}  # the sample's wires that readers of garment.md mark, too


def select_edges(wanted: Callable[[Vector, Vector], bool]) -> None:
    """Select edges in Edit Mode. wanted: returns whether to select the edge with these two ends."""
    _select(lambda edge: wanted(*(vertex.co for vertex in edge.verts)))


def select_by_vertices(wanted: Callable[[frozenset[int]], bool]) -> None:
    """Select edges in Edit Mode. wanted: returns whether to select the edge between the vertices of these indices."""
    _select(lambda edge: wanted(frozenset(vertex.index for vertex in edge.verts)))


def _select(wanted: Callable[[bmesh.types.BMEdge], bool]) -> None:
    source = bpy.context.view_layer.objects.active
    with drive.in_view():
        if source.mode != "EDIT":
            bpy.ops.object.mode_set(mode="EDIT")
        bpy.context.tool_settings.mesh_select_mode = (False, True, False)
        bpy.ops.mesh.select_all(action="DESELECT")
    edit = bmesh.from_edit_mesh(source.data)
    for edge in edit.edges:
        edge.select = wanted(edge)
    edit.select_flush_mode()
    bmesh.update_edit_mesh(source.data)


def mark_hip_line() -> None:
    """Mark the line around the hip and name it, as readers of the tutorials do. Blender stays in Edit Mode."""
    hip = near_level(HIP)
    select_edges(lambda a, b: max(abs(a.z - hip), abs(b.z - hip)) < 0.001)
    with drive.in_view():
        bpy.ops.mesh.wirewarp_mark("INVOKE_DEFAULT", kind="ELASTIC")
        bpy.ops.mesh.select_all(action="DESELECT")
    names = bpy.context.object.data.wirewarp_names
    names[len(names) - 1].name = "Hip line"


def leave_edit_mode() -> None:
    with drive.in_view():
        bpy.ops.object.mode_set(mode="OBJECT")


def near_level(height: float) -> float:
    """Return the height of the mesh line nearest to this height."""
    return min((vertex.co.z for vertex in bpy.context.object.data.vertices), key=lambda z: abs(z - height))


def mark_garment() -> None:
    """Mark the wires that readers of garment.md mark, and no other wires. They mark the same seams as the sample."""
    clear_wires(OWN_WIRES)
    mark_hip_line()
    leave_edit_mode()


def clear_wires(kept: Collection[str] = ()) -> None:
    """Clear all wires of the sample, except for wires with these names."""
    mesh = bpy.context.object.data
    cleared = {wire.wire_id for wire in mesh.wirewarp_names if wire.name not in kept}
    wire_at = {
        frozenset(edge.vertices): wire.value
        for edge, wire in zip(mesh.edges, mesh.attributes["wirewarp_wire"].data, strict=True)
    }
    select_by_vertices(lambda ends: wire_at[ends] in cleared)
    with drive.in_view():
        bpy.ops.mesh.wirewarp_clear()
    leave_edit_mode()


def ease_sleeves() -> None:
    """Make the sleeves' sides of the armhole seams 4% longer, in a flattened model."""
    mesh = bpy.context.object.data
    piece = [each.value for each in mesh.attributes["wirewarp_piece"].data]
    sleeves = sorted(set(piece), key=piece.count)[:2]  # the pieces with the fewest faces
    sides: dict[frozenset[int], list[bool]] = {}
    for face in mesh.polygons:
        for ends in face.edge_keys:
            sides.setdefault(frozenset(ends), []).append(piece[face.index] in sleeves)
    select_by_vertices(lambda ends: len(set(sides[ends])) == 2)
    with drive.in_view():
        bpy.ops.mesh.wirewarp_ease(sides="ONE", ease_percent=4.0)
    leave_edit_mode()


def clear_sleeve_seam(mesh: bpy.types.Mesh) -> None:
    """Clear the seam of the left sleeve from the cuff to the armhole."""
    edit = bmesh.new()
    edit.from_mesh(mesh)
    cuff = max((v for v in edit.verts if v.is_boundary and seams_at(v)), key=lambda vertex: vertex.co.x)
    while len(seams_at(cuff)) == 1:
        (edge,) = seams_at(cuff)
        edge.seam = False
        cuff = edge.other_vert(cuff)
    edit.to_mesh(mesh)
    edit.free()


def seams_at(vertex: bmesh.types.BMVert) -> list[bmesh.types.BMEdge]:
    return [edge for edge in vertex.link_edges if edge.seam]
