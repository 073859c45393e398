# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances, and marks on one side of an edge, for meshes in Object Mode.

wirewarp_allowance FLOAT, on edges, in Blender units:

- above 0: width on all sides of the edge; for one side, see SIDE_ALLOWANCES
- below 0: nothing is added, because the fabric is folded there or stays raw
- 0, NaN or missing: the pattern's default; new edges and edges of joined meshes have 0

A mark on one side is stored on the edge: a value, and the number of the face on this side. The face stores its number
in wirewarp_face (INT, random, 0 for none). Scripts may write the value on a corner instead: the corner of this face at
which the edge begins. WireWarp does not, because Blender blends values of corners when edges are split, and moves them
to other edges when faces are flipped or mirrored.

- Faces that are cut, copied or extruded share a number until number_faces() renumbers them.
- The side is unknown if several faces of the edge have the number.
- The side is also unknown if no face has the number, but the edge has several faces.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import check_attribute, find_values, read_values, write_marked, write_values
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    edge_vertices,
    face_sizes,
    faces_at_edges,
    faces_of_corners,
    read_seams,
)
from ..core import Issue, counted
from ..issues import ObjectError
from ..names import ALLOWANCE, EASED_SIDE, FACE, MARKS, SIDE, SIDE_ALLOWANCE, SIDE_EASE, SIDE_RATIO, SIDE_WIDTH, Mark
from ..solve.identity import new_id


@dataclass(frozen=True)
class SidedMark:
    """A value that one side of an edge may have. Its methods need meshes in Object Mode."""

    what: str  # name of the mark in sentences
    value: Mark  # FLOAT, on edges: value of the marked side
    side: Mark  # INT, on edges: number of the face on the marked side, 0 none
    corner: Mark  # FLOAT, on corners: values that scripts write, each for the edge that begins at the corner

    def check_attributes(self, mesh: bpy.types.Mesh) -> None:
        """Raises ObjectError if an attribute with one of our names has another type or domain."""
        for attribute in (self.value, self.side, FACE, self.corner):
            check_attribute(mesh, attribute)

    def check(self, mesh: bpy.types.Mesh, *, has_modifiers: bool = False) -> None:
        """Raises ObjectError like check_attributes, or if a side is unknown or has two values.

        has_modifiers: whether modifiers made the mesh; a Mirror modifier that merges the middle makes sides unknown
        """
        self.check_attributes(mesh)
        _, counts = marked_corners(mesh, self.side)
        sides, values = read_values(mesh, self.side), read_values(mesh, self.value)
        # If only one face is left at an edge, and it is not the marked face, the mark is ignored.
        lost = np.flatnonzero((sides != 0) & is_set(values) & (counts != 1) & (faces_at_edges(mesh) > 1))
        if len(lost):
            why, first = "faces there were copied or replaced", f"Mark the {self.what} again"
            if has_modifiers:
                why = "modifiers copied or replaced faces there"
                first = f"Apply the modifiers and mark the {self.what} again"
            sentence = (
                f'The side of the {self.what} is unknown on {counted(len(lost), "edge")} of "{mesh.name}", because '
                f"{why}. {first}, or mark the same {self.what} on all sides."
            )
            raise ObjectError(Issue("side_unknown", sentence, edges=_pairs(mesh, lost)))
        corners, marked = read_values(mesh, self.corner), self._on_edges(mesh)
        contradict = np.unique(corner_edges(mesh)[(corners != 0) & (marked != 0) & (corners != marked)])
        if len(contradict):
            sentence = (
                f'Edges of "{mesh.name}" have two {self.what}s on one side: the marked {self.what}, and a value in the '
                f"attribute {self.corner.name}. Mark the {self.what} of these edges again."
            )
            raise ObjectError(Issue(f"{self.what}s_contradict", sentence, edges=_pairs(mesh, contradict)))

    def read(self, mesh: bpy.types.Mesh) -> np.ndarray:
        """Returns (l,) float32: the value of the edge that begins at each corner, on the side of its face; 0 for none.

        Attributes of another type or domain are ignored. Values on corners take precedence.
        """
        if not {self.value.name, self.corner.name} & set(mesh.attributes.keys()):
            return np.zeros(len(mesh.loops), dtype=np.float32)
        corners, marked = read_values(mesh, self.corner), self._on_edges(mesh)
        return np.where(is_set(corners) | (marked == 0), corners, marked)

    def mark(self, mesh: bpy.types.Mesh, corners: Sequence[int] | np.ndarray, values: np.ndarray | float) -> None:
        """Sets these values on the sides of edges that begin at these corners, at most one side of each edge. Clears
        the other sides of these edges."""
        rows, faces = corner_edges(mesh)[corners], faces_of_corners(mesh)[corners]
        self.clear(mesh, rows)
        numbers = number_faces(mesh, faces)
        for attribute, each in ((self.value, values), (self.side, numbers[faces])):
            present = read_values(mesh, attribute)
            present[rows] = each
            write_marked(mesh, attribute, present)

    def clear(self, mesh: bpy.types.Mesh, rows: np.ndarray) -> np.ndarray:
        """Clears all sides of these edges (k,). Returns (k,) bool: which edges had a value on a side."""
        cleared = np.isin(corner_edges(mesh), rows)
        value, side, corner = (read_values(mesh, each) for each in (self.value, self.side, self.corner))
        had = (side[rows] != 0) | np.isin(rows, corner_edges(mesh)[cleared & (corner != 0)])
        value[rows], side[rows], corner[cleared] = 0, 0, 0
        for attribute, values in ((self.value, value), (self.side, side), (self.corner, corner)):
            write_marked(mesh, attribute, values)
        return had

    def _on_edges(self, mesh: bpy.types.Mesh) -> np.ndarray:
        """Returns (l,) float32 like read, but ignores the values on corners."""
        marked, counts = marked_corners(mesh, self.side)
        loop_edges = corner_edges(mesh)
        return np.where(marked & (counts[loop_edges] == 1), read_values(mesh, self.value)[loop_edges], np.float32(0))


