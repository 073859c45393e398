# SPDX-License-Identifier: GPL-3.0-or-later
"""Where notches are: at the ends of wires, and at equal lengths along both sides of each seam."""

import math
from collections.abc import Iterator

import numpy as np

from ..issues import object_error
from .chains import edge_keys
from .outlines import FlatPieces, OutlineEdges
from .pattern import Notch
from .seam_sides import SeamSide

LEAST_SPACING = 1.0  # millimeters
MOST = 10_000  # along one seam
TOO_CLOSE = "Notches so close cannot be cut: choose 1 mm or more, or 0 for none along seams."
NOTCH = 5.0  # length of a notch, in millimeters
SHARE = 0.3  # of the way across the piece, the most that a notch may take
SMOOTH = 0.87  # cosine of the turn, 30 degrees: what turns less is no corner that can be found on cloth
LEAST_SEAM = 15.0  # millimeters: a shorter one needs no notch in its middle
CLEAR = 0.2  # of the spacing: so close to a wire's end, or to the end of the seam, there is no other notch
AT_ONCE = 1e-3  # millimeters: nearer than this is the outline that one looks from


def place_notches(
    flat: FlatPieces, outline: OutlineEdges, seams: list[list[list[SeamSide]]], spacing: float
) -> dict[int, list[Notch]]:
    """By piece. seams: of each its runs, of each run the sides; spacing: along seams, 0 for none.

    Raises ObjectError where the spacing is too small to be cut, or for a seam of that length.
    """
    if 0 < spacing < LEAST_SPACING:
        raise object_error("notch_spacing", TOO_CLOSE)
    at_wires, across = vertices_at_wires(flat, outline), Across(flat, outline)
    notches: dict[int, list[Notch]] = {}

    def add(piece: int, point: np.ndarray, inward: np.ndarray, kind: str) -> None:
        length = min(NOTCH, SHARE * across(piece, point, inward))
        notches.setdefault(piece, []).append(Notch(point, inward, length, kind))

    def add_at(vertex: int, kind: str) -> None:
        rows = rows_at[vertex]
        add(int(outline.piece[rows[0]]), flat.vertices[vertex], _unit(outline.inward[rows].sum(axis=0)), kind)

    rows_at = _rows_at(outline)
    for vertex in sorted(at_wires):
        add_at(vertex, "wire")
    runs = _runs(seams) if spacing > 0 else []
    for vertex in sorted(_smooth_ends(flat, outline, runs) - at_wires):
        add_at(vertex, "seam")
    for number, sides in runs:
        _check_count(flat, number, sides, spacing)
        lengths = _lengths(flat, sides, at_wires, spacing)
        for side in sides:
            for point, inward in _places(flat, outline, side, lengths):
                add(side.piece, point, inward, "seam")
    return notches


def vertices_at_wires(flat: FlatPieces, outline: OutlineEdges) -> set[int]:
    """On outlines: where a wire that runs through a piece ends, and the same places on the other sides of a seam."""
    count = len(flat.vertices)
    inside = flat.marks.are_wires & ~np.isin(edge_keys(flat.edges, count), edge_keys(outline.edges, count))
    return _with_copies(flat, outline, np.intersect1d(flat.edges[inside], outline.edges))


def _with_copies(flat: FlatPieces, outline: OutlineEdges, vertices: np.ndarray) -> set[int]:
    """The vertices on outlines that are copies of the same ones of the model, for these are sewn together."""
    on_outline = np.unique(outline.edges)
    return set(on_outline[np.isin(flat.source_vertex[on_outline], flat.source_vertex[vertices])].tolist())


def _runs(seams: list[list[list[SeamSide]]]) -> list[tuple[int, list[SeamSide]]]:
    """The sides of each run, and the number of its seam, from 1."""
    return [(number, sides) for number, seam in enumerate(seams, start=1) for sides in seam if sides]


