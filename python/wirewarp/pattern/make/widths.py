# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the width of the allowance along each edge of the outlines."""

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from ..._errors import FlattenError
from ..checks import checked_length, problem
from ..narrow import outline_has_room
from .outline import FlatPiece, Side

Pair = tuple[int, int]
Row = tuple[int, int, float]  # two vertices and a width


class Widths:
    """Widths of the allowance: defaults for seams and open outlines, and widths of single edges and sides of edges."""

    def __init__(
        self,
        allowance: float,
        hem: float | None,
        both: npt.ArrayLike | None,
        sides: npt.ArrayLike | None,
        folds: npt.ArrayLike | None,
    ) -> None:
        """Check and keep the widths. both, sides and folds: allowances, side_allowances and folds of PatternOptions."""
        self._seam = checked_length("allowance", allowance)
        self._hem = self._seam if hem is None else checked_length("hem", hem)
        rows, side_rows, pairs = _rows("allowances", both), _rows("side_allowances", sides), _pairs("folds", folds)
        self._marked = _at_sides(rows, side_rows, pairs)
        self._folds = {(min(pair), max(pair)) for pair in pairs}
        self._unused = {(min(a, b), max(a, b)) for a, b, _ in rows} | {(a, b) for a, b, _ in side_rows} | self._folds

    def of(self, side: Side) -> tuple[np.ndarray, np.ndarray]:
        """Return the width (k-1,) of the allowance at each step of the side, and whether the step is a fold, which has
        width 0. Raises FlattenError for a fold that is sewn."""
        default = self._hem if side.seam is None else self._seam
        pairs = list(zip(side.sources[:-1].tolist(), side.sources[1:].tolist(), strict=True))
        widths = np.array([self._width(pair[::-1] if side.is_turned else pair, default) for pair in pairs])
        folds = np.array([(min(pair), max(pair)) in self._folds for pair in pairs])
        if side.seam is not None and folds.any():
            a, b = pairs[int(np.argmax(folds))]
            raise FlattenError(
                "invalid_option",
                f"Edge {a}-{b} is a fold, but it is sewn. Remove the fold or the seam.",
                edges=[(a, b)],
            )
        return widths, folds

    def check_all_used(self) -> None:
        """Raise FlattenError if an edge with its own width or with a fold is not on an outline."""
        if self._unused:
            edges = sorted(self._unused)
            a, b = edges[0]
            message = f"Edge {a}-{b} is not on the outline of a piece, so remove its allowance or fold."
            raise FlattenError("invalid_option", message, edges=edges)

    def _width(self, edge: Pair, default: float) -> float:
        self._unused -= {edge, (min(edge), max(edge))}
        return self._marked.get(edge, default)


def narrow_pieces(
    pieces: Iterable[FlatPiece], allowance: float, both: Iterable[Row], sides: Iterable[Row], folds: Iterable[Pair]
) -> list[str]:
    """Return the names of the pieces that are too narrow somewhere for two allowances side by side.

    Widths are in millimeters, also those of the pieces.

    - allowance: width at unmarked edges
    - both, sides, folds: as PatternOptions.allowances, side_allowances and folds
    """
    marked = _at_sides(both, sides, folds)
    ends, widths = list(marked), list(marked.values())
    # Pieces without a flat shape have no width.
    flat = [piece for piece in pieces if np.isfinite(piece.vertices[piece.outline]).all()]
    shapes = [(piece.name, (piece.vertices, piece.source_vertex, piece.outline)) for piece in flat]
    return [name for name, shape in shapes if not outline_has_room(*shape, allowance, ends, widths)]


def _at_sides(both: Iterable[Row], sides: Iterable[Row], folds: Iterable[Pair]) -> dict[Pair, float]:
    """Return the width of each marked side of an edge, by its vertices in the direction of the face. A width of one
    side replaces the width of both sides, and a fold, which has width 0, replaces both."""
    widths = {ends: width for a, b, width in both for ends in ((a, b), (b, a))}
    widths |= {(a, b): width for a, b, width in sides}
    return widths | {ends: 0.0 for a, b in folds for ends in ((a, b), (b, a))}


def _pairs(name: str, values: npt.ArrayLike | None) -> list[Pair]:
    """Return the edges of the table (k,2) with this name. Raises FlattenError for an invalid table."""
    table = np.empty((0, 2)) if values is None else np.asarray(values)
    if table.size == 0 and table.ndim <= 2:
        table = table.reshape(-1, 2)
    if table.ndim != 2 or table.shape[1] != 2:
        raise problem(f"{name} must be an array (k, 2): vertex, vertex.", "invalid_shape")
    if table.size and not np.issubdtype(table.dtype, np.integer):
        raise problem(f"{name} must be whole numbers.", "invalid_type")
    return [(int(a), int(b)) for a, b in table]


def _rows(name: str, values: npt.ArrayLike | None) -> list[Row]:
    """Return the rows of the table (k,3) with this name. Raises FlattenError for an invalid table."""
    if values is None:
        return []
    try:
        table = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        table = np.empty(0)
    if table.size == 0 and table.ndim <= 2:
        table = table.reshape(-1, 3)
    if table.ndim != 2 or table.shape[1] != 3:
        raise problem(f"{name} must be an array (k, 3): vertex, vertex, millimeters.", "invalid_shape")
    if not np.array_equal(table[:, :2], np.rint(table[:, :2])) or np.any(table[:, :2] < 0):
        raise problem(f"{name} has a vertex index that is not a whole number from 0.", "invalid_type")
    for a, b, width in table:
        checked_length(f"The allowance of edge {a:.0f}-{b:.0f}", width)
    return [(int(a), int(b), float(width)) for a, b, width in table]
