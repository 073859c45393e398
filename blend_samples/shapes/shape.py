# SPDX-License-Identifier: GPL-3.0-or-later
"""A sample surface with its seams and wires, and the builder that welds it together from patches."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

FAIRNESS = 0.05  # the default of wirewarp.Options
ALLOWANCE = 10.0  # mm, the default of the add-on
WELD_DISTANCE = 1e-7  # meters; common points of a sample's patches are equal to about 1e-15


@dataclass
class Wire:
    """A line with a measured length: a chain of vertices joined by edges; a closed one repeats its first vertex."""

    vertices: list[int]
    name: str
    tolerance: float = 0.0


@dataclass
class Ease:
    """A side of a seam, or a section of outline, that is cut longer than on the surface."""

    half_edges: np.ndarray  # (k, 2); an edge from a to b is the side of the face with a, b in its own order
    ratio: float  # 0.05 for 5%


@dataclass
class Shape:
    """A surface in meters, of quads and triangles that are counter-clockwise from outside."""

    name: str
    vertices: np.ndarray  # (n, 3)
    faces: list[tuple[int, ...]]
    seams: np.ndarray  # (k, 2) vertex pairs
    wires: list[Wire] = field(default_factory=list)
    eases: list[Ease] = field(default_factory=list)
    cloth: str = ""  # a name in wirewarp.Cloth.presets() that stretches far enough; empty: any fabric does
    stretch: tuple[float, float] = (0.0, 0.0)  # stretch of that fabric when worn, across and along the grain
    fairness: float = FAIRNESS  # option of wirewarp.Options
    allowance: float = ALLOWANCE  # seam allowance in mm
    groups: dict[str, list[int]] = field(default_factory=dict)  # vertices of parts that give pieces their names

    def triangles(self) -> np.ndarray:
        """Return triangles (m, 3); quads are divided from their first to their third corner, like in Blender."""
        return np.array([(face[0], face[k], face[k + 1]) for face in self.faces for k in range(1, len(face) - 1)])


def chain_of(edges: np.ndarray) -> list[int]:
    """Return the vertices of a seam (k, 2) in order."""
    first, *others = edges.tolist()
    if others and first[0] in others[0] and first[1] not in others[0]:
        first.reverse()
    chain = list(first)
    for a, b in others:
        chain.append(b if a == chain[-1] else a)
    return chain


class ShapeBuilder:
    """Collects patches; points closer than WELD_DISTANCE become one vertex."""

    def __init__(self) -> None:
        self._points: list[np.ndarray] = []
        self._index_of: dict[tuple[int, ...], int] = {}
        self._faces: list[tuple[int, ...]] = []
        self._seams: set[tuple[int, int]] = set()
        self._wires: list[Wire] = []
        self._eases: list[Ease] = []
        self._groups: dict[str, np.ndarray] = {}

    def add_points(self, points: np.ndarray) -> np.ndarray:
        """Return vertex indices of an array of points (..., 3), in shape (...)."""
        flat = points.reshape(-1, 3)
        # The offset keeps round coordinates (0, 0.05, ...) away from the borders of the welding cells.
        cells = np.floor((flat + 0.3183 * WELD_DISTANCE) / WELD_DISTANCE).astype(np.int64)
        indices = []
        for point, cell in zip(flat, cells, strict=True):
            index = self._index_of.setdefault(tuple(cell), len(self._points))
            if index == len(self._points):
                self._points.append(point)
            indices.append(index)
        return np.array(indices).reshape(points.shape[:-1])

    def add_grid(self, points: np.ndarray, flip: bool = False, holes: np.ndarray | None = None) -> np.ndarray:
        """Add quads between the rows of points (r, c, 3), with rows upward and columns to the right unless flipped.

        holes (r - 1, c - 1) is true where there is no quad.
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
        """Add one triangle or quad; a quad starts at an end of its shorter diagonal, which will divide it."""
        corners = tuple(int(c) for c in (corners[::-1] if flip else corners))
        if len(corners) == 4:
            a, b, c, d = (self._points[v] for v in corners)
            if np.linalg.norm(b - d) < (1 - 1e-9) * np.linalg.norm(a - c):
                corners = corners[1:] + corners[:1]
        self._faces.append(corners)

    def relax(self, share: Callable[[np.ndarray], np.ndarray], rounds: int) -> None:
        """Move every vertex by that share towards the mean of its neighbors along edges of quads and triangles.

        share(points) returns numbers (n,) from 0 to 1 for points (n, 3). Open edges do not move.
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
        """Make the left side of a chain of vertices longer, as seen from outside along the chain."""
        self._eases.append(Ease(np.column_stack([chain[:-1], chain[1:]]), ratio))

    def add_group(self, vertices: np.ndarray, name: str) -> None:
        """Name pieces with these vertices."""
        self._groups[name] = np.unique(vertices)

    def build(
        self,
        name: str,
        cloth: str = "",
        stretch: tuple[float, float] = (0.0, 0.0),
        fairness: float = FAIRNESS,
        allowance: float = ALLOWANCE,
    ) -> Shape:
        """Return the finished surface, without the points inside holes. The other arguments are fields of Shape."""
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
