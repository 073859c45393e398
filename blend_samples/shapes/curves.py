# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes smooth curves, even spacing along curves, and the patch between four curves."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np


def cubic_spline(knots: np.ndarray, values: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Return the natural cubic spline through values (n, ...) at increasing knots (n,)."""
    knots = np.asarray(knots, dtype=float)
    values = np.asarray(values, dtype=float)
    step = np.diff(knots)
    slope = np.diff(values, axis=0) / _column(step, values)
    matrix = np.eye(len(knots))
    right = np.zeros_like(values)
    for k in range(1, len(knots) - 1):
        matrix[k, k - 1 : k + 2] = step[k - 1], 2 * (step[k - 1] + step[k]), step[k]
        right[k] = 6 * (slope[k] - slope[k - 1])
    bend = np.linalg.solve(matrix, right.reshape(len(knots), -1)).reshape(values.shape)  # second derivatives

    def evaluate(at: np.ndarray) -> np.ndarray:
        at = np.asarray(at, dtype=float)
        k = np.clip(np.searchsorted(knots, at, side="right") - 1, 0, len(step) - 1)
        h = _column(step[k], values)
        x = _column(at - knots[k], values)
        first = slope[k] - h * (2 * bend[k] + bend[k + 1]) / 6
        return values[k] + x * (first + x * (bend[k] / 2 + x * (bend[k + 1] - bend[k]) / (6 * h)))

    return evaluate


def chord_lengths(points: np.ndarray) -> np.ndarray:
    """Return the length along a polyline (n, d) to each of its points, from 0 to 1."""
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    return lengths / lengths[-1]


def even_parameters(curve: Callable[[np.ndarray], np.ndarray], begin: float, end: float, count: int) -> np.ndarray:
    """Return parameters of count + 1 points at equal distances along curve(t), begin <= t <= end."""
    t = np.linspace(begin, end, 2001)
    return np.interp(np.linspace(0, 1, count + 1), chord_lengths(curve(t)), t)


def hermite(t: np.ndarray, begin: np.ndarray, leave: np.ndarray, end: np.ndarray, arrive: np.ndarray) -> np.ndarray:
    """Return points at t, 0 to 1, of cubic curves from begin to end. Their velocities are leave and arrive."""
    return (
        (1 + 2 * t) * (1 - t) ** 2 * begin
        + t * (1 - t) ** 2 * leave
        + t**2 * (3 - 2 * t) * end
        - t**2 * (1 - t) * arrive
    )


def hermite_curves(begin: np.ndarray, leave: np.ndarray, end: np.ndarray, arrive: np.ndarray, count: int) -> np.ndarray:
    """Return points (count + 1, n, d) of cubic curves from begin to end (n, d), with velocities leave and arrive."""
    return hermite(np.linspace(0, 1, count + 1)[:, None, None], begin, leave, end, arrive)


def coons_patch(bottom: np.ndarray, top: np.ndarray, left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return points (r, c, d) between four curves: bottom and top (c, d), left and right (r, d).

    bottom and top run from left to right, left and right run upward.
    """
    s, t = chord_lengths((bottom + top) / 2), chord_lengths((left + right) / 2)
    s, t = s[None, :, None], t[:, None, None]
    between_rows = (1 - t) * bottom + t * top
    between_columns = (1 - s) * left[:, None] + s * right[:, None]
    between_corners = (1 - t) * ((1 - s) * bottom[0] + s * bottom[-1]) + t * ((1 - s) * top[0] + s * top[-1])
    return between_rows + between_columns - between_corners


def _column(numbers: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the numbers with more axes, so that they multiply the rows of `values`."""
    return np.reshape(numbers, np.shape(numbers) + (1,) * (values.ndim - 1))
