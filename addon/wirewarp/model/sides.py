# SPDX-License-Identifier: GPL-3.0-or-later
"""What is marked of one side of an edge alone: its seam allowance, its ease.

A value on the face's corner, as scripts may write it, is blended when the edge is split, and comes to lie on another
edge when the face is turned over or mirrored. What is on edges and faces goes with them whole. So the side that differs
is the one of the face whose number (wirewarp_face INT, random, 0 none) is on the edge, and its value lies on the edge.

A face that is cut, copied or extruded gives its number to others. That does no harm where one face of an edge alone has
it: so faces get numbers of their own before a side is marked, and of an edge where several have its number, or none of
several, it cannot be told which side was meant.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import check_attribute
from ..blender.mesh import corner_edges, edge_vertices, face_sizes, faces_at_edges, read_attribute
from ..issues import Issue, ObjectError
from ..names import EASED_SIDE, FACE, SIDE
from ..solve.identity import new_id
from ..words import counted


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
    marked, counts = _marked_corners(mesh, names.side)
    loop_edges = corner_edges(mesh)
    values = read_values(mesh, names.value, "FLOAT", "EDGE")[loop_edges]
    return np.where(marked & (counts[loop_edges] == 1), values, 0)


def check_sides_told(mesh: bpy.types.Mesh, names: SideNames, what: str, *, has_modifiers: bool = False) -> None:
    """Raises ObjectError where it cannot be told of which side something is.

    what: "ease", as a sentence calls it. An edge of a single face that is not the one has lost it with that face.
    has_modifiers: the mesh is what they made; a Mirror that merges its middle has the same face on both sides there.
    """
    _, counts = _marked_corners(mesh, names.side)
    sides, values = read_values(mesh, names.side, "INT", "EDGE"), read_values(mesh, names.value, "FLOAT", "EDGE")
    lost = np.flatnonzero((sides != 0) & is_set(values) & (counts != 1) & (faces_at_edges(mesh) > 1))
    if len(lost):
        why, first = "faces there were copied or replaced", "Mark it again"
        if has_modifiers:
            why, first = "modifiers copied or replaced faces there", "Apply them and mark it again"
        raise ObjectError(
            Issue(
                "side_unknown",
                f'{counted(len(lost), "edge")} of "{mesh.name}" with an {what} of one side: which side that is '
                f"cannot be told, for {why}. {first}, or mark it on all sides alike.",
                edges=[tuple(pair) for pair in edge_vertices(mesh)[lost].tolist()],
            )
        )


def number_faces(mesh: bpy.types.Mesh, faces: Sequence[int] | np.ndarray) -> np.ndarray:
    """(f,) the numbers of all faces, none twice; these faces have one. What is marked of sides stays where it is told.

    Of a mesh in Object Mode.
    """
    numbers = read_values(mesh, FACE, "INT", "FACE")
    _, first, counts = np.unique(numbers, return_inverse=True, return_counts=True)
    renumbered = (numbers != 0) & (counts[first] > 1)
    renumbered[faces] |= numbers[faces] == 0
    given = numbers.copy()
    given[renumbered] = [new_id() for _ in range(np.count_nonzero(renumbered))]
    of_loops, loop_edges = np.repeat(given, face_sizes(mesh)), corner_edges(mesh)
    for name in (SIDE, EASED_SIDE):
        marked, counts = _marked_corners(mesh, name)
        told = marked & (counts[loop_edges] == 1)
        if told.any():
            sides = read_values(mesh, name, "INT", "EDGE")
            sides[loop_edges[told]] = of_loops[told]
            write_values(mesh, name, sides, "INT", "EDGE")
    write_values(mesh, FACE, given, "INT", "FACE")
    return given


def _marked_corners(mesh: bpy.types.Mesh, side: str) -> tuple[np.ndarray, np.ndarray]:
    """(l,) bool: corners of faces with the number that is on the edge which begins there; (e,) how many each edge has.

    side: the attribute of this number.
    """
    loop_edges = corner_edges(mesh)
    of_loops = read_values(mesh, side, "INT", "EDGE")[loop_edges]
    numbers = np.repeat(read_values(mesh, FACE, "INT", "FACE"), face_sizes(mesh))
    marked = (of_loops != 0) & (of_loops == numbers)
    return marked, np.bincount(loop_edges[marked], minlength=len(mesh.edges))


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
