# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark sheet flattened with WireWarp and with libigl's ARAP and SLIM, turn by turn."""

import os
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

os.environ["IGL_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"  # read when the modules are loaded

import igl
import numpy as np
import wirewarp

ITERATIONS = 10
PEER = "libigl ARAP"
SLIM = "libigl SLIM"
WARPED_ELASTIC = "wirewarp++, 8 wires ±3 %"
LARGEST_FOR_SLIM = 10_000  # triangles: above, it takes longer than all others together


@dataclass
class Sheet:
    vertices: np.ndarray  # (n, 3)
    faces: np.ndarray  # (m, 3)
    lines: np.ndarray  # (n, n) vertices, row by row

    def wires(self, number: int, tolerance: float = 0.0) -> list[wirewarp.Wire]:
        """Straight across, half of them in each direction, as in native/bench/bumpy_sheet.h."""
        n = len(self.lines) - 1
        at = [k * n // (number // 2 + 1) for k in range(1, number // 2 + 1)]
        return [wirewarp.Wire(chain, tolerance) for k in at for chain in (self.lines[k, :], self.lines[:, k])]


def bumpy_sheet(triangles: int) -> Sheet:
    """The sheet of native/bench/bumpy_sheet.h."""
    n = round((triangles / 2) ** 0.5)
    side = np.linspace(-1.0, 1.0, n + 1)
    x, y = (c.ravel() for c in np.meshgrid(side, side))
    index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)  # [row, column]
    a, b, c, d = (q.ravel() for q in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    return Sheet(
        vertices=np.column_stack([x, y, 0.3 * np.sin(3.1 * x + 0.4) * np.cos(2.7 * y - 0.3)]),
        faces=np.stack([np.column_stack([a, b, c]), np.column_stack([a, c, d])], axis=1).reshape(-1, 3),
        lines=index,
    )


def flatten(method: str, wires: int, tolerance: float = 0.0) -> Callable[[Sheet], wirewarp.FlattenResult]:
    options = wirewarp.Options(method=method)
    return lambda sheet: wirewarp.flatten(
        sheet.vertices, sheet.faces, wires=sheet.wires(wires, tolerance), options=options
    )


def harmonic_start(sheet: Sheet) -> tuple[np.ndarray, np.ndarray]:
    """The harmonic map to a disk of the sheet's area, (n, 2), and the vertices of the outline."""
    vertices, faces = sheet.vertices, sheet.faces
    boundary = igl.boundary_loop(faces)
    radius = np.sqrt(igl.doublearea(vertices, faces).sum() / 2 / np.pi)
    circle = radius * igl.map_vertices_to_circle(vertices, boundary)
    return igl.harmonic(vertices, faces, boundary, circle, 1), boundary


def libigl_arap_uv(sheet: Sheet) -> np.ndarray:
    """(m, 3, 2) corner positions by local/global iterations."""
    start, boundary = harmonic_start(sheet)
    data = igl.ARAPData()
    data.max_iter = ITERATIONS
    igl.arap_precomputation(sheet.vertices, sheet.faces, 2, boundary[:1].astype(np.int32), data)
    return igl.arap_solve(start[boundary[:1]], data, start)[sheet.faces]


def libigl_slim_uv(sheet: Sheet) -> np.ndarray:
    """(m, 3, 2) corner positions of the least symmetric Dirichlet energy, which keeps triangles from flipping."""
    start, _ = harmonic_start(sheet)
    nothing_fixed = np.zeros(0, dtype=np.int32), np.zeros((0, 2))
    data = igl.slim_precompute(
        sheet.vertices,
        sheet.faces.astype(np.int32),
        start,
        igl.MappingEnergyType.SYMMETRIC_DIRICHLET,
        *nothing_fixed,
        0.0,
    )
    return igl.slim_solve(data, ITERATIONS)[:, :2][sheet.faces]


METHODS: dict[str, Callable[[Sheet], wirewarp.FlattenResult | np.ndarray]] = {
    "refined, 2 rigid wires": flatten("refined", 2),
    "refined, 8 rigid wires": flatten("refined", 8),
    "refined, 8 wires ±3 %": flatten("refined", 8, 0.03),
    "wirewarp++, 2 rigid wires": flatten("wirewarp++", 2),
    WARPED_ELASTIC: flatten("wirewarp++", 8, 0.03),
    PEER: libigl_arap_uv,
    SLIM: libigl_slim_uv,
}


@dataclass
class Comparison:
    triangles: int
    seconds: dict[str, float]  # of each method, the median of its rounds
    results: dict[str, wirewarp.FlattenResult]  # those of libigl measured against 8 rigid wires


def compare(triangles: int) -> Comparison:
    sheet = bumpy_sheet(triangles)
    methods = METHODS if triangles <= LARGEST_FOR_SLIM else {n: m for n, m in METHODS.items() if n != SLIM}
    rounds = 5 if triangles <= 100_000 else 1
    seconds: dict[str, list[float]] = {name: [] for name in methods}
    results = {}
    for _ in range(rounds):
        for name, method in methods.items():
            begin = time.perf_counter()
            results[name] = method(sheet)
            seconds[name].append(time.perf_counter() - begin)
    for name in results.keys() & {PEER, SLIM}:
        results[name] = wirewarp.measure(sheet.vertices, sheet.faces, results[name], wires=sheet.wires(8))
    return Comparison(len(sheet.faces), {name: statistics.median(times) for name, times in seconds.items()}, results)
