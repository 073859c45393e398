# SPDX-License-Identifier: GPL-3.0-or-later
"""The face attribute that says which piece a face is of: wirewarp_piece INT, the random 31-bit id, 0 none.

It stays with the faces when they are subdivided, duplicated or joined, so that a piece keeps its name and its place.
"""

import bpy
import numpy as np

from ..blender.attributes import check_attribute, check_room
from ..names import PIECE


def check_piece_room(target: bpy.types.Object) -> None:
    """Raises ObjectError where the ids cannot be written to the object's mesh."""
    check_room(target, PIECE, "INT", "FACE", "what tells pieces apart")


def read_piece_ids(mesh: bpy.types.Mesh) -> np.ndarray:
    """(f,) int32 of a mesh that is not in Edit Mode."""
    check_attribute(mesh, PIECE, "INT", "FACE")
    ids = np.zeros(len(mesh.polygons), dtype=np.int32)
    if PIECE in mesh.attributes:
        mesh.attributes[PIECE].data.foreach_get("value", ids)
    return ids


def write_piece_ids(mesh: bpy.types.Mesh, ids: np.ndarray) -> None:
    """ids (f,) int32."""
    attribute = mesh.attributes.get(PIECE) or mesh.attributes.new(PIECE, "INT", "FACE")
    attribute.data.foreach_set("value", ids)