def _check_count(flat: FlatPieces, number: int, sides: list[SeamSide], spacing: float) -> None:
    length = sides[0].lengths(flat)[-1]
    if length > MOST * spacing:
        sentence = (
            f"Seam {number} is {length / 1000:,.0f} m long, too long for a notch every {spacing:g} mm: see whether "
            "Scene > Units > Unit Scale is what you want, or choose 0 for no notches along seams."
        )
        raise object_error("notch_count", sentence)


def _lengths(flat: FlatPieces, sides: list[SeamSide], at_wires: set[int], spacing: float) -> list[float]:
    """At which lengths from the start of the seam; the same for all its sides."""
    along = sides[0].lengths(flat)
    taken = [along[-1], *(along[place] for place, vertex in enumerate(sides[0].vertices) if vertex in at_wires)]
    lengths = spacing * np.arange(1, int(along[-1] / spacing) + 1)
    near = np.abs(lengths[:, None] - np.unique(taken)).min(axis=1)
    found = lengths[near > CLEAR * spacing].tolist()
    needs_middle = not found and len(taken) == 1 and along[-1] >= LEAST_SEAM
    return [along[-1] / 2] if needs_middle else found


def _smooth_ends(flat: FlatPieces, outline: OutlineEdges, runs: list[tuple[int, list[SeamSide]]]) -> set[int]:
    """Where a seam ends and on one of the pieces nothing shows it, for the outline runs on smoothly there.

    On all pieces that meet there, so that they can be matched.
    """
    before = dict(zip(outline.edges[:, 1].tolist(), outline.edges[:, 0].tolist(), strict=True))
    after = dict(outline.edges.tolist())
    ends = {int(side.vertices[end]) for _, sides in runs for side in sides for end in (0, -1)}

    def runs_on(vertex: int) -> bool:
        a, b, c = flat.vertices[[before[vertex], vertex, after[vertex]]]
        return float(_unit(b - a) @ _unit(c - b)) > SMOOTH

    return _with_copies(flat, outline, np.array([vertex for vertex in sorted(ends) if runs_on(vertex)], dtype=np.int64))


def _rows_at(outline: OutlineEdges) -> dict[int, list[int]]:
    """The rows of the outline's edges at each vertex, ascending."""
    rows: dict[int, list[int]] = {}
    for row, ends in enumerate(outline.edges.tolist()):
        for vertex in ends:
            rows.setdefault(vertex, []).append(row)
    return rows


def _places(
    flat: FlatPieces, outline: OutlineEdges, side: SeamSide, lengths: list[float]
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """The point of each notch, and the direction into the piece."""
    along = side.lengths(flat)
    points = flat.vertices[side.vertices]
    lengths = [length for length in lengths if length < along[-1]]  # of a failed piece sides may differ
    for length, place in zip(lengths, np.searchsorted(along, lengths, side="right") - 1, strict=True):
        share = (length - along[place]) / (along[place + 1] - along[place])
        point = points[place] + share * (points[place + 1] - points[place])
        yield point, outline.inward[side.edges[place]]


def _unit(vector: np.ndarray) -> np.ndarray:
    """At the tip of a slit the two sides cancel out: any direction is as good."""
    length = np.linalg.norm(vector)
    return vector / length if length > 1e-9 else np.array([1.0, 0.0])


class Across:
    def __init__(self, flat: FlatPieces, outline: OutlineEdges) -> None:
        self._flat, self._outline = flat, outline
        self._sides: dict[int, np.ndarray] = {}

    def __call__(self, piece: int, point: np.ndarray, inward: np.ndarray) -> float:
        """From a point (2,) of the outline straight on along the unit vector `inward` to the outline again."""
        if piece not in self._sides:
            self._sides[piece] = self._flat.vertices[self._outline.edges[self._outline.piece == piece]]
        a, b = self._sides[piece].transpose(1, 0, 2)
        along, to = b - a, a - point
        with np.errstate(divide="ignore", invalid="ignore"):  # of edges in this direction, which nothing meets
            slope = _cross(inward, along)
            distance, share = _cross(to, along) / slope, _cross(to, inward) / slope
        met = (share >= 0) & (share <= 1) & (distance > AT_ONCE)
        return float(distance[met].min(initial=math.inf))


def _cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
