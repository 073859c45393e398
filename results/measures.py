# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the figures of a flattened sample from the reports on its pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import wirewarp


@dataclass(frozen=True)
class Line:
    """A wire, or a section of outline between junctions. Lengths are in meters."""

    name: str
    length_3d: float
    length_2d: float

    @property
    def change(self) -> float:
        """Return the relative change of length, above 0 if the line became longer."""
        return self.length_2d / self.length_3d - 1

    @property
    def difference(self) -> float:
        return abs(self.length_2d - self.length_3d)


@dataclass(frozen=True)
class Summary:
    """Figures of all pieces. Means are over the area of the surface, so that they do not depend on the mesh."""

    energy: float  # E of Eq. (4) over the area
    mean_aspect_ratio: float
    max_aspect_ratio: float
    max_face_energy: float  # E_A of Eq. (6) over the triangle's area
    seam_mismatch: float | None  # meters; None without seams
    worst_edge: float  # largest relative difference of an edge of outline or wires from its target length
    flipped: int
    overlapping: int
    angle_rms: float  # radians: rms change of the angles of outline and wires, of the worst piece
    angle_max: float  # radians: largest change of such an angle
    outline: list[Line]
    wires: list[Line]  # whole wires, as marked
    tolerances: list[float]  # tolerances of the wires
    changes: list[float]  # relative change of length of every elastic part of a wire
    factorizations: int  # number for the piece with the most factorizations


def face_areas(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def piece_areas(vertices: np.ndarray, piece: wirewarp.Piece) -> np.ndarray:
    """Return the areas (q,) of a piece's triangles on the surface with these vertices."""
    return face_areas(vertices[piece.source_vertex], piece.faces)


def percentile_99(values: np.ndarray, areas: np.ndarray) -> float:
    """Return the value that 1% of the area exceeds. Both arguments: (m,)."""
    order = np.argsort(values)
    below = np.cumsum(areas[order])
    return float(values[order][np.searchsorted(below, 0.99 * below[-1])])


def summarize(vertices: np.ndarray, result: wirewarp.FlattenResult) -> Summary:
    """Return the figures. vertices (n, 3): of the surface, in meters."""
    metrics = [piece.metrics for piece in result.pieces]
    area = np.concatenate([piece_areas(vertices, piece) for piece in result.pieces])
    ratio = np.concatenate([m.face_aspect_ratio for m in metrics])
    energy = np.concatenate([m.face_arap for m in metrics])
    parts = [part for piece in result.pieces for part in piece.wires]
    outline = [stretch for piece in result.pieces for stretch in piece.boundaries]
    return Summary(
        energy=energy.sum() / area.sum(),
        mean_aspect_ratio=(ratio * area).sum() / area.sum(),
        max_aspect_ratio=ratio.max(),
        max_face_energy=(energy / area).max(),
        seam_mismatch=max((seam.mismatch for seam in result.seams), default=None),
        worst_edge=max(line.max_edge_error for line in [*outline, *parts]),
        flipped=sum(len(m.flipped_faces) for m in metrics),
        overlapping=sum(len(m.overlapping_faces) for m in metrics),
        angle_rms=max(m.angle_deviation_rms for m in metrics),
        angle_max=max(m.angle_deviation_max for m in metrics),
        outline=[Line("outline", stretch.length_3d, stretch.length_2d) for stretch in outline],
        wires=[Line(wire.name, wire.length_3d, wire.length_2d) for wire in result.wires],
        tolerances=[wire.tolerance for wire in result.wires],
        changes=[part.length_2d / part.length_3d - 1 for part in parts if part.kind == "elastic"],
        factorizations=max(piece.report.factorizations for piece in result.pieces),
    )


def rigid_wires(found: Summary) -> list[Line]:
    return [wire for wire, tolerance in zip(found.wires, found.tolerances, strict=True) if tolerance == 0]


def worst(lines: list[Line]) -> Line:
    """Return the line with the largest relative change of length."""
    return max(lines, key=lambda line: abs(line.change))
