# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds places for numbers on flat pieces. Needs only numpy."""

from __future__ import annotations

import numpy as np

from .surfaces import Flat

ROOM = 0.5  # least space around a number, as a share of its usual distance from the seam
NARROW = 0.6  # distance from the seam in a narrow piece, as a share of the usual distance


def inside_point(candidates: np.ndarray, lines: np.ndarray) -> tuple[np.ndarray, float]:
    """Return the candidate (k, 3) farthest from all points of lines (n, 3), and its distance."""
    distances = [np.min(np.linalg.norm(lines - candidate, axis=1)) for candidate in candidates]
    best = int(np.argmax(distances))
    return candidates[best], distances[best]


def seam_labels(
    pieces: Flat, points: np.ndarray, seams: list[dict], offset: float, taken: list[np.ndarray]
) -> list[tuple[int, np.ndarray]]:
    """Return a number and its place for each side of each seam, near the middle of the side and inside the piece.

    The numbers avoid all lines, each other and the places in `taken`. A seam without room has no number. offset: usual
    distance from the seam.
    """
    rows_of: dict[frozenset[int], list[int]] = {}
    for row, pair in enumerate(pieces.source_vertex[pieces.outline].tolist()):
        rows_of.setdefault(frozenset(pair), []).append(row)
    lines = points[np.unique(np.concatenate([pieces.outline, pieces.wires]))]
    labels: list[tuple[int, np.ndarray]] = []
    for seam in seams:
        # a row is empty for a piece without a layout
        rows = [rows_of.get(frozenset(edge), []) for edge in seam["edges"]]
        numbers = [*taken, *(place for _, place in labels)]
        for distance in (offset, NARROW * offset):
            room, places = _best_places(pieces, points, rows, distance, (lines, numbers))
            if room >= ROOM * offset:
                labels += [(seam["index"] + 1, place) for place in places]
                break
    return labels


def _best_places(
    pieces: Flat, points: np.ndarray, rows: list[list[int]], offset: float, obstacles: tuple
) -> tuple[float, list[np.ndarray]]:
    """Return the space around the numbers at the best edge of a seam, and their places on its sides.

    rows: for each edge of the seam, its rows in pieces.outline; obstacles: points of lines, and places of numbers.
    """
    lines, numbers = obstacles
    best: tuple[float, float, list[np.ndarray]] = (-np.inf, 0.0, [])
    for step, sides in enumerate(rows):
        places = [_beside(pieces, points, row, offset) for row in sides]
        if not places:
            continue
        room = min(np.linalg.norm(lines - place, axis=1).min() for place in places)
        for number in numbers:  # each number gets half of the space between two numbers
            room = min(room, *(np.linalg.norm(number - place) / 2 for place in places))
        off_middle = abs((step + 0.5) / len(rows) - 0.5)
        best = max(best, (min(room, offset) - 0.5 * offset * off_middle, room, places), key=lambda choice: choice[0])
    return best[1], best[2]


def _beside(pieces: Flat, points: np.ndarray, row: int, offset: float) -> np.ndarray:
    """Return the point inside the piece at this distance from the middle of an outline edge."""
    a, b = points[pieces.outline[row]]
    at_edge = np.isin(pieces.triangles, pieces.outline[row]).sum(axis=1) == 2
    normal = np.array([a[1] - b[1], b[0] - a[0], 0]) / np.linalg.norm(b - a)
    center = points[pieces.triangles[at_edge][0]].mean(axis=0)
    return (a + b) / 2 + offset * normal * np.sign((center - a) @ normal)
