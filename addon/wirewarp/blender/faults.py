# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the faults of a mesh by kind before it is flattened, and repairs them with Blender's own tools."""

import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import bmesh
import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

from ..core import Elements, counted
from .mesh import as_bmesh

# Elements count as one if they are at most this share of the model's size apart, because files round coordinates to 5
# or 6 digits.
CLOSE = 1e-5
# The distance at which elements count as one is at least this share of the largest coordinate. Each of two vertices may
# have two rounding errors of single precision, each 1.2e-7 of a coordinate.
ROUNDED = 5e-7
Found = list[Any]  # vertices, edges and faces of the bmesh


@dataclass(frozen=True)
class Fault:
    kind: str
    one: str
    many: str
    verb: str  # first word of the button, such as "Merge"
    done: str  # participle in the message, such as "merged"
    find: Callable[[bmesh.types.BMesh, float], Found]  # float: largest distance between elements that count as one
    repair: Callable[[bmesh.types.BMesh, float, Found], object]

    def text(self, count: int) -> str:
        return counted(count, self.one, self.many)


def find_faults(mesh: bpy.types.Mesh) -> dict[str, Elements]:
    with as_bmesh(mesh) as edit:
        close = _close_distance(edit)
        found = {fault.kind: _found(fault, edit, close) for fault in FAULTS}
        return {kind: _elements(own) for kind, own in found.items() if own}


def repair_faults(mesh: bpy.types.Mesh, kinds: Sequence[str]) -> dict[str, int]:
    """Repair these kinds of faults. Return the number of repaired elements of each kind."""
    repaired = {}
    with as_bmesh(mesh) as edit:
        close = _close_distance(edit)
        for fault in FAULTS:
            found = _found(fault, edit, close) if fault.kind in kinds else []
            if not found:
                continue
            count = len(found)
            fault.repair(edit, close, found)
            left = len(_found(fault, edit, close))
            if left < count:
                repaired[fault.kind] = count - left
        if repaired:
            edit.to_mesh(mesh)
            mesh.update()
    return repaired


def _found(fault: Fault, edit: bmesh.types.BMesh, close: float) -> Found:
    """Return the elements with this fault. First update indices and normals, which earlier repairs may have changed."""
    for elements in (edit.verts, edit.edges, edit.faces):
        elements.index_update()
        elements.ensure_lookup_table()
    edit.normal_update()
    return fault.find(edit, close)


def _close_distance(edit: bmesh.types.BMesh) -> float:
    places = np.array([vertex.co for vertex in edit.verts]).reshape(-1, 3)
    if not len(places):
        return 0.0
    return max(CLOSE * float(np.ptp(places, axis=0).max()), ROUNDED * float(np.abs(places).max()))


def _elements(found: Found) -> Elements:
    return Elements(
        [each.index for each in found if isinstance(each, bmesh.types.BMVert)],
        [(each.verts[0].index, each.verts[1].index) for each in found if isinstance(each, bmesh.types.BMEdge)],
        [each.index for each in found if isinstance(each, bmesh.types.BMFace)],
    )


def _overlapping_vertices(edit: bmesh.types.BMesh, close: float) -> Found:
    return list(bmesh.ops.find_doubles(edit, verts=edit.verts, dist=close)["targetmap"])


def _merge(edit: bmesh.types.BMesh, close: float, _found: Found) -> None:
    bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=close)


def _faces_without_area(edit: bmesh.types.BMesh, close: float) -> Found:
    """Return faces whose height above their longest edge is at most `close`."""
    lengths = ((face, max(edge.calc_length() for edge in face.edges)) for face in edit.faces)
    return [face for face, longest in lengths if 2 * face.calc_area() <= close * longest]


def _dissolve(edit: bmesh.types.BMesh, close: float, _found: Found) -> None:
    bmesh.ops.dissolve_degenerate(edit, dist=close, edges=edit.edges)


def _duplicate_faces(edit: bmesh.types.BMesh, _close: float) -> Found:
    """Return the duplicate faces: of each set of faces with the same vertices, all but the first."""
    by_vertices: dict[frozenset[Any], Found] = defaultdict(list)
    for face in edit.faces:
        by_vertices[frozenset(face.verts)].append(face)
    return [face for faces in by_vertices.values() for face in faces[1:]]


def _interior_faces(edit: bmesh.types.BMesh, _close: float) -> Found:
    """Return the faces that Blender selects as Interior Faces, except faces visible from outside.

    - The faces divide space into rooms.
    - A room is open if a ray from one of its faces, along the normal, meets no other face.
    - A face is visible if one of its sides belongs to an open room.
    """
    walled = [face for face in edit.faces if all(len(edge.link_faces) > 2 for edge in face.edges)]
    if not walled:
        return []
    room_of = _rooms(edit)
    surface = BVHTree.FromBMesh(edit)
    seen = {room_of[side] for side in room_of if _leads_out(surface, edit.faces[side[0]], side[1])}
    return [face for face in walled if not {room_of[face.index, 1], room_of[face.index, -1]} & seen]


