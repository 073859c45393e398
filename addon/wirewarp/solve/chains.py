# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds edges by their vertices, and orders edges as chains."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

# At a vertex with three or another odd number of edges, a line continues only if it turns by less than 45 degrees.
STRAIGHT_COSINE = np.cos(np.radians(45.0))


def are_among(pairs: ArrayLike, edges: ArrayLike) -> np.ndarray:
    """Return a mask (k,) of the vertex pairs (k,2) that are among the edges (e,2), in either direction."""
    keys, wanted = _edge_keys(edges, pairs)
    return np.isin(wanted, keys)


def find_edges(pairs: ArrayLike, edges: ArrayLike) -> np.ndarray:
    """Return the index (k,) of the first of the edges (e,2) between each pair of vertices (k,2); -1 if none exists."""
    keys, wanted = _edge_keys(edges, pairs)
    if not len(keys):
        return np.full(len(wanted), -1)
    order = np.argsort(keys, kind="stable")
    found = order[np.searchsorted(keys, wanted, sorter=order).clip(max=len(keys) - 1)]
    return np.where(keys[found] == wanted, found, -1)


def _edge_keys(*lists: ArrayLike) -> list[np.ndarray]:
    """Return, for each list, one number for each pair of vertices. The order of the two vertices does not matter."""
    pairs = [np.asarray(each, dtype=np.int64).reshape(-1, 2) for each in lists]
    count = 1 + max(int(each.max(initial=0)) for each in pairs)
    return [np.sort(each, axis=1) @ np.array([count, 1]) for each in pairs]


def next_corners(sizes: np.ndarray) -> np.ndarray:
    """Return, for each corner, the next corner of its face, (l,). sizes (f,): number of corners of each face; the
    corners are numbered face by face."""
    starts = np.cumsum(sizes) - sizes
    following = np.arange(1, sizes.sum() + 1)
    following[starts + sizes - 1] = starts
    return following


@dataclass(frozen=True)
class Chain:
    """A connected run of edges. A closed run repeats its first vertex at the end."""

    edges: list[int]  # rows of the edge array, in order along the run
    vertices: list[int]  # in order along the run, one more than edges


@dataclass(frozen=True)
class EdgeMarks:
    """Wires with tolerances and eases: one entry per edge of a mesh, or of some of its edges."""

    wire_ids: np.ndarray  # (e,) int32, 0 none
    tolerances: np.ndarray  # (e,) float32; 0: rigid, finite: elastic, infinite: super-elastic
    eases: np.ndarray  # (e,) float32: relative change of length, 0.05 is 5%

    @classmethod
    def none(cls, count: int) -> "EdgeMarks":
        return cls(np.zeros(count, dtype=np.int32), *(np.zeros(count, dtype=np.float32) for _ in range(2)))

    @property
    def are_wires(self) -> np.ndarray:
        return self.wire_ids != 0

    @property
    def rows(self) -> np.ndarray:
        return np.flatnonzero(self.wire_ids)

    def take(self, rows: np.ndarray) -> "EdgeMarks":
        """Return the marks of these edges. rows: their numbers, or a mask."""
        return EdgeMarks(self.wire_ids[rows], self.tolerances[rows], self.eases[rows])

    def without(self, mask: np.ndarray) -> "EdgeMarks":
        """Return the marks of all edges; edges of the mask are not wires in the result."""
        return EdgeMarks(np.where(mask, 0, self.wire_ids), self.tolerances, self.eases)


@dataclass(frozen=True)
class WireChain:
    """A run of edges with one id, one tolerance and one ease."""

    wire_id: int
    tolerance: float
    ease: float
    edges: list[int]  # rows of the edge array, in order along the run
    vertices: list[int]  # in order along the run, one more than edges


