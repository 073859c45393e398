# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines sample surfaces with seams and wires, and the builder that joins patches to a surface."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

FAIRNESS = 0.05  # the default of wirewarp.Options
ALLOWANCE = 10.0  # mm, the default of the add-on
WELD_DISTANCE = 1e-7  # meters; rounding moves common points of patches apart by about 1e-15


@dataclass
class Wire:
    """A measuring line: a chain of vertices joined by edges. A closed chain repeats its first vertex."""

    vertices: list[int]
    name: str
    tolerance: float = 0.0


@dataclass
class Ease:
    """A side of a seam, or a section of outline, that is cut longer than on the surface."""

    half_edges: np.ndarray  # (k, 2) vertices a and b of each edge, on the side of the face that has b after a
    ratio: float  # 0.05 for 5%


@dataclass
class Shape:
    """A surface of quads and triangles, in meters. Faces are counter-clockwise as seen from outside."""

    name: str
    vertices: np.ndarray  # (n, 3)
    faces: list[tuple[int, ...]]
    seams: np.ndarray  # (k, 2) vertex pairs
    wires: list[Wire] = field(default_factory=list)
    eases: list[Ease] = field(default_factory=list)
    cloth: str = ""  # fabric of wirewarp.Cloth.presets() that stretches far enough; empty if every fabric does
    stretch: tuple[float, float] = (0.0, 0.0)  # stretch of the fabric when worn, across and along the grain
    fairness: float = FAIRNESS  # option of wirewarp.Options
    allowance: float = ALLOWANCE  # seam allowance in mm
    groups: dict[str, list[int]] = field(default_factory=dict)  # vertices of parts, by the name for their pieces

    def triangles(self) -> np.ndarray:
        """Return triangles (m, 3). Quads are divided from their first to their third corner, as in Blender."""
        return np.array([(face[0], face[k], face[k + 1]) for face in self.faces for k in range(1, len(face) - 1)])


def chain_of(edges: np.ndarray) -> list[int]:
    """Return the vertices of a seam in order. edges (k, 2): in order, but each in any direction."""
    first, *others = edges.tolist()
    if others and first[0] in others[0] and first[1] not in others[0]:
        first.reverse()
    chain = list(first)
    for a, b in others:
        chain.append(b if a == chain[-1] else a)
    return chain


