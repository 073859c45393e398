# SPDX-License-Identifier: GPL-3.0-or-later
"""Repairs a triangle mesh, and describes each repair in a sentence. Vertices keep their numbers.

Unlike Check and Repair in the add-on, this module keeps interior faces.
"""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from ..report import counted
from .model import Model

CLOSE = 1e-5  # closer vertices are merged; a fraction of the model's size, because files have five or six digits
# Vertices are sorted in this direction. It is oblique, because then few vertices are at the same place along it.
OBLIQUE = np.array([0.3, 0.5, 0.81])


@dataclass(frozen=True)
class Repaired:
    model: Model
    seams: np.ndarray  # (k,2) edges with three or more faces, which must be seams
    done: list[str]  # a sentence about each repair
    labels: np.ndarray  # (n,) the vertex with which each vertex was merged, or the vertex itself
    divided: dict[frozenset[int], int]  # divided edges, and the vertex that divides each
    reversed: set[tuple[int, int]]  # edges of flipped faces, in their direction before the flip

    def chain(self, vertices: np.ndarray) -> list[int]:
        """Return a line of vertices of the file as vertices of the repaired mesh."""
        found: list[int] = []
        for vertex in vertices.tolist():
            own = int(self.labels[vertex]) if 0 <= vertex < len(self.labels) else vertex
            if not found or found[-1] != own:
                found += self._between(found[-1], own) if found else []
                found.append(own)
        return found

    def pairs(self, edges: np.ndarray) -> np.ndarray:
        """Return the edges (k,2) of the repaired mesh that replace these edges of the file."""
        steps = [step for edge in edges for step in pairwise(self.chain(edge))]
        return np.array(steps, dtype=np.int64).reshape(-1, 2)

    def sides(self, half_edges: np.ndarray) -> np.ndarray:
        """Return the directed edges (k,2) that replace directed edges of the file, on the same side of the mesh."""
        return np.array([step[::-1] if step in self.reversed else step for step in map(tuple, self.pairs(half_edges))])

    def _between(self, a: int, b: int) -> list[int]:
        middle = self.divided.get(frozenset((a, b)))
        return [] if middle is None else [*self._between(a, middle), middle, *self._between(middle, b)]


def repaired(model: Model) -> Repaired:
    """Return the mesh with merged vertices, without zero-area and duplicate faces, and with consistent directions."""
    close = CLOSE * float(np.ptp(model.vertices, axis=0).max())
    done: list[str] = []
    labels = _labels(model.vertices, close)
    model, merged = _with_merged_vertices(model, labels)
    if merged:
        done.append(f"{counted(merged, 'overlapping vertex', 'overlapping vertices')} merged")
    model, removed, divided = _without_flat_faces(model, close)
    if removed:
        done.append(f"{counted(removed, 'zero-area face')} removed")
    _, first = np.unique(np.sort(model.faces, axis=1), axis=0, return_index=True)
    duplicates = len(model.faces) - len(first)
    if duplicates:
        model = _with_faces(model, np.sort(first))
        done.append(f"{counted(duplicates, 'duplicate face')} removed")
    flipped = _opposed_faces(model)
    turned = {step for face in model.faces[flipped].tolist() for step in pairwise((*face, face[0]))}
    if len(flipped):
        model = _with_flipped(model, flipped)
        done.append(f"{counted(len(flipped), 'face')} flipped")
    seams = _edges_of_many_faces(model.faces)
    if len(seams):
        done.append(f"{counted(len(seams), 'edge')} of three or more faces marked as seams")
    return Repaired(model, seams, done, labels, divided, turned)


def _with_faces(model: Model, rows: np.ndarray) -> Model:
    uv = None if model.corner_uv is None else model.corner_uv[rows]
    return replace(model, faces=model.faces[rows], corner_uv=uv)


def _with_flipped(model: Model, rows: np.ndarray) -> Model:
    faces, uv = model.faces.copy(), None if model.corner_uv is None else model.corner_uv.copy()
    faces[rows] = faces[rows][:, ::-1]
    if uv is not None:
        uv[rows] = uv[rows][:, ::-1]
    return replace(model, faces=faces, corner_uv=uv)


