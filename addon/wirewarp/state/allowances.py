# SPDX-License-Identifier: GPL-3.0-or-later
"""Seam allowances that were marked on edges of the model, in Object Mode.

wirewarp_allowance FLOAT, on edges, in Blender units: above 0 the width on all sides of the edge; below 0 nothing is
added, for the cloth lies double there (a fold) or stays raw. 0 is what Blender gives to edges that are new or come from
another mesh: as NaN and where there is no attribute, the pattern's default. One side of an edge may differ: see sides.
"""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import check_attribute, find_values, read_values, write_marked, write_values
from ..blender.mesh import corner_edges, corner_vertices, edge_vertices, faces_at_edges, read_seams
from ..names import ALLOWANCE, MARKS
from .sides import SIDE_ALLOWANCES, is_set

NONE = -1.0  # what stands on edges without allowance


@dataclass(frozen=True)
class MarkedAllowances:
    """Widths by vertex pairs, in Blender units; below 0 for none."""

    edges: np.ndarray  # (e,2)
    widths: np.ndarray  # (e,)
    sides: np.ndarray  # (s,2) directed as in their face
    side_widths: np.ndarray  # (s,)


def check_allowances(mesh: bpy.types.Mesh) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    check_attribute(mesh, ALLOWANCE)
    SIDE_ALLOWANCES.check_attributes(mesh)


def mark_edges(mesh: bpy.types.Mesh, rows: np.ndarray, width: float) -> int:
    """Gives this width to those of these edges that lie on seams and outlines: NONE for none, 0 for the default.

    Returns how many edges got it.
    """
    marked = rows[_on_outlines(mesh)[rows]]
    widths = read_values(mesh, ALLOWANCE)
    widths[marked] = width
    write_marked(mesh, ALLOWANCE, widths)
    SIDE_ALLOWANCES.clear(mesh, marked)
    return len(marked)


def mark_sides(mesh: bpy.types.Mesh, corners: np.ndarray, width: float) -> int:
    """Gives this width, as in mark_edges, to the sides of edges that begin at these corners.

    Returns how many sides got it: if more than two faces meet, their sides have one width.
    """
    loop_edges = corner_edges(mesh)
    marked = corners[faces_at_edges(mesh)[loop_edges[corners]] <= 2]
    both, alone = _where_set(read_values(mesh, ALLOWANCE)), _where_set(SIDE_ALLOWANCES.read(mesh))
    widths = np.where(alone != 0, alone, both[loop_edges])
    widths[marked] = width
    rows = np.unique(loop_edges[marked])
    beside = np.flatnonzero(np.isin(loop_edges, rows))
    beside = beside[np.argsort(loop_edges[beside], kind="stable")]
    first = beside[np.searchsorted(loop_edges[beside], rows)]
    last = beside[np.searchsorted(loop_edges[beside], rows, side="right") - 1]
    own, shared = np.where(widths[first] != 0, first, last), np.where(widths[first] != 0, last, first)
    both[rows] = widths[shared]  # the default, which is 0, can only be what both share
    write_marked(mesh, ALLOWANCE, both)
    SIDE_ALLOWANCES.clear(mesh, rows)
    one_sided = own[widths[own] != widths[shared]]
    SIDE_ALLOWANCES.mark(mesh, one_sided, widths[one_sided])
    return len(marked)


def scale_lengths(mesh: bpy.types.Mesh, factor: float) -> None:
    """Multiplies all marked lengths by the factor. Edges without a length and with the default stay so."""
    for mark in MARKS:
        lengths = find_values(mesh, mark) if mark.is_length else None
        if lengths is not None:
            write_values(mesh, mark, np.where(lengths > 0, lengths * factor, lengths).astype(np.float32))


def read_allowances(mesh: bpy.types.Mesh) -> MarkedAllowances:
    """Raises ObjectError if an attribute of our name is another's, or if a side is unknown or has two widths."""
    check_attribute(mesh, ALLOWANCE)
    SIDE_ALLOWANCES.check(mesh)
    edges, starts = edge_vertices(mesh), corner_vertices(mesh)
    sides = np.column_stack([starts, edges[corner_edges(mesh)].sum(axis=1) - starts])
    side_widths = SIDE_ALLOWANCES.read(mesh)
    return MarkedAllowances(*_set_ones(edges, read_values(mesh, ALLOWANCE)), *_set_ones(sides, side_widths))


def widest_allowance(mesh: bpy.types.Mesh) -> float:
    """Returns the largest width that is marked on seams and outlines, in Blender units; 0 for none."""
    on_outlines = _on_outlines(mesh)
    both, sides = read_values(mesh, ALLOWANCE)[on_outlines], SIDE_ALLOWANCES.read(mesh)[on_outlines[corner_edges(mesh)]]
    return float(max(_where_set(both).max(initial=0.0), _where_set(sides).max(initial=0.0)))


def _on_outlines(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) bool"""
    faces = faces_at_edges(mesh)
    return (faces > 0) & (read_seams(mesh) | (faces != 2))


def _where_set(widths: np.ndarray) -> np.ndarray:
    """0 where they are none."""
    return np.where(is_set(widths), widths, np.float32(0))


def _set_ones(pairs: np.ndarray, widths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    marked = is_set(widths)
    return pairs[marked].astype(np.int64), widths[marked].astype(np.float64)
