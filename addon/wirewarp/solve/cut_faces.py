# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the segments to draw for lines on a mesh, and the parts into which the lines divide its faces."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..core import CutSources, SurfacePath, cut_mesh
from .arrays import MeshArrays
from .chains import are_among
from .flatten import polygons_across

Pairs = list[tuple[int, int]]


@dataclass(frozen=True)
class Segments:
    """Straight segments of lines, each in one face. Each end is a weighted mean of three vertices of this face."""

    polygons: np.ndarray  # (s,) int32, the face
    vertices: np.ndarray  # (s,3) int32, the three vertices
    weights: np.ndarray  # (s,2,3) weights of these vertices at both ends, with the sum 1 at each end


@dataclass(frozen=True)
class DividedTriangle:
    corners: tuple[int, int, int]
    inside: dict[int, tuple[float, float, float]]  # weights of the corners for each new point inside
    parts: list[tuple[int, int, int]]  # smaller triangles, between corners, points on the sides and points inside


@dataclass(frozen=True)
class DividedPolygon:
    diagonals: Pairs  # new edges between corners of the face
    triangles: list[DividedTriangle]  # the triangles of the face, if lines cross some of them


@dataclass(frozen=True)
class Division:
    """The division of a mesh by lines. Faces that lines cross are divided into triangles. The surface does not
    change."""

    polygons: dict[int, DividedPolygon]
    edges: list[list[tuple[int, float]]]  # points along each divided edge, with their places as shares of its length
    lines: Pairs  # edges of the lines; new points have higher numbers than the vertices of the mesh


def segments_of(paths: Iterable[SurfacePath], arrays: MeshArrays) -> Segments:
    points = [
        list(zip(arrays.triangles[path.faces].tolist(), path.coordinates.tolist(), strict=True)) for path in paths
    ]
    mixes = [[{v: w for v, w in zip(*point, strict=True) if w > 0} for point in line] for line in points]
    used = np.array([vertex for line in mixes for mix in line for vertex in mix], dtype=np.int64)
    triangles_at = defaultdict(set)
    for row in np.flatnonzero(np.isin(arrays.triangles, used).any(axis=1)).tolist():
        for vertex in arrays.triangles[row].tolist():
            triangles_at[vertex].add(row)
    rows, weights = [], []
    for first, second in (pair for line in mixes for pair in pairwise(line)):
        row = min(set.intersection(*(triangles_at[vertex] for vertex in {*first, *second})))
        corners = arrays.triangles[row].tolist()
        rows.append(row)
        weights.append([[mix.get(vertex, 0.0) for vertex in corners] for mix in (first, second)])
    shape = np.array(weights).reshape(-1, 2, 3)
    return Segments(arrays.triangle_polygons[rows], arrays.triangles[rows], shape)


def segments_along(edges: np.ndarray, arrays: MeshArrays) -> Segments:
    """Return the segments to draw for edges (k,2) of the mesh, one in each face beside an edge."""
    sides = arrays.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    rows, corners = np.divmod(np.flatnonzero(are_among(sides, edges)), 3)
    weights = np.eye(3)[np.column_stack([corners, (corners + 1) % 3])]
    return Segments(arrays.triangle_polygons[rows], arrays.triangles[rows], weights)


def places_on(segments: Segments, polygons: np.ndarray, vertices: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return the ends (2k,3) of the segments on a mesh, without segments on faces that the mesh lacks.

    polygons, vertices (l,): face and vertex of each corner, numbered as in the segments
    places (l,3): places of the corners
    """
    near = np.flatnonzero(np.isin(polygons, segments.polygons))
    corner_at = dict(
        zip(zip(polygons[near].tolist(), vertices[near].tolist(), strict=True), near.tolist(), strict=True)
    )
    ends = []
    for polygon, corners, weights in zip(
        segments.polygons.tolist(), segments.vertices.tolist(), segments.weights, strict=True
    ):
        found = [corner_at.get((polygon, vertex)) for vertex in corners]
        if None not in found:
            ends.append(weights @ places[found])
    return np.array(ends, dtype=np.float32).reshape(-1, 3)


def divide(arrays: MeshArrays, paths: Sequence[SurfacePath]) -> Division:
    """Return the division of the mesh by these lines. Raises the library's FlattenError."""
    _, faces, edges, sources = cut_mesh(arrays.vertices, arrays.triangles, list(paths))
    inside = set(range(len(arrays.vertices), len(sources.vertices)))
    inside -= {index for line in sources.divided_edges for index in line.tolist()}
    lines = [(int(a), int(b)) for a, b in edges]
    parts = defaultdict(list)
    is_divided = np.bincount(sources.faces, minlength=len(arrays.triangles)) > 1
    for row in np.flatnonzero(is_divided[sources.faces]).tolist():
        parts[int(sources.faces[row])].append(tuple(faces[row].tolist()))
    filled = defaultdict(list)
    for row in np.flatnonzero(np.isin(arrays.triangle_polygons, arrays.triangle_polygons[is_divided])).tolist():
        corners = tuple(arrays.triangles[row].tolist())
        mixes = {index: _mix(index, corners, sources) for part in parts[row] for index in inside.intersection(part)}
        filled[int(arrays.triangle_polygons[row])].append(DividedTriangle(corners, mixes, parts[row]))
    across = defaultdict(list)
    followed = _followed_diagonals(edges, arrays)
    for polygon, (a, b) in zip(polygons_across(followed, arrays).tolist(), followed.tolist(), strict=True):
        across[polygon].append((a, b))
    polygons = {polygon: DividedPolygon(pairs, []) for polygon, pairs in across.items()}
    for polygon, triangles in filled.items():
        polygons[polygon] = DividedPolygon(common_sides(each.corners for each in triangles), triangles)
    return Division(polygons, [_along(line.tolist(), sources) for line in sources.divided_edges], lines)


def _mix(index: int, corners: Sequence[int], sources: CutSources) -> tuple[float, float, float]:
    weights = dict(zip(sources.vertices[index].tolist(), sources.vertex_weights[index].tolist(), strict=True))
    return tuple(weights[corner] for corner in corners)


def common_sides(triangles: Iterable[Sequence[int]]) -> Pairs:
    """Return the sides that belong to two of these triangles."""
    sides = Counter((min(a, b), max(a, b)) for triangle in triangles for a, b in pairwise([*triangle, triangle[0]]))
    return [side for side, count in sides.items() if count == 2]


def _followed_diagonals(edges: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    """Return the edges of lines that are diagonals of faces of the mesh, (k,2). edges: all edges of the lines."""
    count = len(arrays.vertices)
    whole = np.unique(np.sort(edges[(edges < count).all(axis=1)], axis=1), axis=0)
    return whole[~are_among(whole, arrays.edges)]


def _along(line: list[int], sources: CutSources) -> list[tuple[int, float]]:
    """Return the points of a divided edge with their distance from its first end, as a share of its length."""
    shares = (sources.vertex_weights[line] * (sources.vertices[line] == line[-1])).sum(axis=1)
    return list(zip(line, shares.tolist(), strict=True))
