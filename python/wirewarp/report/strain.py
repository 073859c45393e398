# SPDX-License-Identifier: GPL-3.0-or-later
"""Calculates how far the fabric must stretch, as one figure for the verdict, the list of pieces and suggestions.

- σ1, σ2: larger and smaller principal stretch of the map from flat to model
- stretch of a triangle: max(σ1, 1/σ2) - 1, so compression counts as the stretch that would undo it
- figure of a piece: the stretch that 99% of its area stays below, without the changes that eases intend
- figure with a fabric: the same figure for the stretch along the fabric's threads (Threads), in the worse direction
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .. import Cloth, Metrics, Piece
from .model import Threads, Ways

SHARE = 0.99  # share of the area; strain in single triangles, for example in corners, does not matter in fabric
Limits = tuple[float | None, float | None]  # across and along the grain; None: unknown
NAMES = {"woven": "woven cotton", "swim": "swim knit"}  # names in sentences, for presets whose name is not a noun


@dataclass(frozen=True)
class PieceStrain:
    """Strain of each triangle of a piece with a layout, as a fraction of the flat length."""

    stretch: np.ndarray  # (q,) at least 0; inf if the flat triangle has no area
    ease: np.ndarray  # (q,) compression of the fabric, from 0 to 1

    def beyond(self, wanted: "Wanted") -> "PieceStrain":
        """Return the strain without the part that the eases of the piece's lines intend."""
        return PieceStrain(
            stretch=np.maximum((1 + self.stretch) / wanted.stretch - 1, 0),
            ease=np.maximum(1 - (1 - self.ease) * wanted.compression, 0),
        )


def piece_strain(metrics: Metrics) -> PieceStrain:
    """Return the principal strains of each triangle, from the strain of its threads.

    The library measures threads in the middle of thick material.
    """
    p, q = 1 + metrics.face_weft_strain, 1 + metrics.face_warp_strain
    with np.errstate(invalid="ignore"):
        # With the shear angle γ, the metric of the threads is (p², g; g, q²), where g = p q sin γ. Its eigenvalues are
        # the squares of the principal stretches.
        middle = (p * p + q * q) / 2
        spread = np.hypot((p * p - q * q) / 2, p * q * np.sin(metrics.face_shear_angle))
        longest, shortest = np.sqrt(middle + spread), np.sqrt(np.maximum(middle - spread, 0))
    collapsed = ~np.isfinite(middle)
    return PieceStrain(
        stretch=np.where(collapsed, np.inf, np.maximum(longest - 1, 0)),
        ease=np.where(collapsed, 0, np.maximum(1 - shortest, 0)),
    )


@dataclass(frozen=True)
class Wanted:
    """Largest intended changes of length between the model and the flat piece, from the eases of the piece's lines."""

    stretch: float = 1.0  # factor from negative ease: length when worn, divided by the flat length
    compression: float = 1.0  # factor from ease and gathers: flat length divided by the length on the model


def wanted_strain(ratios: Sequence[float]) -> Wanted:
    """Return the largest factor of stretch and the largest factor of compression.

    ratios: eases of the lines of a piece, as fractions of their lengths on the model.
    """
    return Wanted(1 / (1 + min([0.0, *ratios])), 1 + max([0.0, *ratios]))


def eases_of_piece(piece: Piece, wires: Sequence[float], sides: dict[tuple[int, int], float]) -> list[float]:
    """Return the eases of a piece's lines.

    wires: ease of each wire. sides: eases by directed edge, for edges with an ease on one side.
    """
    eases = [wires[wire.wire_index] for wire in piece.wires]
    if sides:
        steps = [step for chain in piece.boundaries for step in pairwise(chain.vertices.tolist())]
        eases += [sides[step] for step in steps if step in sides]
    return eases


def stretch_figure(strain: PieceStrain, areas: np.ndarray) -> float:
    """Return the figure of a piece, as a fraction. areas (q,): areas of its triangles on the model."""
    with np.errstate(divide="ignore"):
        undone = 1 / (1 - strain.ease) - 1
    return widespread(np.maximum(strain.stretch, undone), areas)


