# SPDX-License-Identifier: GPL-3.0-or-later
"""How wide the allowance is along each edge of the outlines."""

import numpy as np
import numpy.typing as npt

from .._errors import ErrorCode, FlattenError
from .outline import Side

WIDEST = 1000.0  # millimeters: what is wider was given in another unit


def problem(message: str, code: ErrorCode | str = "invalid_option") -> FlattenError:
    return FlattenError(code, message)


def checked_length(name: str, value: float, least: float = 0.0, most: float = WIDEST) -> float:
    """The value as a float; raises FlattenError unless it is a number from `least` to `most`."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise problem(f"{name} is {value!r}: give a number of millimeters.") from None
    if not least <= number <= most:  # of NaN neither is true
        raise problem(f"{name} is {number:g}: give millimeters from {least:g} to {most:g}.")
    return number


class Widths:
    """Widths of edges: of seams and other outlines in general, of single edges, and of single sides of these."""

    def __init__(
        self, allowance: float, hem: float | None, both: npt.ArrayLike | None, sides: npt.ArrayLike | None
    ) -> None:
        """both, sides: (k,3) as in Pattern.from_result."""
        self._seam = checked_length("allowance", allowance)
        self._hem = self._seam if hem is None else checked_length("hem", hem)
        self._both = {(min(pair), max(pair)): width for pair, width in _rows("allowances", both).items()}
        self._sides = _rows("side_allowances", sides)
        self._unused = set(self._both) | set(self._sides)

    def of(self, side: Side) -> np.ndarray:
        """(k-1,) the width outside of each step of the side."""
        default = self._hem if side.seam is None else self._seam
        pairs = list(zip(side.sources[:-1].tolist(), side.sources[1:].tolist(), strict=True))
        return np.array([self._width(pair[::-1] if side.is_turned else pair, default) for pair in pairs])

    def check_all_used(self) -> None:
        """Raises FlattenError if an edge of a given width was met on no outline."""
        if self._unused:
            edges = sorted(self._unused)
            message = f"Edge {edges[0][0]}-{edges[0][1]} has an allowance, but is on no outline of a piece."
            raise FlattenError("invalid_option", message, edges=edges)

    def _width(self, edge: tuple[int, int], default: float) -> float:
        both = (min(edge), max(edge))
        self._unused -= {edge, both}
        return self._sides.get(edge, self._both.get(both, default))


def _rows(name: str, values: npt.ArrayLike | None) -> dict[tuple[int, int], float]:
    """Widths by vertex pairs. Raises FlattenError for what is no such table."""
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
        raise problem(f"{name} has a vertex that is no whole number from 0.", "invalid_type")
    for a, b, width in table:
        checked_length(f"The allowance of edge {a:.0f}-{b:.0f}", width)
    return {(int(a), int(b)): float(width) for a, b, width in table}
