# SPDX-License-Identifier: GPL-3.0-or-later
"""With woven fabric, the samples have less strain along threads, and lengths as exact as without a fabric."""

import numpy as np
import pytest
import wirewarp
from samples import SAMPLES, Shape, flatten, flattened

pytestmark = pytest.mark.core

STRAINED = 1e-3  # samples with less strain are unfolded: they have no strain to lower
WOVEN = wirewarp.Cloth(1, 1, 0.05)


def thread_strain(shape: Shape, result: wirewarp.FlattenResult) -> float:
    """Return the 99th percentile, by area on the model, of the strain of each triangle's more strained thread."""
    strain, area = [], []
    for piece in result.pieces:
        weft, warp = piece.metrics.face_weft_strain, piece.metrics.face_warp_strain
        strain.append(np.maximum(np.abs(weft), np.abs(warp)))
        corners = shape.vertices[shape.triangles()[piece.source_face]]
        area.append(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1))
    order = np.argsort(np.concatenate(strain))
    below = np.cumsum(np.concatenate(area)[order])
    return float(np.concatenate(strain)[order][np.searchsorted(below, 0.99 * below[-1])])


@pytest.fixture(scope="module")
def ratios() -> dict[str, tuple[float, float]]:
    """Return ratios of thread strain with and without woven fabric, for the marked grain and the best direction."""
    found = {}
    for name, shape in SAMPLES.items():
        plain = thread_strain(shape, flattened(name))
        if plain < STRAINED:
            continue
        results = [flatten(shape, cloth=WOVEN), flatten(shape, cloth=WOVEN, orientation="best")]
        assert all(piece.error is None for result in results for piece in result.pieces), name
        found[name] = tuple(thread_strain(shape, result) / plain for result in results)
    return found


def test_a_woven_is_strained_less(ratios):
    as_grain = sorted(ratio for ratio, _ in ratios.values())
    assert as_grain[-2] <= 0.8, ratios
    assert as_grain[-1] <= 1.02, ratios


def test_a_woven_is_strained_even_less_in_the_best_direction(ratios):
    best = sorted(ratio for _, ratio in ratios.values())
    assert best[4] <= 0.6, ratios
    assert best[-1] <= 1.02, ratios