SIDE_EASES = SidedMark("ease", SIDE_RATIO, EASED_SIDE, SIDE_EASE)
SIDE_ALLOWANCES = SidedMark("allowance", SIDE_WIDTH, SIDE, SIDE_ALLOWANCE)


def is_set(values: np.ndarray) -> np.ndarray:
    return np.isfinite(values) & (values != 0)


def number_faces(mesh: bpy.types.Mesh, faces: np.ndarray) -> np.ndarray:
    """Gives numbers to these faces, and new numbers to faces that share a number. Known sides remain known.

    Returns the numbers of all faces (f,), 0 for none.
    """
    numbers = read_values(mesh, FACE)
    _, first, counts = np.unique(numbers, return_inverse=True, return_counts=True)
    renumbered = (numbers != 0) & (counts[first] > 1)
    renumbered[faces] |= numbers[faces] == 0
    given = numbers.copy()
    given[renumbered] = [new_id() for _ in range(np.count_nonzero(renumbered))]
    of_loops, loop_edges = np.repeat(given, face_sizes(mesh)), corner_edges(mesh)
    for each in (SIDE_EASES, SIDE_ALLOWANCES):
        marked, counts = marked_corners(mesh, each.side)
        known = marked & (counts[loop_edges] == 1)
        if known.any():
            sides = read_values(mesh, each.side)
            sides[loop_edges[known]] = of_loops[known]
            write_marked(mesh, each.side, sides)
    write_marked(mesh, FACE, given)
    return given


def marked_corners(mesh: bpy.types.Mesh, side: Mark) -> tuple[np.ndarray, np.ndarray]:
    """Return a mask (l,) of the corners whose face has the number that is stored on the corner's edge. Also return the
    number (e,) of such corners at each edge.

    side: the attribute that stores the number on edges
    """
    loop_edges = corner_edges(mesh)
    of_loops = read_values(mesh, side)[loop_edges]
    numbers = np.repeat(read_values(mesh, FACE), face_sizes(mesh))
    marked = (of_loops != 0) & (of_loops == numbers)
    return marked, np.bincount(loop_edges[marked], minlength=len(mesh.edges))


def _pairs(mesh: bpy.types.Mesh, rows: np.ndarray) -> list[tuple[int, int]]:
    return [tuple(pair) for pair in edge_vertices(mesh)[rows].tolist()]


NONE = -1.0  # stored on edges that get no allowance


@dataclass(frozen=True)
class MarkedAllowances:
    """Widths of edges and of single sides, in Blender units; below 0 for no allowance."""

    edges: np.ndarray  # (e,2) vertices of the edges with a width on all sides
    widths: np.ndarray  # (e,) widths of these edges
    sides: np.ndarray  # (s,2) vertices of the edges with a width on one side, in the direction of the face on this side
    side_widths: np.ndarray  # (s,) widths of these sides


