# SPDX-License-Identifier: GPL-3.0-or-later
"""Our attributes on the model's mesh: which edges are wires, the only truth about wires; which piece a face is of, and
which seam an edge.

wirewarp_wire INT: random 31-bit id of the wire, 0 on edges that are no wire. wirewarp_tolerance FLOAT: 0 rigid, finite
elastic, inf super-elastic. wirewarp_ease FLOAT: by how much the wire is to be longer, 0.05 is 5%; absent where no wire
is. wirewarp_piece INT, on faces: random 31-bit id of the piece, 0 none; it stays with the faces
when they are subdivided, duplicated or joined, so that a piece keeps its name and its place. wirewarp_seam INT, on
edges: the same of seams.
"""

from collections.abc import Sequence

import bmesh
import bpy
import numpy as np

from ..blender.attributes import check_attribute, check_room, has_attributes, read_values, write_marked, write_values
from ..names import EASE, PIECE, SEAM, TOLERANCE, WIRE, Attribute
from ..pattern.chains import EdgeMarks
from ..solve.identity import MAX_ID

OF_WIRES = (WIRE, TOLERANCE, EASE)


def check_attributes(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    for attribute in OF_WIRES:
        check_attribute(mesh, attribute)


def has_marks(mesh: bpy.types.Mesh) -> bool:
    """Whether our attributes are there and are ours."""
    present = [each for each in OF_WIRES if each.name in mesh.attributes]
    return WIRE in present and has_attributes(mesh, *present)


def read_marks(mesh: bpy.types.Mesh) -> EdgeMarks:
    """The marks of a mesh that is not in Edit Mode."""
    check_attributes(mesh)
    return EdgeMarks(*(read_values(mesh, each) for each in OF_WIRES))


def write_marks(mesh: bpy.types.Mesh, marks: EdgeMarks) -> None:
    """To a mesh that is not in Edit Mode."""
    write_values(mesh, WIRE, marks.wire_ids)
    write_values(mesh, TOLERANCE, marks.tolerances)
    write_marked(mesh, EASE, marks.eases)
    mesh.update()


def wires_on(mesh: bpy.types.Mesh) -> list[int]:
    """The ids of a mesh that is not in Edit Mode, in its order."""
    marks = read_marks(mesh)
    return list(dict.fromkeys(marks.wire_ids[marks.rows].tolist()))


def edit_layers(mesh: bpy.types.Mesh) -> tuple:
    """(bmesh, wire layer, tolerance layer, ease layer) of a mesh in Edit Mode; missing layers are made.

    But for that of eases, which is None where no wire has had one.

    Making a layer invalidates every edge reference taken before. Attributes of our names are ours: check_attributes.
    """
    edit = bmesh.from_edit_mesh(mesh)
    layers = edit.edges.layers
    if WIRE.name not in layers.int:
        layers.int.new(WIRE.name)
    if TOLERANCE.name not in layers.float:
        layers.float.new(TOLERANCE.name)
    return edit, layers.int[WIRE.name], layers.float[TOLERANCE.name], layers.float.get(EASE.name)


def own_ids(wire_ids: Sequence[int]) -> list[int]:
    """An id for each wire, its own where it is the first with that: a wire that was copied or cut in two has several.

    The others get the next number that is no wire's; the same ones each time.
    """
    taken, own = set(wire_ids), dict[int, None]()
    for wire_id in wire_ids:
        free = wire_id
        while free in own or (free != wire_id and free in taken):
            free = free % MAX_ID + 1
        own[free] = None
    return list(own)


def check_id_room(target: bpy.types.Object) -> None:
    """Raises ObjectError where the ids of pieces and seams cannot be written to the object's mesh."""
    check_room(target, PIECE, "the id of pieces")
    check_room(target, SEAM, "the id of seams")


def read_ids(mesh: bpy.types.Mesh, attribute: Attribute) -> np.ndarray:
    """PIECE: (f,), SEAM: (e,) int32, 0 none, of a mesh that is not in Edit Mode. Raises ObjectError."""
    check_attribute(mesh, attribute)
    return read_values(mesh, attribute)
