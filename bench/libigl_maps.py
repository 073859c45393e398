# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps a piece to the plane with libigl, starting from the harmonic map to a disk. These maps do not keep lengths.

arap() and slim() return positions (n, 2) and the number of iterations.
"""

import igl
import numpy as np

ITERATIONS = 10
MOST_ITERATIONS = 1000
STILL = 1e-4  # share of the piece's width; the map has converged if ten iterations move no vertex farther

Map = tuple[np.ndarray, int]


def harmonic_start(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the harmonic map (n, 2) to a disk with the piece's area, and the vertices of the longest outline."""
    boundary = igl.boundary_loop(faces)
    radius = np.sqrt(igl.doublearea(vertices, faces).sum() / 2 / np.pi)
    circle = radius * igl.map_vertices_to_circle(vertices, boundary)
    return igl.harmonic(vertices, faces, boundary, circle, 1), boundary


def has_converged(before: np.ndarray, after: np.ndarray) -> bool:
    """Return whether the map has converged. Translations do not count, because SLIM fixes no vertex."""
    move = after - before
    return np.abs(move - move.mean(axis=0)).max() <= STILL * np.ptp(after, axis=0).max()


def arap(vertices: np.ndarray, faces: np.ndarray, most_iterations: int) -> Map:
    """Return the as-rigid-as-possible map, by local/global iterations."""
    start, boundary = harmonic_start(vertices, faces)
    data = igl.ARAPData()
    data.max_iter = ITERATIONS
    igl.arap_precomputation(vertices, faces, 2, boundary[:1].astype(np.int32), data)
    uv = igl.arap_solve(start[boundary[:1]], data, start)
    for iterations in range(ITERATIONS, most_iterations, ITERATIONS):
        before, uv = uv, igl.arap_solve(start[boundary[:1]], data, uv)
        if has_converged(before, uv):
            return uv, iterations + ITERATIONS
    return uv, most_iterations


def slim(vertices: np.ndarray, faces: np.ndarray, most_iterations: int) -> Map:
    """Return the map of SLIM, which minimizes the symmetric Dirichlet energy. This energy prevents flips."""
    start, _ = harmonic_start(vertices, faces)
    nothing_fixed = np.zeros(0, dtype=np.int32), np.zeros((0, 2))
    energy = igl.MappingEnergyType.SYMMETRIC_DIRICHLET
    data = igl.slim_precompute(vertices, faces.astype(np.int32), start, energy, *nothing_fixed, 0.0)
    uv = igl.slim_solve(data, ITERATIONS)[:, :2]
    for iterations in range(ITERATIONS, most_iterations, ITERATIONS):
        before, uv = uv, igl.slim_solve(data, ITERATIONS)[:, :2]
        if has_converged(before, uv):
            return uv, iterations + ITERATIONS
    return uv, most_iterations
