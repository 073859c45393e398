# SPDX-License-Identifier: GPL-3.0-or-later
"""Marked edges of a model or of flat pieces: sorted by kind to be drawn, and named. No Blender in here."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..tolerance_text import tolerance_text
from .line_styles import STYLES
from .wire_runs import WireRun, cut_into_dashes

ALONG = (0.25, 0.5, 0.75)  # of the edges of a line, nearest to its middle first: where else its name may stand
VIEW_SIZE = 800  # pixels that an object is wide or high in a usual view: in it dashes have the length of their style


@dataclass(frozen=True)
class LineMarks:
    """Every edge that is a seam, part of an outline or part of a wire."""

    ends: np.ndarray  # (k,2,3) float32, in the object's own space
    normals: np.ndarray  # (k,3) float32, of the surface
    vertices: np.ndarray  # (k,2) int32, of the model
    pieces: np.ndarray  # (k,) int32, on the flat pieces; 0 on the model
    seams: np.ndarray  # (k,) bool
    outlines: np.ndarray  # (k,) bool, has one face only
    wire_ids: np.ndarray  # (k,) int32, 0 none
    tolerances: np.ndarray  # (k,) float32
    selected: np.ndarray  # (k,) bool, in Edit Mode


@dataclass(frozen=True)
class Name:
    """A text at a point of the surface."""

    text: str
    places: np.ndarray  # (c,3) where it may stand, the best first
    normals: np.ndarray  # (c,3)
    reach: float  # distance from the best place to the farthest end of what it names


def lines_by_kind(marks: LineMarks) -> dict[str, np.ndarray]:
    """The ends (2k,3) of the edges of each kind that there is, two rows an edge."""
    return {kind: marks.ends[mask].reshape(-1, 3) for kind, mask in _members(marks).items() if mask.any()}


def dashes_by_kind(marks: LineMarks, runs: Sequence[WireRun]) -> dict[str, np.ndarray]:
    """The ends (2m,3) of the dashes of each kind that is drawn with dashes."""
    if not len(marks.ends):
        return {}
    pixel = np.ptp(marks.ends.reshape(-1, 3), axis=0).max() / VIEW_SIZE
    if not 0 < pixel < np.inf:  # in one place, or nowhere
        return {}
    dashes = {}
    for kind, mask in _members(marks).items():
        style = STYLES[kind]
        own = [run for run in runs if mask[run.rows[0]]]
        if style.dash and own:
            ends = np.concatenate([run.ends for run in own])
            offsets = np.concatenate([run.offsets for run in own])
            dashes[kind] = cut_into_dashes(ends, offsets, *(pixel * length for length in style.dash))
    return dashes


def _members(marks: LineMarks) -> dict[str, np.ndarray]:
    """A mask of each kind's edges."""
    wires = marks.wire_ids != 0
    return {
        "outline": marks.outlines & ~marks.seams,
        "seam": marks.seams,
        "rigid": wires & (marks.tolerances == 0),
        "elastic": wires & (marks.tolerances > 0) & np.isfinite(marks.tolerances),
        "free": wires & np.isinf(marks.tolerances),
        "selected": marks.selected,
    }


def wire_line_names(marks: LineMarks, runs: Sequence[WireRun], names: Sequence[str]) -> list[Name]:
    """Of each wire in each piece, in the middle of it; elastic ones with their tolerance. names: one for each run."""
    named = []
    for run, name in zip(runs, names, strict=True):
        text = f"{name} {tolerance_text(run.tolerance)}" if 0 < run.tolerance < np.inf else name
        for piece in np.unique(marks.pieces[run.rows]).tolist():
            named.append(_name_on_line(text, marks, run.rows[marks.pieces[run.rows] == piece]))
    return named


def seam_line_names(marks: LineMarks, seam_of_edge: Mapping[tuple[int, int], int]) -> list[Name]:
    """The number of each seam, in all its pieces. seam_of_edge: index of the seam by an edge's vertices, ascending."""
    pairs = np.sort(marks.vertices, axis=1).tolist()
    numbers = np.array([1 + seam_of_edge.get((a, b), -1) for a, b in pairs], dtype=np.int32)
    rows: dict[tuple[int, int], list[int]] = {}
    for row in np.flatnonzero(numbers).tolist():
        rows.setdefault((int(numbers[row]), int(marks.pieces[row])), []).append(row)
    return [_name_on_line(f"Seam {number}", marks, np.array(own)) for (number, _), own in rows.items()]


def _name_on_line(text: str, marks: LineMarks, rows: np.ndarray) -> Name:
    """At the edge nearest to the mean of all, so that it is on the line, however that bends; or farther along it."""
    middles = marks.ends[rows].mean(axis=1)
    place = middles[np.argmin(np.linalg.norm(middles - middles.mean(axis=0), axis=1))]
    by_distance = np.argsort(np.linalg.norm(middles - place, axis=1), kind="stable")
    first = (np.array([0, *ALONG]) * len(rows)).astype(int)
    best = by_distance[np.unique(np.concatenate([first, first[1:] + 1]).clip(max=len(rows) - 1))]  # one to either side
    reach = float(np.linalg.norm(marks.ends[rows] - place, axis=2).max())
    return Name(text, middles[best], marks.normals[rows[best]], reach)
