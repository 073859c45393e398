# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a mesh with its wires and ids as arrays, in either mode: everything that flat pieces depend on."""

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
    """Return whether our attributes exist with our types."""
    present = [each for each in OF_WIRES if each.name in mesh.attributes]
    return WIRE in present and has_attributes(mesh, *present)


def read_marks(mesh: bpy.types.Mesh) -> EdgeMarks:
    """Return the marks of a mesh that is not in Edit Mode."""
    check_attributes(mesh)
    return EdgeMarks(*(read_values(mesh, each) for each in OF_WIRES))


def write_marks(mesh: bpy.types.Mesh, marks: EdgeMarks) -> None:
    """Write the marks to a mesh that is not in Edit Mode."""
    write_values(mesh, WIRE, marks.wire_ids)
    write_values(mesh, TOLERANCE, marks.tolerances)
    write_marked(mesh, EASE, marks.eases)
    mesh.update()


def wires_on(mesh: bpy.types.Mesh) -> list[int]:
    """Return the ids of a mesh that is not in Edit Mode, in its order."""
    marks = read_marks(mesh)
    return list(dict.fromkeys(marks.wire_ids[marks.rows].tolist()))


def own_ids(wire_ids: Sequence[int]) -> list[int]:
    """Return an id for each wire. Copied or cut wires share an id: the first wire keeps it. The others get the next
    unused numbers, so that the result is deterministic."""
    taken, own = set(wire_ids), dict[int, None]()
    for wire_id in wire_ids:
        free = wire_id
        while free in own or (free != wire_id and free in taken):
            free = free % MAX_ID + 1
        own[free] = None
    return list(own)


def check_id_room(target: bpy.types.Object) -> None:
    """Raises ObjectError if the ids of pieces and seams cannot be written to the object's mesh."""
    check_room(target, PIECE, "the id of pieces")
    check_room(target, SEAM, "the id of seams")


def read_ids(mesh: bpy.types.Mesh, attribute: Attribute) -> np.ndarray:
    """Return the ids of a mesh that is not in Edit Mode: PIECE (f,), SEAM (e,), int32, 0 none. Raises ObjectError."""
    check_attribute(mesh, attribute)
    return read_values(mesh, attribute)


@dataclass(frozen=True)
class MarkedMesh:
    places: np.ndarray  # (n,3) float32, in the mesh's own space
    edges: np.ndarray  # (e,2) int32
    corner_vertices: np.ndarray  # (l,) int32
    corner_edges: np.ndarray  # (l,) int32, the edge from each corner to the next of its face
    face_sizes: np.ndarray  # (f,) int32
    seams: np.ndarray  # (e,) bool
    marks: EdgeMarks  # (e,)
    side_eases: np.ndarray  # (l,) float32, of the edge that begins at each corner, on the side of its face; 0 none


def read_marked(mesh: bpy.types.Mesh) -> MarkedMesh:
    """Read a mesh that is not in Edit Mode. Raises ObjectError if others made an attribute with one of our names."""
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
    """Return the object's own mesh as read_marked does, but in either mode. take: read_anew, or kept."""

    def gather(_mesh: bpy.types.Mesh) -> MarkedMesh:
        with current_mesh(target) as mesh:
            return read_marked(mesh)

    # Outside Edit Mode reading is fast, so nothing is kept.
    return take(target.data, "marked mesh", gather) if target.data.is_editmode else gather(target.data)
