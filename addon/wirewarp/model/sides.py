# SPDX-License-Identifier: GPL-3.0-or-later
"""What is marked of one side of an edge alone: its seam allowance, its ease.

A value on the face's corner, as scripts may write it, is blended when the edge is split, and comes to lie on another
edge when the face is turned over or mirrored. What is on edges and faces goes with them whole. So the side that differs
is the one of the face whose number (wirewarp_face INT, random, 0 none) is on the edge, and its value lies on the edge.
"""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import check_attribute
from ..blender.mesh import corner_edges, face_sizes, read_attribute
from ..names import FACE


@dataclass(frozen=True)
class SideNames:
    """Where one kind of value is stored."""

    value: str  # FLOAT, on edges: of the side that differs
    side: str  # INT, on edges: the number of the face on that side, 0 none
    corner: str  # FLOAT, on corners: as scripts may write it

    @property
    def kinds(self) -> dict[str, tuple[str, str]]:
        """Type and domain by name."""
        return {
            self.value: ("FLOAT", "EDGE"),
            self.side: ("INT", "EDGE"),
            FACE: ("INT", "FACE"),
            self.corner: ("FLOAT", "CORNER"),
        }


def check_sides(mesh: bpy.types.Mesh, names: SideNames) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    for name, (data_type, domain) in names.kinds.items():
        check_attribute(mesh, name, data_type, domain)


def is_set(values: np.ndarray) -> np.ndarray:
    return np.isfinite(values) & (values != 0)


def values_at_edges(mesh: bpy.types.Mesh, names: SideNames) -> np.ndarray:
    """(l,) what lies on the edge that begins at each corner, if on the side of its face; 0 where nothing does.

    Of a mesh that is not in Edit Mode.
    """
    loop_edges, sides = corner_edges(mesh), read_values(mesh, names.side, "INT", "EDGE")
    of_loop = sides[loop_edges]
    numbers = np.repeat(read_values(mesh, FACE, "INT", "FACE"), face_sizes(mesh))
    values = read_values(mesh, names.value, "FLOAT", "EDGE")[loop_edges]
    return np.where((of_loop != 0) & (of_loop == numbers), values, 0)


def read_values(mesh: bpy.types.Mesh, name: str, data_type: str, domain: str) -> np.ndarray:
    """Zeros where there is no such attribute."""
    found = read_attribute(mesh, name, data_type, domain)
    if found is not None:
        return found
    count = {"EDGE": len(mesh.edges), "FACE": len(mesh.polygons), "CORNER": len(mesh.loops)}[domain]
    return np.zeros(count, dtype=np.int32 if data_type == "INT" else np.float32)


def write_values(mesh: bpy.types.Mesh, name: str, values: np.ndarray, data_type: str, domain: str) -> None:
    """Where there is no such attribute zeros make none."""
    if name not in mesh.attributes and values.any():
        mesh.attributes.new(name, data_type, domain)
    if name in mesh.attributes:
        mesh.attributes[name].data.foreach_set("value", values)
