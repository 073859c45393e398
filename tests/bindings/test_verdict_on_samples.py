# SPDX-License-Identifier: GPL-3.0-or-later
"""Every sample has the correct verdict for fabrics that stretch little or far."""

import numpy as np
import pytest
import wirewarp
from samples import SAMPLES, cloth_of, eases_of, flattened, flattened_as_made, wires_of
from wirewarp.pattern import has_room
from wirewarp.report import COARSE, make_report, verdict

pytestmark = pytest.mark.core
# These samples have turns of 20 degrees between edges of 47 mm (at the crotch) and 29 mm (around the arms).
WITH_COARSE_CURVES = {"Jeans", "Armchair cover"}


def share_within(piece: wirewarp.Piece, name: str, limits: tuple[float, float]) -> float:
    """Return the share of the piece's area in which threads stretch no further than their limit.

    This is the smaller of two shares, of the threads across and along the grain.
    """
    shape = SAMPLES[name]
    a, b, c = shape.vertices[shape.triangles()[piece.source_face]].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    strains = piece.metrics.face_weft_strain, piece.metrics.face_warp_strain
    return min(areas[strain <= limit].sum() / areas.sum() for strain, limit in zip(strains, limits, strict=True))


# from the least to the greatest stretch; each suffices for some samples for which the fabric before it does not
FABRICS = ["vinyl", "minky", "jersey", "swim"]


@pytest.mark.parametrize("fabric", FABRICS)
@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_ready_if_99_percent_of_each_piece_stretch_no_further_than_the_fabric(name, fabric):
    shape, cloth, result = SAMPLES[name], wirewarp.Cloth.preset(fabric), flattened(name)
    report = make_report(result, shape.vertices, shape.triangles(), wires=wires_of(shape), cloth=cloth, fabric=fabric)
    shares = [share_within(piece, name, cloth.limits) for piece in result.pieces]
    assert verdict(report).is_ready == (min(shares) >= 0.99)


@pytest.mark.parametrize("name", SAMPLES)
def test_a_sample_is_ready_to_be_cut_from_its_fabric_with_its_allowance(name):
    shape, result = SAMPLES[name], flattened_as_made(name)
    marked = {"wires": wires_of(shape), "eases": eases_of(shape), "cloth": cloth_of(shape), "fabric": shape.cloth}
    report = make_report(result, shape.vertices, shape.triangles(), **marked)
    assert verdict(report).is_ready
    assert any(hint.code == COARSE for hint in report.hints) == (name in WITH_COARSE_CURVES)
    assert all(has_room(piece, shape.allowance / 1000) for piece in result.pieces)