class ShapeBuilder:
    """Collects the patches of a surface. Points closer than WELD_DISTANCE become one vertex."""

    def __init__(self) -> None:
        self._points: list[np.ndarray] = []
        self._index_of: dict[tuple[int, ...], int] = {}
        self._faces: list[tuple[int, ...]] = []
        self._seams: set[tuple[int, int]] = set()
        self._wires: list[Wire] = []
        self._eases: list[Ease] = []
        self._groups: dict[str, np.ndarray] = {}

    def add_points(self, points: np.ndarray) -> np.ndarray:
        """Return the vertex indices (...) of points (..., 3). Points without a vertex get new vertices."""
        flat = points.reshape(-1, 3)
        # Without the offset, round coordinates (0, 0.05, ...) would be at borders of cells, and rounding errors could
        # put equal points into different cells.
        cells = np.floor((flat + 0.3183 * WELD_DISTANCE) / WELD_DISTANCE).astype(np.int64)
        indices = []
        for point, cell in zip(flat, cells, strict=True):
            index = self._index_of.setdefault(tuple(cell), len(self._points))
            if index == len(self._points):
                self._points.append(point)
            indices.append(index)
        return np.array(indices).reshape(points.shape[:-1])

    def add_grid(self, points: np.ndarray, flip: bool = False, holes: np.ndarray | None = None) -> np.ndarray:
        """Add quads between the rows of points (r, c, 3). Return the vertices (r, c).

        Seen from outside, rows run upward and columns to the right, or to the left if flip is true. holes (r - 1, c -
        1): true for missing quads.
        """
        grid = self.add_points(points)
        for row, (lower, upper) in enumerate(zip(grid[:-1], grid[1:], strict=True)):
            for column, corners in enumerate(zip(lower[:-1], lower[1:], upper[1:], upper[:-1], strict=True)):
                if holes is None or not holes[row, column]:
                    self.add_face(corners, flip)
        return grid

    def points(self, vertices: np.ndarray) -> np.ndarray:
        """Return positions (..., 3) of vertices (...)."""
        return np.array(self._points)[vertices]

    def add_face(self, corners: tuple[int, ...], flip: bool = False) -> None:
        """Add a triangle or a quad. A quad starts at an end of its shorter diagonal, along which it is divided."""
        corners = tuple(int(c) for c in (corners[::-1] if flip else corners))
        if len(corners) == 4:
            a, b, c, d = (self._points[v] for v in corners)
            if np.linalg.norm(b - d) < (1 - 1e-9) * np.linalg.norm(a - c):
                corners = corners[1:] + corners[:1]
        self._faces.append(corners)

    def relax(self, share: Callable[[np.ndarray], np.ndarray], rounds: int) -> None:
        """Move every vertex toward the mean of its neighbors along edges of faces, `rounds` times.

        share(points) returns the share of the way (n,), from 0 to 1, for points (n, 3). Outlines do not move.
        """
        sides = np.concatenate([np.column_stack([face, np.roll(face, -1)]) for face in self._faces])
        edges, use = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
        points = np.array(self._points)
        strength = share(points)
        strength[edges[use == 1]] = 0
        count = np.bincount(edges.ravel(), minlength=len(points))
        for _ in range(rounds):
            total = np.zeros_like(points)
            for a, b in ((0, 1), (1, 0)):
                np.add.at(total, edges[:, a], points[edges[:, b]])
            points += strength[:, None] * (total / count[:, None] - points)
        self._points = list(points)

    def add_seam(self, chain: np.ndarray) -> None:
        """Cut the surface along a chain of vertices."""
        self._seams.update((int(min(a, b)), int(max(a, b))) for a, b in zip(chain[:-1], chain[1:], strict=True))

    def add_wire(self, chain: np.ndarray, name: str, tolerance: float = 0.0) -> None:
        """Mark a wire along a chain of vertices: rigid, or elastic with a tolerance, 0.05 for 5%."""
        self._wires.append(Wire([int(v) for v in chain], name, tolerance))

    def add_ease(self, chain: np.ndarray, ratio: float) -> None:
        """Make the left side of a chain of vertices longer, as seen from outside in the direction of the chain."""
        self._eases.append(Ease(np.column_stack([chain[:-1], chain[1:]]), ratio))

    def add_group(self, vertices: np.ndarray, name: str) -> None:
        """Name the pieces that these vertices form."""
        self._groups[name] = np.unique(vertices)

    def build(
        self,
        name: str,
        cloth: str = "",
        stretch: tuple[float, float] = (0.0, 0.0),
        fairness: float = FAIRNESS,
        allowance: float = ALLOWANCE,
    ) -> Shape:
        """Return the finished surface without unused points, such as points in holes. Arguments are fields of Shape."""
        used = np.unique(np.concatenate(self._faces))
        number = np.full(len(self._points), -1)
        number[used] = np.arange(len(used))
        faces = [tuple(number[list(face)].tolist()) for face in self._faces]
        seams = number[np.array(sorted(self._seams), dtype=np.int64).reshape(-1, 2)]
        wires = [Wire(number[wire.vertices].tolist(), wire.name, wire.tolerance) for wire in self._wires]
        eases = [Ease(number[ease.half_edges], ease.ratio) for ease in self._eases]
        groups = {part: number[np.intersect1d(own, used)].tolist() for part, own in self._groups.items()}
        vertices = np.array(self._points)[used]
        return Shape(name, vertices, faces, seams, wires, eases, cloth, stretch, fairness, allowance, groups)
