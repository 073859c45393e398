# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads from a mesh, as arrays, the data on which its flat pieces depend, and writes wires and ids."""

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import check_attribute, check_room, has_attributes, read_values, write_marked, write_values
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    current_mesh,
    edge_vertices,
    face_sizes,
    read_seams,
    vertex_places,
)
from ..names import EASE, PIECE, SEAM, TOLERANCE, WIRE, Attribute
from ..solve.chains import EdgeMarks
from ..solve.identity import MAX_ID
from .allowances import SIDE_EASES
from .memory import Take, read_anew

OF_WIRES = (WIRE, TOLERANCE, EASE)


def check_attributes(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute with one of our names has another type or domain."""
    for attribute in OF_WIRES:
        check_attribute(mesh, attribute)


def has_marks(mesh: bpy.types.Mesh) -> bool:
    """Return whether the mesh has wires, and our attributes have our types and domains."""
    present = [each for each in OF_WIRES if each.name in mesh.attributes]
    return WIRE in present and has_attributes(mesh, *present)


def read_marks(mesh: bpy.types.Mesh) -> EdgeMarks:
    """Return the marks of a mesh that is not in Edit Mode. Raises ObjectError like check_attributes."""
    check_attributes(mesh)
    return EdgeMarks(*(read_values(mesh, each) for each in OF_WIRES))


def write_marks(mesh: bpy.types.Mesh, marks: EdgeMarks) -> None:
    """Write the marks to a mesh that is not in Edit Mode."""
    write_values(mesh, WIRE, marks.wire_ids)
    write_values(mesh, TOLERANCE, marks.tolerances)
    write_marked(mesh, EASE, marks.eases)
    mesh.update()


def wires_on(mesh: bpy.types.Mesh) -> list[int]:
    """Return the wire ids on a mesh that is not in Edit Mode, in the order of the edges."""
    marks = read_marks(mesh)
    return list(dict.fromkeys(marks.wire_ids[marks.rows].tolist()))


def own_ids(wire_ids: Sequence[int]) -> list[int]:
    """Return a separate id for each wire. If wires share an id, because a wire was copied or cut, the first wire keeps
    the id. The others get the next unused numbers, so that the result is deterministic."""
    taken, own = set(wire_ids), dict[int, None]()
    for wire_id in wire_ids:
        free = wire_id
        while free in own or (free != wire_id and free in taken):
            free = free % MAX_ID + 1
        own[free] = None
    return list(own)


def check_id_room(target: bpy.types.Object) -> None:
    check_room(target, PIECE, "the id of pieces")
    check_room(target, SEAM, "the id of seams")


def read_ids(mesh: bpy.types.Mesh, attribute: Attribute) -> np.ndarray:
    """Return the ids on a mesh that is not in Edit Mode, int32, 0 for none.

    attribute: PIECE for faces (f,), or SEAM for edges (e,)
    Raises ObjectError if it has another type or domain.
    """
    check_attribute(mesh, attribute)
    return read_values(mesh, attribute)


@dataclass(frozen=True)
class MarkedMesh:
    places: np.ndarray  # (n,3) float32, places of the vertices in the mesh's own space
    edges: np.ndarray  # (e,2) int32, vertices of the edges
    corner_vertices: np.ndarray  # (l,) int32, the vertex of each corner
    corner_edges: np.ndarray  # (l,) int32, the edge from each corner to the next corner of its face
    face_sizes: np.ndarray  # (f,) int32, number of corners of each face
    seams: np.ndarray  # (e,) bool, whether each edge is a seam
    marks: EdgeMarks  # (e,)
    side_eases: np.ndarray  # (l,) float32, ease of the edge from each corner, on the side of the corner's face; 0: none


def read_marked(mesh: bpy.types.Mesh) -> MarkedMesh:
    """Return the data of a mesh that is not in Edit Mode. Raises ObjectError like check_attributes."""
    return MarkedMesh(
        vertex_places(mesh),
        edge_vertices(mesh),
        corner_vertices(mesh),
        corner_edges(mesh),
        face_sizes(mesh),
        read_seams(mesh),
        read_marks(mesh),
        SIDE_EASES.read(mesh),
    )


def marked_mesh(target: bpy.types.Object, take: Take = read_anew) -> MarkedMesh:
    """Return the data of the object's own mesh like read_marked, in Edit Mode, too. take: read_anew or kept."""

    def gather(_mesh: bpy.types.Mesh) -> MarkedMesh:
        with current_mesh(target) as mesh:
            return read_marked(mesh)

    # Outside Edit Mode, reading is fast, so nothing is kept.
    return take(target.data, "marked mesh", gather) if target.data.is_editmode else gather(target.data)
