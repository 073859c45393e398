# SPDX-License-Identifier: GPL-3.0-or-later
"""The attributes of a flat mesh that say what its elements are of the model. Users may have deleted or changed them."""

import bpy
import numpy as np

from .foreach import read, read_attribute
from .pieces.attribute import PIECE

DOMAINS = {  # all INT
    "source_vertex": "POINT",
    "source_corner": "CORNER",
    "source_face": "FACE",
    "piece": "FACE",  # its index in the report
    PIECE: "FACE",
}


def add_flat_attribute(mesh: bpy.types.Mesh, name: str, values: np.ndarray) -> None:
    """To a mesh that has none of this name; values (k,) int32."""
    mesh.attributes.new(name, "INT", DOMAINS[name]).data.foreach_set("value", values)


def read_flat_attribute(mesh: bpy.types.Mesh, name: str) -> np.ndarray | None:
    """(k,) int32, any numbers; None if it is not there as it was written. Of a mesh that is not in Edit Mode."""
    return read_attribute(mesh, name, "INT", DOMAINS[name])


def has_flat_attributes(mesh: bpy.types.Mesh, *names: str) -> bool:
    return all(read_flat_attribute(mesh, name) is not None for name in names)


def is_flat_mesh(mesh: bpy.types.Mesh) -> bool:
    """Whether it holds flat pieces and nothing else, whatever became of their model. Of one not in Edit Mode."""
    is_level = not read(mesh.vertices, "co", np.float32, 3)[:, 2].any()
    return len(mesh.polygons) > 0 and is_level and has_flat_attributes(mesh, *DOMAINS)