def _labels(vertices: np.ndarray, close: float) -> np.ndarray:
    """Return for each vertex (n,) the vertex with the lowest number in its chain of close vertices."""
    labels = np.arange(len(vertices))
    pairs = _close_pairs(vertices, close)
    while True:
        before = labels.copy()
        lowest = np.minimum(labels[pairs[:, 0]], labels[pairs[:, 1]])
        np.minimum.at(labels, pairs.ravel(), np.repeat(lowest, 2))
        labels = labels[labels]
        if np.array_equal(labels, before):
            return labels


def _with_merged_vertices(model: Model, labels: np.ndarray) -> tuple[Model, int]:
    """Return the mesh, and the number of vertices that were merged into others. Loose vertices do not count."""
    faces = labels[model.faces]
    merged = len(np.unique(model.faces)) - len(np.unique(faces))
    a, b, c = faces.T
    is_face = (a != b) & (b != c) & (c != a)
    return _with_faces(replace(model, faces=faces), np.flatnonzero(is_face)), merged


def _close_pairs(vertices: np.ndarray, close: float) -> np.ndarray:
    """Return all pairs (k,2) of vertices whose distance is at most `close`."""
    heights = vertices @ (OBLIQUE / np.linalg.norm(OBLIQUE))
    order = np.argsort(heights, kind="stable")
    rows, found = np.arange(len(order)), [np.empty((0, 2), dtype=np.int64)]
    for step in range(1, len(order)):
        rows = rows[rows + step < len(order)]
        rows = rows[heights[order[rows + step]] - heights[order[rows]] <= close]
        if not len(rows):
            break
        pairs = np.column_stack([order[rows], order[rows + step]])
        found.append(pairs[np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1) <= close])
    return np.concatenate(found)


def _without_flat_faces(model: Model, close: float) -> tuple[Model, int, dict[frozenset[int], int]]:
    """Return the mesh without flat faces, their number, and each divided edge with the vertex that divides it.

    The vertex opposite the longest edge of a flat face divides the other faces at this edge.
    """
    flat = [row for row, face in enumerate(model.faces.tolist()) if _height(model.vertices, face) <= close]
    divided: dict[frozenset[int], int] = {}
    if not flat:
        return model, 0, divided
    count, faces = len(flat), _DividedFaces(model)
    while flat:
        row = flat.pop()
        if row in faces.gone:
            continue
        long_edge, tip = _longest_edge(model.vertices, faces.corners[row])
        faces.gone.add(row)
        divided[frozenset(long_edge)] = tip
        flat += [new for new in faces.divide(long_edge, tip) if _height(model.vertices, faces.corners[new]) <= close]
    return faces.remaining(), count, divided


