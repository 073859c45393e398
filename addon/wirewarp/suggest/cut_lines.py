# SPDX-License-Identifier: GPL-3.0-or-later
"""Cutting lines into a mesh: new edges across its faces, and new vertices on its edges. Of meshes in Object Mode.

The surface stays, and so do marks, maps and attributes: what is new gets them from what it lies on.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise

import bmesh
import bpy

from ..issues import object_error
from ..names import MARKS
from ..solve.smooth_lines import Point, SmoothLine
from ..solve.suggest import Pairs


def cut_across_faces(mesh: bpy.types.Mesh, pairs: Pairs) -> None:
    """Adds edges, given as vertex pairs, across faces of four corners."""
    with _edited(mesh) as edited:
        vertices = list(edited.verts)
        for a, b in pairs:
            first, second = vertices[a], vertices[b]
            face = next(each for each in first.link_faces if second in each.verts and len(each.verts) == 4)
            _split(edited, face, first, second)


def cut_line(mesh: bpy.types.Mesh, line: SmoothLine) -> Pairs:
    """Makes edges of the line; vertices keep their indices. Returns these edges. Raises ObjectError, with no change."""
    with _edited(mesh) as edited:
        old_vertices, old_faces = list(edited.verts), list(edited.faces)
        for polygon, pairs in line.diagonals.items():
            parts = [old_faces[polygon]]
            for a, b in pairs:
                ends = old_vertices[a], old_vertices[b]
                face = next(each for each in parts if set(ends) <= set(each.verts))
                parts.append(_split(edited, face, *ends))
        vertices = [_vertex_at(edited, old_vertices, point) for point in line.points]
        for first, second in pairwise(vertices):
            if edited.edges.get((first, second)) is None:
                face = next(each for each in first.link_faces if second in each.verts)
                _split(edited, face, first, second)
        edited.verts.index_update()
        return [(first.index, second.index) for first, second in pairwise(vertices)]


@contextmanager
def unchanged_on_error(mesh: bpy.types.Mesh) -> Iterator[None]:
    """Of several lines all are cut, or none."""
    before = bmesh.new()
    try:
        before.from_mesh(mesh)
        yield
    except Exception:
        before.to_mesh(mesh)
        mesh.update()
        raise
    finally:
        before.free()


@contextmanager
def _edited(mesh: bpy.types.Mesh) -> Iterator[bmesh.types.BMesh]:
    """Writes the mesh at the end, unless something is raised."""
    edited = bmesh.new()
    try:
        edited.from_mesh(mesh)
        yield edited
        edited.to_mesh(mesh)
    finally:
        edited.free()
    mesh.update()


def _split(
    edited: bmesh.types.BMesh, face: bmesh.types.BMFace, first: bmesh.types.BMVert, second: bmesh.types.BMVert
) -> bmesh.types.BMFace:
    """Returns the face that is new."""
    new, corner = bmesh.utils.face_split(face, first, second)
    for loop in corner.edge.link_loops:  # they are copies of corners that begin other edges
        for side in _side_layers(edited):
            loop[side] = 0.0
    return new


def _vertex_at(edited: bmesh.types.BMesh, vertices: list[bmesh.types.BMVert], point: Point) -> bmesh.types.BMVert:
    """A new one where the point is none."""
    first, second, share = point
    if first == second:
        return vertices[first]
    edge = edited.edges.get((vertices[first], vertices[second]))
    if edge is None:
        sentence = f"The smooth line would cross itself at edge {first}-{second}. Mark it along edges instead."
        raise object_error("line_crosses_itself", sentence)
    _, vertex = bmesh.utils.edge_split(edge, vertices[first], share)
    for loop in vertex.link_loops:  # it begins the second half of what the corner before it began
        for side in _side_layers(edited):
            loop[side] = loop.link_loop_prev[side]
    return vertex


def _side_layers(edited: bmesh.types.BMesh) -> list[bmesh.types.BMLayerItem]:
    layers = edited.loops.layers.float
    return [layers[mark.name] for mark in MARKS if mark.domain == "CORNER" and mark.name in layers]
