# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the sheets that every method flattens."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Surface:
    name: str
    vertices: np.ndarray  # (n, 3)
    faces: np.ndarray  # (m, 3)
    seams: np.ndarray  # (k, 2) vertex pairs
    pieces: list[np.ndarray]  # faces of each piece between seams
    few_wires: list[np.ndarray]  # chains of vertices
    many_wires: list[np.ndarray]  # chains of vertices; length errors of all methods are measured on these wires


def wires_across(lines: np.ndarray, number: int) -> list[np.ndarray]:
    """Return straight wires as in native/bench/bumpy_sheet.h, half in each direction. lines (n, n): vertices."""
    n = len(lines) - 1
    at = [k * n // (number // 2 + 1) for k in range(1, number // 2 + 1)]
    return [chain for k in at for chain in (lines[k, :], lines[:, k])]


def bumpy_sheet(triangles: int, in_two_pieces: bool = False, jitter: float = 0.0, wires: int = 8) -> Surface:
    """Return the sheet of native/bench/bumpy_sheet.h, 2 units wide. In two pieces, it is 0.5 m wide.

    jitter: largest shift of inner vertices in x and y, in grid edges
    wires: an even number
    """
    n = round((triangles / 2) ** 0.5)
    side = np.linspace(-1.0, 1.0, n + 1)
    grid = np.stack(np.meshgrid(side, side))
    grid[:, 1:-1, 1:-1] += np.random.default_rng(1).uniform(-jitter, jitter, (2, n - 1, n - 1)) * 2 / n
    x, y = (c.ravel() for c in grid)
    lines = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)  # [row, column]
    a, b, c, d = (q.ravel() for q in (lines[:-1, :-1], lines[:-1, 1:], lines[1:, 1:], lines[1:, :-1]))
    faces = np.stack([np.column_stack([a, b, c]), np.column_stack([a, c, d])], axis=1).reshape(-1, 3)
    vertices = np.column_stack([x, y, 0.3 * np.sin(3.1 * x + 0.4) * np.cos(2.7 * y - 0.3)])
    seams, pieces = np.zeros((0, 2), dtype=int), [np.arange(len(faces))]
    if in_two_pieces:
        vertices *= 0.25
        cut = lines[:, n // 3]  # a line without a wire
        seams = np.column_stack([cut[:-1], cut[1:]])
        is_left = (faces % (n + 1)).max(axis=1) <= n // 3
        pieces = [np.flatnonzero(is_left), np.flatnonzero(~is_left)]
    return Surface(
        name=f"{len(faces):,}" + (f", {wires} wires" if wires != 8 else "") + (", jittered" if jitter else ""),
        vertices=vertices,
        faces=faces,
        seams=seams,
        pieces=pieces,
        few_wires=wires_across(lines, 2),
        many_wires=wires_across(lines, wires),
    )
