# SPDX-License-Identifier: GPL-3.0-or-later
"""Where numbers stand on flat pieces. Needs numpy alone."""

from __future__ import annotations

import numpy as np

from .surfaces import Flat


def inside_point(candidates: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """The candidate (k, 3) that is farthest from all points of lines (n, 3)."""
    distance = [np.min(np.linalg.norm(lines - candidate, axis=1)) for candidate in candidates]
    return candidates[int(np.argmax(distance))]


def seam_labels(pieces: Flat, points: np.ndarray, seams: list[dict], offset: float) -> list[tuple[int, np.ndarray]]:
    """(number, place) beside each side of each seam, offset into the piece, near the middle but clear of the wires."""
    rows_of: dict[frozenset[int], list[int]] = {}
    for row, pair in enumerate(pieces.source_vertex[pieces.outline].tolist()):
        rows_of.setdefault(frozenset(pair), []).append(row)
    wire_points = points[np.unique(pieces.wires)]
    labels = []
    for seam in seams:
        best: tuple[float, list[np.ndarray]] = (-np.inf, [])
        for step, edge in enumerate(seam["edges"]):
            places = [_beside(pieces, points, row, offset) for row in rows_of.get(frozenset(edge), [])]
            if not places:
                continue  # a piece without a layout
            clear = min(np.linalg.norm(wire_points - place, axis=1).min() for place in places)
            off_middle = abs((step + 0.5) / len(seam["edges"]) - 0.5)
            best = max(best, (min(clear, 1.3 * offset) - offset * off_middle, places), key=lambda choice: choice[0])
        labels += [(seam["index"] + 1, place) for place in best[1]]
    return labels


def _beside(pieces: Flat, points: np.ndarray, row: int, offset: float) -> np.ndarray:
    """The point at a distance from the middle of an outline edge, inside its piece."""
    a, b = points[pieces.outline[row]]
    at_edge = np.isin(pieces.triangles, pieces.outline[row]).sum(axis=1) == 2
    normal = np.array([a[1] - b[1], b[0] - a[0], 0]) / np.linalg.norm(b - a)
    center = points[pieces.triangles[at_edge][0]].mean(axis=0)
    return (a + b) / 2 + offset * normal * np.sign((center - a) @ normal)
