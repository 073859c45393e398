# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures cuts and distortion of a flat shape, in the same way for all methods."""

from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np

MOST_OF_AREA = 0.99  # share of the area that counts, as in DartProposal.strain


@dataclass(frozen=True)
class CutFigures:
    # symmetric Dirichlet energy: the mean over the area of |J|² + |J⁻¹|², in which J is the Jacobian of the map to the
    # plane; 4 without distortion
    energy: float
    strain: float  # DartProposal.strain of the whole surface
    length: float  # length of all cuts on the surface, each edge counted once, divided by √area
    # The differences between the flat lengths of both sides of each cut edge are added. The sum is divided by the
    # length of all cuts on the surface. 0.01 is 10 mm per meter of cut.
    mismatch: float
    charts: int
    flipped: int


def read_corner_uv(path: Path) -> np.ndarray:
    """Return texture coordinates (m, 3, 2) of the corners from an OBJ file of triangles."""
    uv, corners = [], []
    for line in path.read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "vt":
            uv.append([float(word) for word in words[:2]])
        elif kind == "f":
            corners.append([int(word.split("/")[1]) - 1 for word in words])
    return np.array(uv)[np.array(corners)]


def measure_cuts(vertices: np.ndarray, faces: np.ndarray, corner_uv: np.ndarray) -> CutFigures:
    """Return the figures. At a cut, two triangles have different corner_uv (m, 3, 2) for the same vertex."""
    points = vertices[faces]
    areas = np.linalg.norm(np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1) / 2
    values, is_flipped = stretches(points, corner_uv)
    edges, sides, charts = cuts_of(faces, corner_uv)
    lengths = np.linalg.norm(vertices[edges[:, 1]] - vertices[edges[:, 0]], axis=1)
    strains = np.maximum(values[:, 0], 1 / values[:, 1]) - 1
    return CutFigures(
        energy=float(np.average((values**2 + values**-2.0).sum(axis=1), weights=areas)),
        strain=most_stay_below(strains, areas),
        length=float(lengths.sum() / np.sqrt(areas.sum())),
        mismatch=float(np.abs(sides[:, 0] - sides[:, 1]).sum() / lengths.sum()) if len(lengths) else 0.0,
        charts=charts,
        flipped=int(is_flipped.sum()),
    )


def stretches(points: np.ndarray, corner_uv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the singular values (m, 2) of each triangle's map to the plane, larger first, and which triangles are
    flipped.
    """
    edges, flat = points[:, 1:] - points[:, :1], corner_uv[:, 1:] - corner_uv[:, :1]
    along = np.linalg.norm(edges[:, 0], axis=1)
    x = (edges[:, 0] * edges[:, 1]).sum(axis=1) / along
    y = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) / along
    first = flat[:, 0] / along[:, None]
    second = (flat[:, 1] - first * x[:, None]) / y[:, None]
    jacobian = np.stack([first, second], axis=2)
    return np.linalg.svd(jacobian, compute_uv=False), np.linalg.det(jacobian) <= 0


def most_stay_below(strains: np.ndarray, areas: np.ndarray) -> float:
    order = np.argsort(strains)
    return float(strains[order][np.searchsorted(areas[order].cumsum(), MOST_OF_AREA * areas.sum())])


def cuts_of(faces: np.ndarray, corner_uv: np.ndarray) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the cut edges (k, 2), the two flat lengths (k, 2) of each, and the number of charts."""
    neighbors = defaultdict(list)
    for f, face in enumerate(faces):
        for i in range(3):
            a, b = (int(face[i]), corner_uv[f, i]), (int(face[i - 2]), corner_uv[f, i - 2])
            (start, start_uv), (end, end_uv) = (a, b) if a[0] < b[0] else (b, a)
            neighbors[start, end].append((f, start_uv, end_uv))
    chart = list(range(len(faces)))
    edges, sides = [], []
    for (start, end), around in neighbors.items():
        if len(around) < 2:
            continue  # an edge on the outline of the surface is not a cut
        (f, f_start, f_end), (g, g_start, g_end) = around
        if (f_start == g_start).all() and (f_end == g_end).all():
            chart[root(chart, f)] = root(chart, g)
        else:
            edges.append((start, end))
            sides.append((np.linalg.norm(f_end - f_start), np.linalg.norm(g_end - g_start)))
    charts = len({root(chart, f) for f in range(len(faces))})
    return np.array(edges, dtype=int).reshape(-1, 2), np.array(sides).reshape(-1, 2), charts


def root(parent: list[int], item: int) -> int:
    while parent[item] != item:
        parent[item] = item = parent[parent[item]]
    return item
