# SPDX-License-Identifier: GPL-3.0-or-later
"""Calculates figures for comparing thousands of models. A figure is None if a piece has no layout to measure."""

import math
from collections.abc import Sequence

from ..report import Report

Figures = dict[str, float | int | None]


def figures_of(reports: Sequence[Report]) -> Figures:
    """Return the figures of all objects in one file together."""
    pieces = [(report, piece) for report in reports for piece in report.pieces]
    areas = [_number(piece.area_3d) * report.meters**2 for report, piece in pieces]
    area = sum(areas)
    energy = sum(own * _number(piece.arap_energy) for own, (_, piece) in zip(areas, pieces, strict=True))
    seams = [(report, seam) for report in reports for seam in report.seams]
    mismatches = [math.inf if seam.mismatch is None else seam.mismatch * report.meters for report, seam in seams]
    return {
        "triangles": sum(piece.triangles for _, piece in pieces),
        "area_m2": _finite(area),
        "energy": _finite(energy / area) if area else None,
        "stretch": _finite(max((piece.needed for _, piece in pieces), default=0.0)),
        "seam_mismatch_m": _finite(max(mismatches, default=0.0)),
    }


def _number(value: float | None) -> float:
    return math.nan if value is None else value


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