def _rooms(edit: bmesh.types.BMesh) -> dict[tuple[int, int], tuple[int, int]]:
    """Return, for each side of a face, the side that represents its room.

    A side is (face, 1) toward the normal, or (face, -1). Sides that meet at an edge are in one room.
    """
    parent = {(face.index, side): (face.index, side) for face in edit.faces for side in (1, -1)}

    def root(side: tuple[int, int]) -> tuple[int, int]:
        while parent[side] != side:
            parent[side] = parent[parent[side]]
            side = parent[side]
        return side

    for edge in edit.edges:
        around = _around(edge)
        for (face, ahead, _), (other, _, behind) in zip(around, around[1:] + around[:1], strict=True):
            parent[root((face, ahead))] = root((other, behind))
    return {side: root(side) for side in parent}


def _around(edge: bmesh.types.BMEdge) -> list[tuple[int, int, int]]:
    """Return the faces around the edge by angle, each with its sides toward the next and the previous face."""
    axis = (edge.verts[1].co - edge.verts[0].co).normalized()
    first = axis.orthogonal().normalized()
    second, faces = axis.cross(first), []
    for loop in edge.link_loops:
        runs_along = axis if loop.vert == edge.verts[0] else -axis
        inward = loop.face.normal.cross(runs_along)
        ahead = 1 if loop.face.normal.dot(axis.cross(inward)) > 0 else -1
        faces.append((math.atan2(inward.dot(second), inward.dot(first)), (loop.face.index, ahead, -ahead)))
    return [face for _, face in sorted(faces)]


def _leads_out(surface: BVHTree, face: bmesh.types.BMFace, side: int) -> bool:
    toward = side * face.normal
    above = toward * 1e-4 * face.calc_perimeter()  # so that the ray does not hit the face itself
    return surface.ray_cast(face.calc_center_median() + above, toward)[0] is None


def _delete_faces(edit: bmesh.types.BMesh, _close: float, found: Found) -> None:
    """Delete the faces, and the edges and vertices that no other face uses."""
    bmesh.ops.delete(edit, geom=found, context="FACES")


def _loose(edit: bmesh.types.BMesh, _close: float) -> Found:
    edges = [edge for edge in edit.edges if not edge.link_faces]
    return [*edges, *(vertex for vertex in edit.verts if not vertex.link_faces)]


def _delete_loose(edit: bmesh.types.BMesh, _close: float, found: Found) -> None:
    for edge in (each for each in found if isinstance(each, bmesh.types.BMEdge)):
        edit.edges.remove(edge)
    for vertex in (each for each in found if isinstance(each, bmesh.types.BMVert)):
        edit.verts.remove(vertex)


def _non_manifold_edges(edit: bmesh.types.BMesh, _close: float) -> Found:
    return [edge for edge in edit.edges if len(edge.link_faces) > 2 and not edge.seam]


def _mark_seams(_edit: bmesh.types.BMesh, _close: float, found: Found) -> None:
    for edge in found:
        edge.seam = True


def _opposed_faces(edit: bmesh.types.BMesh, _close: float) -> Found:
    """Return the faces that Recalculate Normals would flip; empty if all neighbors have matching normals."""
    if all(edge.is_contiguous for edge in edit.edges if len(edge.link_faces) == 2 and not edge.seam):
        return []
    turned = edit.copy()
    try:
        bmesh.ops.recalc_face_normals(turned, faces=turned.faces)
        turned.faces.ensure_lookup_table()
        return [face for face in edit.faces if turned.faces[face.index].normal.dot(face.normal) < 0]
    finally:
        turned.free()


def _recalculate(edit: bmesh.types.BMesh, _close: float, _found: Found) -> None:
    bmesh.ops.recalc_face_normals(edit, faces=edit.faces)


FAULTS = (  # in the order of repair: merging creates zero-area and duplicate faces, and deleting leaves loose edges
    Fault("MERGE", "overlapping vertex", "overlapping vertices", "Merge", "merged", _overlapping_vertices, _merge),
    Fault("DISSOLVE", "zero-area face", "zero-area faces", "Dissolve", "dissolved", _faces_without_area, _dissolve),
    Fault("DUPLICATES", "duplicate face", "duplicate faces", "Delete", "deleted", _duplicate_faces, _delete_faces),
    Fault("INTERIOR", "interior face", "interior faces", "Delete", "deleted", _interior_faces, _delete_faces),
    Fault("LOOSE", "loose edge or vertex", "loose edges and vertices", "Delete", "deleted", _loose, _delete_loose),
    Fault(
        "NON_MANIFOLD",
        "edge of three or more faces",
        "edges of three or more faces",
        "Mark as Seams",
        "marked as seams",
        _non_manifold_edges,
        _mark_seams,
    ),
    Fault("NORMALS", "flipped face", "flipped faces", "Flip", "flipped", _opposed_faces, _recalculate),
)