def widespread(values: np.ndarray, areas: np.ndarray) -> float:
    """Return the value that 99% of the area stays below. values (q,): value of each triangle; areas (q,): its area."""
    order = np.argsort(values)
    below = np.cumsum(areas[order])
    # The share is reduced by a tolerance for rounding errors of the sums. The returned value therefore does not depend
    # on the order of triangles with equal values.
    return float(values[order[min(np.searchsorted(below, SHARE * (1 - 1e-9) * below[-1]), len(order) - 1)]])


def threads_of(metrics: Metrics, areas: np.ndarray, wanted: Wanted, cloth: Cloth, name: str, limits: Limits) -> Threads:
    """Return the strain of the fabric's threads in a piece with a layout.

    - areas (q,): areas of the triangles on the model
    - name: name of the preset, or "custom"
    - limits: maximum stretch of the fabric
    """
    across, along = (
        max((1 + widespread(strain, areas)) / wanted.stretch - 1, 0.0) for strain in thread_strains(metrics).values()
    )
    return Threads(
        cloth=NAMES.get(name, "fabric" if name == "custom" else name),
        across=across,
        along=along,
        shear=widespread(_numbers(np.abs(metrics.face_shear_angle), math.pi / 2), areas),
        gives=Ways(across=limits[0], along=limits[1]),
        worn=Ways(across=max(cloth.stretch[0], 0.0), along=max(cloth.stretch[1], 0.0)),
    )


def thread_strains(metrics: Metrics) -> dict[str, np.ndarray]:
    """Return the strain (q,) of the threads "across" and "along" the grain; inf if the flat triangle has no area."""
    strains = {"across": metrics.face_weft_strain, "along": metrics.face_warp_strain}
    return {way: _numbers(strain, math.inf) for way, strain in strains.items()}


def _numbers(values: np.ndarray, collapsed: float) -> np.ndarray:
    found: np.ndarray = np.where(np.isfinite(values), values, collapsed)
    return found


def triangle_areas(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    a, b, c = (vertices[triangles[:, corner]] for corner in range(3))
    areas: np.ndarray = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return areas


def triangles_around(piece: Piece, triangle: int) -> np.ndarray:
    return np.flatnonzero(np.isin(piece.faces, piece.faces[triangle]).any(axis=1))


def connected_regions(piece: Piece, members: np.ndarray) -> list[np.ndarray]:
    """Return the triangles in groups that are connected across edges. members (q,): which triangles to use."""
    triangles = np.flatnonzero(members)
    neighbors = _neighbors(np.asarray(piece.faces)[triangles], len(piece.vertices))
    labels = np.arange(len(triangles))
    # In each round, each triangle gets the lowest label of itself and its neighbors. Labels are numbers of triangles,
    # so each label is then replaced by the label of that triangle, which saves rounds over long distances.
    while True:
        lowest = np.minimum(labels, labels[neighbors].min(axis=1))
        lowest = lowest[lowest]
        if np.array_equal(lowest, labels):
            break
        labels = lowest
    order = np.argsort(labels, kind="stable")
    starts = np.flatnonzero(np.diff(labels[order], prepend=-1))
    return [triangles[group] for group in np.split(order, starts[1:])] if len(triangles) else []


def _neighbors(faces: np.ndarray, vertex_count: int) -> np.ndarray:
    """Return the neighbor (t,3) of each triangle across each side, or the triangle itself if it has no neighbor there.

    faces (t,3): vertices of the triangles.
    """
    keys = edge_keys(faces[:, [0, 1, 1, 2, 2, 0]], vertex_count)
    sides = np.argsort(keys, kind="stable")
    pairs = np.flatnonzero(keys[sides][1:] == keys[sides][:-1])
    owner = np.arange(len(keys)) // 3
    across = owner.copy()
    first, second = sides[pairs], sides[pairs + 1]
    across[first], across[second] = owner[second], owner[first]
    return across.reshape(-1, 3)


def edge_keys(pairs: np.ndarray, count: int) -> np.ndarray:
    """Return a number for each pair of vertices, the same in both orders. count: number of all vertices."""
    keys: np.ndarray = np.sort(np.asarray(pairs, dtype=np.int64).reshape(-1, 2), axis=1) @ np.array([count, 1])
    return keys


def percent_text(share: float) -> str:
    """Return a fraction as a text, such as "19%", "9.5%", "over 100%" or "unlimited"."""
    if math.isinf(share):
        return "unlimited"
    if share >= 1:
        return "over 100%"
    return f"{100 * share:.0f}%" if share >= 0.0995 else f"{100 * share:.1f}%"