def mark_edges(mesh: bpy.types.Mesh, rows: np.ndarray, width: float) -> int:
    """Set this width on the edges of `rows` that are on seams or outlines. width: in Blender units, NONE for no
    allowance, 0 for the default. Return the number of changed edges."""
    marked = rows[on_outlines(mesh)[rows]]
    widths = read_values(mesh, ALLOWANCE)
    widths[marked] = width
    write_marked(mesh, ALLOWANCE, widths)
    SIDE_ALLOWANCES.clear(mesh, marked)
    return len(marked)


def mark_sides(mesh: bpy.types.Mesh, corners: np.ndarray, width: float) -> int:
    """Set this width on the sides of edges that begin at these corners. Return the number of changed sides.

    Edges of more than two faces do not change. width: see mark_edges
    """
    loop_edges = corner_edges(mesh)
    # All sides of an edge with more than two faces have one width, so such edges are left out.
    marked = corners[faces_at_edges(mesh)[loop_edges[corners]] <= 2]
    both, widths = _where_set(read_values(mesh, ALLOWANCE)), corner_widths(mesh)
    widths[marked] = width
    rows = np.unique(loop_edges[marked])
    beside = np.flatnonzero(np.isin(loop_edges, rows))
    beside = beside[np.argsort(loop_edges[beside], kind="stable")]
    first = beside[np.searchsorted(loop_edges[beside], rows)]
    last = beside[np.searchsorted(loop_edges[beside], rows, side="right") - 1]
    own, shared = np.where(widths[first] != 0, first, last), np.where(widths[first] != 0, last, first)
    both[rows] = widths[shared]  # below, SIDE_ALLOWANCES gets the width of the other side if it differs
    write_marked(mesh, ALLOWANCE, both)
    SIDE_ALLOWANCES.clear(mesh, rows)
    one_sided = own[widths[own] != widths[shared]]
    SIDE_ALLOWANCES.mark(mesh, one_sided, widths[one_sided])
    return len(marked)


def scale_lengths(mesh: bpy.types.Mesh, factor: float) -> None:
    """Multiplies all marked lengths by the factor. Edges with no allowance or the default allowance do not change."""
    for mark in MARKS:
        lengths = find_values(mesh, mark) if mark.is_length else None
        if lengths is not None:
            write_values(mesh, mark, np.where(lengths > 0, lengths * factor, lengths).astype(np.float32))


def read_allowances(mesh: bpy.types.Mesh) -> MarkedAllowances:
    """Return the marked allowances. Raises ObjectError if an attribute of another add-on has one of our names, or if a
    side is unknown or has two widths."""
    check_attribute(mesh, ALLOWANCE)
    SIDE_ALLOWANCES.check(mesh)
    edges, starts = edge_vertices(mesh), corner_vertices(mesh)
    sides = np.column_stack([starts, edges[corner_edges(mesh)].sum(axis=1) - starts])
    side_widths = SIDE_ALLOWANCES.read(mesh)
    return MarkedAllowances(*_set_ones(edges, read_values(mesh, ALLOWANCE)), *_set_ones(sides, side_widths))


def corner_widths(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the width (l,) of the edge that begins at each corner, on the side of the corner's face: 0 for the
    default, NONE for no allowance. Edges inside pieces may have widths, too."""
    both, alone = _where_set(read_values(mesh, ALLOWANCE)), _where_set(SIDE_ALLOWANCES.read(mesh))
    return np.where(alone != 0, alone, both[corner_edges(mesh)])


def widest_allowance(mesh: bpy.types.Mesh) -> float:
    """Returns the largest width that is marked on seams and outlines, in Blender units; 0 for none."""
    edges = on_outlines(mesh)
    both, sides = read_values(mesh, ALLOWANCE)[edges], SIDE_ALLOWANCES.read(mesh)[edges[corner_edges(mesh)]]
    return float(max(_where_set(both).max(initial=0.0), _where_set(sides).max(initial=0.0)))


def on_outlines(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return a mask (e,) of the edges on seams and outlines. Only the sides of these edges can have marks."""
    faces = faces_at_edges(mesh)
    return (faces == 1) | (read_seams(mesh) & (faces > 0))


def _where_set(widths: np.ndarray) -> np.ndarray:
    return np.where(is_set(widths), widths, np.float32(0))


def _set_ones(pairs: np.ndarray, widths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    marked = is_set(widths)
    return pairs[marked].astype(np.int64), widths[marked].astype(np.float64)