class _DividedFaces:
    """The faces of a model while flat faces are removed, and their neighbors divided."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._at_edge: dict[frozenset[int], set[int]] = defaultdict(set)
        self._uv: list[np.ndarray | None] = []
        self.corners: list[tuple[int, ...]] = []
        self.gone: set[int] = set()  # rows of removed faces
        uv = [None] * len(model.faces) if model.corner_uv is None else model.corner_uv
        for face, corners in zip(model.faces.tolist(), uv, strict=True):
            self._add(tuple(face), corners)

    def divide(self, edge: tuple[int, int], tip: int) -> list[int]:
        """Divide the faces at this edge by the vertex `tip`. Return the rows of the parts."""
        parts = []
        for row in sorted(self._at_edge[frozenset(edge)] - self.gone):
            self.gone.add(row)
            if tip not in self.corners[row]:  # otherwise nothing remains of the face
                parts += _cut_at(self._model.vertices, self.corners[row], self._uv[row], edge, tip)
        return [self._add(*part) for part in parts]

    def remaining(self) -> Model:
        """Return the model with the remaining faces."""
        rows = [row for row in range(len(self.corners)) if row not in self.gone]
        uv = None if self._model.corner_uv is None else np.array([self._uv[row] for row in rows])
        faces = np.array([self.corners[row] for row in rows], dtype=np.int64).reshape(-1, 3)
        return replace(self._model, faces=faces, corner_uv=uv)

    def _add(self, face: tuple[int, ...], uv: np.ndarray | None) -> int:
        for side in pairwise((*face, face[0])):
            self._at_edge[frozenset(side)].add(len(self.corners))
        self.corners.append(face)
        self._uv.append(uv)
        return len(self.corners) - 1


def _height(vertices: np.ndarray, face: Sequence[int]) -> float:
    a, b, c = vertices[list(face)]
    longest = max(np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c))
    return float(np.linalg.norm(np.cross(b - a, c - a)) / longest) if longest > 0 else 0.0


def _longest_edge(vertices: np.ndarray, face: tuple[int, ...]) -> tuple[tuple[int, int], int]:
    """Return the longest edge of a face, and the opposite vertex."""
    a, b, c = face
    sides = [((a, b), c), ((b, c), a), ((c, a), b)]
    return max(sides, key=lambda side: float(np.linalg.norm(vertices[side[0][0]] - vertices[side[0][1]])))


def _cut_at(
    vertices: np.ndarray, face: tuple[int, ...], uv: np.ndarray | None, edge: tuple[int, int], tip: int
) -> list[tuple[tuple[int, int, int], np.ndarray | None]]:
    """Return the two parts of a face whose edge is divided by the vertex tip, each with its UV coordinates."""
    first = next(k for k in range(3) if {face[k], face[(k + 1) % 3]} == set(edge))
    a, b, c = (face[(first + k) % 3] for k in range(3))
    parts = ((a, tip, c), (tip, b, c))
    if uv is None:
        return [(part, None) for part in parts]
    at_a, at_b, at_c = (uv[(first + k) % 3] for k in range(3))
    length = float(np.linalg.norm(vertices[b] - vertices[a]))
    share = float(np.linalg.norm(vertices[tip] - vertices[a])) / length
    at_tip = (1 - share) * at_a + share * at_b
    return [(parts[0], np.array([at_a, at_tip, at_c])), (parts[1], np.array([at_tip, at_b, at_c]))]


def _opposed_faces(model: Model) -> np.ndarray:
    """Return the faces (k,) to flip, so that neighbors have the same direction.

    In each connected part, the faces of the direction with the smaller area are flipped. In a part with one side
    (Möbius strip), no faces are flipped.
    """
    neighbors = _neighbors(model.faces)
    if not any(differs for own in neighbors.values() for _, differs in own):
        return np.empty(0, dtype=np.int64)
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    side = np.full(len(model.faces), -1)
    opposed = [np.empty(0, dtype=np.int64)]
    for begin in range(len(side)):
        if side[begin] >= 0:
            continue
        rows, is_two_sided = _connected(begin, neighbors, side)
        if is_two_sided:
            sides = [rows[side[rows] == which] for which in (0, 1)]
            opposed.append(min(sides, key=lambda own: float(areas[own].sum())))
    return np.sort(np.concatenate(opposed))


def _neighbors(faces: np.ndarray) -> defaultdict[int, list[tuple[int, bool]]]:
    """Return the neighbors of each face at edges of two faces, and whether their directions differ."""
    at_edge: dict[tuple[int, int], list[tuple[int, bool]]] = defaultdict(list)
    for row, face in enumerate(faces.tolist()):
        for a, b in pairwise((*face, face[0])):
            at_edge[min(a, b), max(a, b)].append((row, a < b))
    neighbors: defaultdict[int, list[tuple[int, bool]]] = defaultdict(list)
    for (row, ascending), (other, other_ascending) in (sides for sides in at_edge.values() if len(sides) == 2):
        neighbors[row].append((other, ascending == other_ascending))
        neighbors[other].append((row, ascending == other_ascending))
    return neighbors


def _connected(
    begin: int, neighbors: defaultdict[int, list[tuple[int, bool]]], side: np.ndarray
) -> tuple[np.ndarray, bool]:
    """Return the faces that are connected with face `begin`, and whether their part has two sides. Set their `side`
    (f,) to 0 for the direction of face `begin`, and to 1 for the other direction."""
    side[begin], part, open_rows, is_two_sided = 0, [begin], [begin], True
    while open_rows:
        row = open_rows.pop()
        for other, differs in neighbors[row]:
            if side[other] < 0:
                side[other] = side[row] ^ differs
                part.append(other)
                open_rows.append(other)
            elif side[other] != side[row] ^ differs:
                is_two_sided = False
    return np.array(part), is_two_sided


def _edges_of_many_faces(faces: np.ndarray) -> np.ndarray:
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    found, counts = np.unique(edges, axis=0, return_counts=True)
    return found[counts > 2]
