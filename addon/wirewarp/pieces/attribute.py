# SPDX-License-Identifier: GPL-3.0-or-later
"""The face attribute that says which piece a face is of: wirewarp_piece INT, the random 31-bit id, 0 none.

It stays with the faces when they are subdivided, duplicated or joined, so that a piece keeps its name and its place.
"""

import bpy
import numpy as np

from ..issues import object_error

PIECE = "wirewarp_piece"


def check_piece_attribute(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    attribute = mesh.attributes.get(PIECE)
    if attribute and (attribute.domain, attribute.data_type) != ("FACE", "INT"):
        raise object_error(
            "attribute_type",
            f'The attribute "{PIECE}" of mesh "{mesh.name}" is not of type INT on faces: '
            "rename or delete it under Object Data > Attributes.",
        )


def read_piece_ids(mesh: bpy.types.Mesh) -> np.ndarray:
    """(f,) int32 of a mesh that is not in Edit Mode."""
    check_piece_attribute(mesh)
    ids = np.zeros(len(mesh.polygons), dtype=np.int32)
    if PIECE in mesh.attributes:
        mesh.attributes[PIECE].data.foreach_get("value", ids)
    return ids


def write_piece_ids(mesh: bpy.types.Mesh, ids: np.ndarray) -> None:
    """ids (f,) int32."""
    if PIECE not in mesh.attributes:
        mesh.attributes.new(PIECE, "INT", "FACE")
    mesh.attributes[PIECE].data.foreach_set("value", ids)
