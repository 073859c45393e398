# SPDX-License-Identifier: GPL-3.0-or-later
"""Terms that the refined method minimizes beside the ARAP energy, from a piece's arrays alone: the fairness of wires

1/2 Σ_nodes D³/ℓ |r|²,   r = (u_c - u_b) / l_bc - R(π - α) (u_b - u_a) / l_ab   at a corner a → b → c of the network

and the barrier against flips, 10 Σ_faces A max(0, 1/10 - det J)².
"""

import cmath
import math
from collections.abc import Iterable

import numpy as np
import wirewarp


def next_around(faces: np.ndarray, points: np.ndarray) -> dict[tuple[int, int], tuple[int, float]]:
    """Return, for (b, c), the edge b-d that follows b-c counter-clockwise around b: the vertex d, and the surface angle
    between both edges.
    """
    b, c, d = (np.concatenate([faces[:, (k + shift) % 3] for k in range(3)]) for shift in range(3))
    p, q = points[c] - points[b], points[d] - points[b]
    angles = np.arctan2(np.linalg.norm(np.cross(p, q), axis=1), (p * q).sum(axis=1))
    return {
        (start, end): (following, angle)
        for start, end, following, angle in zip(b.tolist(), c.tolist(), d.tolist(), angles.tolist(), strict=True)
    }


def held_half_edges(
    piece: wirewarp.Piece, held_edges: Iterable[tuple[int, int]], following: dict
) -> set[tuple[int, int]]:
    """Return both directions of every edge of the piece that is on its outline or among the held edges of the input."""
    held_inside = {frozenset(edge) for edge in held_edges}
    source = piece.source_vertex.tolist()
    edges = {(b, c) for b, c in following} | {(c, b) for b, c in following}
    return {
        (b, c)
        for b, c in edges
        if not ((b, c) in following and (c, b) in following) or frozenset((source[b], source[c])) in held_inside
    }


def fairness_term(
    piece: wirewarp.Piece, vertices: np.ndarray, held_edges: Iterable[tuple[int, int]], fairness: float
) -> float:
    """Return the term over the piece's 3D area.

    held_edges: vertex pairs of rigid and elastic wires in the input; the outline is always held. vertices: vertices of
    the input.
    """
    points = vertices[piece.source_vertex]
    following = next_around(piece.faces, points)
    held = held_half_edges(piece, held_edges, following)
    flat = [complex(*position) for position in piece.vertices.tolist()]
    area = piece.metrics.area_3d
    wiggle = fairness * math.sqrt(area)
    total = 0.0
    for b, c in held:
        if (b, c) not in following:
            continue  # the corner belongs to the piece on the other side
        a, angle = following[b, c]
        while (b, a) not in held:
            a, step = following[b, a]
            angle += step
        if a == c:
            continue  # the end of a wire
        length_in, length_out = math.dist(points[a], points[b]), math.dist(points[b], points[c])
        turn = cmath.exp(1j * (math.pi - angle))
        r = (flat[c] - flat[b]) / length_out - turn * (flat[b] - flat[a]) / length_in
        total += wiggle**3 / ((length_in + length_out) / 2) * abs(r) ** 2 / 2
    return total / area


def flip_barrier(piece: wirewarp.Piece, vertices: np.ndarray) -> float:
    """Return the barrier over the piece's 3D area. vertices: vertices of the input."""
    a, b, c = np.moveaxis(vertices[piece.source_vertex][piece.faces], 1, 0)
    area_3d = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    a, b, c = np.moveaxis(piece.vertices[piece.faces], 1, 0)
    area_2d = np.linalg.det(np.stack([b - a, c - a], axis=1)) / 2
    lack = np.clip(0.1 - area_2d / area_3d, 0, None)
    return 10 * float(area_3d @ lack**2) / piece.metrics.area_3d
