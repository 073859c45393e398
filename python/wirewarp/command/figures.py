# SPDX-License-Identifier: GPL-3.0-or-later
"""What a thousand models are compared by. None where there is no layout to measure."""

import math
from collections.abc import Sequence
from typing import Any

from .. import FlattenResult

Figures = dict[str, float | int | None]


def result_figures(result: FlattenResult, meters: float) -> Figures:
    """meters: in a unit of the model."""
    pieces = [(len(p.source_face), p.metrics.area_3d * meters**2, p.metrics.arap_energy) for p in result.pieces]
    return _figures(pieces, [seam.mismatch * meters for seam in result.seams])


def report_figures(reports: Sequence[dict[str, Any]]) -> Figures:
    """Of the reports of the add-on, one for each object."""
    every = [piece for report in reports for piece in report["pieces"]]
    pieces = [(piece["triangles"], *(_number(piece[key]) for key in ("area_3d_m2", "arap_energy"))) for piece in every]
    return _figures(pieces, [_number(seam["mismatch_m"]) for report in reports for seam in report["seams"]])


def _figures(pieces: Sequence[tuple[int, float, float]], mismatches: Sequence[float]) -> Figures:
    """pieces: triangles, area in square meters and energy of each."""
    area = sum(area for _, area, _ in pieces)
    energy = sum(area * energy for _, area, energy in pieces)
    return {
        "triangles": sum(count for count, _, _ in pieces),
        "area_m2": _finite(area),
        "energy": _finite(energy / area) if area else None,
        "seam_mismatch_m": _finite(max(mismatches, default=0.0)),
    }


def _number(value: float | None) -> float:
    return math.nan if value is None else value


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
