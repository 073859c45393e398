# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the width of the allowance along each edge of the outlines."""

import numpy as np
import numpy.typing as npt

from ..._errors import FlattenError
from ..checks import checked_length, problem
from .outline import Side


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
        self._both = {(min(pair), max(pair)): width for pair, width in _rows("allowances", both).items()}
        self._sides = _rows("side_allowances", sides)
        self._folds = {(min(pair), max(pair)) for pair in _pairs("folds", folds)}
        self._unused = set(self._both) | set(self._sides) | self._folds

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
        return np.where(folds, 0.0, widths), folds

    def check_all_used(self) -> None:
        """Raise FlattenError if an edge with its own width or with a fold is not on an outline."""
        if self._unused:
            edges = sorted(self._unused)
            a, b = edges[0]
            message = f"Edge {a}-{b} is not on the outline of a piece, so remove its allowance or fold."
            raise FlattenError("invalid_option", message, edges=edges)

    def _width(self, edge: tuple[int, int], default: float) -> float:
        both = (min(edge), max(edge))
        self._unused -= {edge, both}
        return self._sides.get(edge, self._both.get(both, default))


def _pairs(name: str, values: npt.ArrayLike | None) -> list[tuple[int, int]]:
    """Return the edges of the table (k,2) with this name. Raises FlattenError for an invalid table."""
    table = np.empty((0, 2)) if values is None else np.asarray(values)
    if table.size == 0 and table.ndim <= 2:
        table = table.reshape(-1, 2)
    if table.ndim != 2 or table.shape[1] != 2:
        raise problem(f"{name} must be an array (k, 2): vertex, vertex.", "invalid_shape")
    if table.size and not np.issubdtype(table.dtype, np.integer):
        raise problem(f"{name} must be whole numbers.", "invalid_type")
    return [(int(a), int(b)) for a, b in table]


def _rows(name: str, values: npt.ArrayLike | None) -> dict[tuple[int, int], float]:
    """Return the widths of the table (k,3) with this name, by their vertex pairs. Raises FlattenError for an invalid
    table."""
    if values is None:
        return {}
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
    return {(int(a), int(b)): float(width) for a, b, width in table}
