# SPDX-License-Identifier: GPL-3.0-or-later
"""Eases of one side of a seam, or of a stretch of outline: by how much that side is to be longer than it would be.

Marking writes them on edges, for one side of each; scripts may write them on corners, wirewarp_side_ease, for both.
See sides.
"""

from collections.abc import Sequence

import bpy
import numpy as np

from ..blender.mesh import corner_edges, corner_vertices, edge_vertices, face_sizes, read_seams
from ..issues import Issue, ObjectError
from ..names import EASED_SIDE, SIDE_EASE, SIDE_RATIO
from ..pattern.chains import split_into_chains
from .sides import SideNames, check_sides, check_sides_told, number_faces, read_values, values_at_edges, write_values

_NAMES = SideNames(SIDE_RATIO, EASED_SIDE, SIDE_EASE)


def read_side_eases(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) float32 of the edge that begins at each corner, on the side of its face; 0 where none is marked.

    Of a mesh that is not in Edit Mode; attributes of our names that are not ours count as none. Where corner and edge
    say different things, see check_side_eases, the corner's.
    """
    if not {SIDE_RATIO, SIDE_EASE} & set(mesh.attributes.keys()):
        return np.zeros(len(mesh.loops), dtype=np.float32)
    corners, marked = _read(mesh, SIDE_EASE), values_at_edges(mesh, _NAMES)
    return np.where(corners != 0, corners, marked).astype(np.float32)


def check_side_attributes(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    check_sides(mesh, _NAMES)


def check_side_eases(mesh: bpy.types.Mesh, *, has_modifiers: bool) -> None:
    """Raises ObjectError if an attribute of our name is another's, where it cannot be told which side is eased, or if a
    corner and its edge say different things.
    """
    check_side_attributes(mesh)
    check_sides_told(mesh, _NAMES, "ease", has_modifiers=has_modifiers)
    corners, marked = _read(mesh, SIDE_EASE), values_at_edges(mesh, _NAMES)
    contradict = np.unique(corner_edges(mesh)[(corners != 0) & (marked != 0) & (corners != marked)])
    if len(contradict):
        raise ObjectError(
            Issue(
                "eases_contradict",
                f'Edges of "{mesh.name}" have two eases of one side, the one that was marked and another in the '
                f"attribute {SIDE_EASE}: mark their ease again.",
                edges=[tuple(pair) for pair in edge_vertices(mesh)[contradict].tolist()],
            )
        )


def sides_of_lines(mesh: bpy.types.Mesh, rows: np.ndarray, places: np.ndarray) -> list[tuple[list[int], list[int]]]:
    """The corners at which the edges of each line begin, on its one and on its other side.

    rows: of edges on seams and outlines; places (n,3): of the vertices as they are seen, where lines go straight on. An
    edge that has no face on a side, or several, has no corner there.
    """
    edges, starts, loop_edges = edge_vertices(mesh), corner_vertices(mesh), corner_edges(mesh)
    corners_of: dict[tuple[int, int], list[int]] = {}
    for corner in np.flatnonzero(np.isin(loop_edges, rows)).tolist():
        corners_of.setdefault((int(loop_edges[corner]), int(starts[corner])), []).append(corner)
    lines = []
    for chain in split_into_chains(edges[rows], places):
        sides: tuple[list[int], list[int]] = ([], [])
        for side, begins in zip(sides, (chain.vertices[:-1], chain.vertices[1:]), strict=True):
            for row, vertex in zip(chain.edges, begins, strict=True):
                found = corners_of.get((int(rows[row]), vertex), [])
                side += found if len(found) == 1 else []
        lines.append(sides)
    return lines


def outline_rows(mesh: bpy.types.Mesh, rows: np.ndarray) -> np.ndarray:
    """Those of the edges that lie on a seam or outline, where sides are."""
    counts = np.bincount(corner_edges(mesh), minlength=len(mesh.edges))[rows]
    return rows[(counts == 1) | (read_seams(mesh)[rows] & (counts > 0))]


def write_side_eases(mesh: bpy.types.Mesh, corners: Sequence[int], ratio: float) -> None:
    """The sides that begin at these corners get this ease; of each edge the other side has none then.

    Of a mesh in Object Mode.
    """
    rows = corner_edges(mesh)[corners]
    faces = np.repeat(np.arange(len(mesh.polygons)), face_sizes(mesh))[corners]
    numbers = number_faces(mesh, faces)
    values = {name: _read(mesh, name) for name in (SIDE_EASE, SIDE_RATIO, EASED_SIDE)}
    values[SIDE_EASE][np.isin(corner_edges(mesh), rows)] = 0
    values[SIDE_RATIO][rows] = ratio
    values[EASED_SIDE][rows] = numbers[faces]
    for name, each in values.items():
        write_values(mesh, name, each, *_NAMES.kinds[name])


def write_corner_eases(mesh: bpy.types.Mesh, eases: np.ndarray) -> None:
    """On corners (l,), of a mesh that has no eases: flat pieces show those of the model."""
    write_values(mesh, SIDE_EASE, eases, *_NAMES.kinds[SIDE_EASE])


def clear_side_eases(mesh: bpy.types.Mesh, rows: np.ndarray) -> np.ndarray:
    """(k,) bool: which of these edges (k,) had one. Of a mesh in Object Mode."""
    corners = np.isin(corner_edges(mesh), rows)
    values = {name: _read(mesh, name) for name in (SIDE_EASE, SIDE_RATIO, EASED_SIDE)}
    had = (values[EASED_SIDE][rows] != 0) | np.isin(rows, corner_edges(mesh)[corners & (values[SIDE_EASE] != 0)])
    values[SIDE_EASE][corners], values[SIDE_RATIO][rows], values[EASED_SIDE][rows] = 0, 0, 0
    for name, each in values.items():
        write_values(mesh, name, each, *_NAMES.kinds[name])
    return had


def _read(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    return read_values(mesh, name, *_NAMES.kinds[name])
