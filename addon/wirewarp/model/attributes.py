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

from ..blender.attributes import check_attribute, check_room
from ..blender.mesh import read_attribute
from ..names import EASE, PIECE, SEAM, TOLERANCE, WIRE
from ..pattern.chains import EdgeMarks
from ..solve.identity import MAX_ID

_EXPECTED = {WIRE: "INT", TOLERANCE: "FLOAT", EASE: "FLOAT"}
_ID_DOMAINS = {PIECE: "FACE", SEAM: "EDGE"}


def check_attributes(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    for name, data_type in _EXPECTED.items():
        check_attribute(mesh, name, data_type, "EDGE")


def has_marks(mesh: bpy.types.Mesh) -> bool:
    """Whether our attributes are there and are ours."""
    kinds = {name: mesh.attributes[name] for name in _EXPECTED if name in mesh.attributes}
    ours = all((kind.domain, kind.data_type) == ("EDGE", _EXPECTED[name]) for name, kind in kinds.items())
    return WIRE in kinds and ours


def read_marks(mesh: bpy.types.Mesh) -> EdgeMarks:
    """The marks of a mesh that is not in Edit Mode."""
    check_attributes(mesh)
    marks = EdgeMarks.none(len(mesh.edges))
    if WIRE in mesh.attributes:
        mesh.attributes[WIRE].data.foreach_get("value", marks.wire_ids)
    for name, values in ((TOLERANCE, marks.tolerances), (EASE, marks.eases)):
        if name in mesh.attributes:
            mesh.attributes[name].data.foreach_get("value", values)
    return marks


def write_marks(mesh: bpy.types.Mesh, marks: EdgeMarks) -> None:
    """To a mesh that is not in Edit Mode."""
    eases = [(EASE, marks.eases)] if EASE in mesh.attributes or marks.eases.any() else []
    for name, values in ((WIRE, marks.wire_ids), (TOLERANCE, marks.tolerances), *eases):
        attribute = mesh.attributes.get(name) or mesh.attributes.new(name, _EXPECTED[name], "EDGE")
        attribute.data.foreach_set("value", values)
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
    if WIRE not in layers.int:
        layers.int.new(WIRE)
    if TOLERANCE not in layers.float:
        layers.float.new(TOLERANCE)
    return edit, layers.int[WIRE], layers.float[TOLERANCE], layers.float.get(EASE)


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
    check_room(target, PIECE, "INT", _ID_DOMAINS[PIECE], "what tells pieces apart")
    check_room(target, SEAM, "INT", _ID_DOMAINS[SEAM], "what tells seams apart")


def read_ids(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    """name PIECE: (f,), SEAM: (e,) int32, 0 none, of a mesh that is not in Edit Mode. Raises ObjectError."""
    domain = _ID_DOMAINS[name]
    check_attribute(mesh, name, "INT", domain)
    ids = read_attribute(mesh, name, "INT", domain)
    return np.zeros(len(mesh.edges if domain == "EDGE" else mesh.polygons), dtype=np.int32) if ids is None else ids


def write_ids(mesh: bpy.types.Mesh, name: str, ids: np.ndarray) -> None:
    """As read_ids; to a mesh that is not in Edit Mode."""
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, "INT", _ID_DOMAINS[name])
    attribute.data.foreach_set("value", ids)