def split_into_chains(edges: np.ndarray, positions: np.ndarray) -> list[Chain]:
    """Return the chains of edges (k,2). positions (n,3): places of the vertices.

    - Two edges at a vertex: the chain continues.
    - Even number: chains continue as straight as possible, so that crossing lines stay whole.
    - Odd number: one chain ends, and chains that would turn by 45 degrees or more end, too.
    """
    following, vertex_of_side = _pair_sides(edges, positions).tolist(), edges.ravel().tolist()
    used = [False] * len(edges)
    open_ends = [side for side, next_side in enumerate(following) if next_side < 0]
    first_sides = range(0, 2 * len(edges), 2)  # for closed chains, which may start at any edge
    return [
        _walk(start, vertex_of_side, following, used) for start in [*open_ends, *first_sides] if not used[start // 2]
    ]


def chains_of_marks(edges: np.ndarray, marks: EdgeMarks, positions: np.ndarray) -> list[WireChain]:
    """Return all marked edges as wires, one for each run with one id, one tolerance and one ease."""
    marked = marks.rows
    ids, tolerances = marks.wire_ids[marked].tolist(), _shortest_doubles(marks.tolerances[marked])
    groups: dict[tuple[int, float, float], list[int]] = {}
    for edge, *kind in zip(marked.tolist(), ids, tolerances, _shortest_doubles(marks.eases[marked]), strict=True):
        groups.setdefault(tuple(kind), []).append(edge)
    return [
        WireChain(*kind, [members[edge] for edge in chain.edges], chain.vertices)
        for kind, members in groups.items()
        for chain in split_into_chains(edges[members], positions)
    ]


def shortest_double(value: np.float32) -> float:
    """Return the shortest decimal number with this float32 value: 0.03 as entered by the user, not 0.029999999329."""
    number = float(str(np.float32(value)))
    # NaN is always the same object, so that edges with NaN belong to one wire.
    return math.nan if math.isnan(number) else number


def _shortest_doubles(values: np.ndarray) -> list[float]:
    """Return shortest_double of each value. Equal values get the same object, even NaN, so that equal edges belong to
    one wire."""
    kinds, kind_of_value = np.unique(values, return_inverse=True)
    doubles = [shortest_double(kind) for kind in kinds]
    return [doubles[kind] for kind in kind_of_value.ravel().tolist()]


def _pair_sides(edges: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """Return, for each side, the side of the next edge of its chain at the same vertex; -1 if the chain ends there.
    Side 2e+s is edge e at its vertex edges[e,s]."""
    vertex_of_side = edges.ravel()
    following = np.full(len(vertex_of_side), -1, dtype=np.int64)
    order = np.argsort(vertex_of_side, kind="stable")
    starts = np.flatnonzero(np.diff(vertex_of_side[order], prepend=-1))
    counts = np.diff(starts, append=len(order))
    twos = starts[counts == 2]
    following[order[twos]] = order[twos + 1]
    following[order[twos + 1]] = order[twos]
    for start, count in zip(starts[counts > 2].tolist(), counts[counts > 2].tolist(), strict=True):
        for side, other in _straightest_pairs(order[start : start + count], edges, positions):
            following[side], following[other] = other, side
    return following


def _straightest_pairs(sides: np.ndarray, edges: np.ndarray, positions: np.ndarray) -> list[tuple[int, int]]:
    """Return pairs of these sides of edges at one vertex, the straightest pair first. If the number of sides is odd,
    at least one side stays single."""
    here, there = edges.ravel()[sides], edges.ravel()[sides ^ 1]
    directions = positions[there] - positions[here]
    directions = directions / np.maximum(np.linalg.norm(directions, axis=1), np.finfo(float).tiny)[:, None]
    straightness = -directions @ directions.T  # cosine of the turning angle
    limit = STRAIGHT_COSINE if len(sides) % 2 else -np.inf
    rows, columns = np.triu_indices(len(sides), 1)
    free = np.ones(len(sides), dtype=bool)
    pairs = []
    for k in np.argsort(-straightness[rows, columns], kind="stable"):
        i, j = rows[k], columns[k]
        if free[i] and free[j] and straightness[i, j] > limit:
            free[[i, j]] = False
            pairs.append((int(sides[i]), int(sides[j])))
    return pairs


def _walk(start: int, vertex_of_side: list[int], following: list[int], used: list[bool]) -> Chain:
    """Return the chain from the side `start` to its end, or until it closes."""
    chain = Chain([], [vertex_of_side[start]])
    side = start
    while side >= 0 and not used[side // 2]:
        used[side // 2] = True
        chain.edges.append(side // 2)
        chain.vertices.append(vertex_of_side[side ^ 1])
        side = following[side ^ 1]
    return chain
