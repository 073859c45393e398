# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares elastic seams with figures that were computed independently of this code. Skipped if they are not available.

The toy is left out because it had other seams then.
"""

import json
import math
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from samples import SAMPLES
from shapes import chain_of

FIGURES = Path(__file__).parents[2].parent / "shared" / "reference" / "seams.json"
NO_FIGURES = "the reference figures are not at hand"

pytestmark = pytest.mark.skipif(not FIGURES.exists(), reason=NO_FIGURES)


def entries() -> list:
    """Return (sample, tolerance) of all results."""
    if not FIGURES.exists():
        return [pytest.param("", "", id="none", marks=pytest.mark.skip(reason=NO_FIGURES))]
    samples = {name: sample for name, sample in json.loads(FIGURES.read_text()).items() if isinstance(sample, dict)}
    own = {name: sample for name, sample in samples.items() if name != "Toy"}
    return [(name, entry) for name, sample in own.items() for entry in sample if entry.startswith("eps")]


@pytest.fixture(scope="module")
def seams():
    """Return the seams of each sample as chains."""
    return {}


@pytest.mark.parametrize(("name", "entry"), entries())
def test_elastic_seams(name, entry, seams):
    expected = json.loads(FIGURES.read_text())[name][entry]
    shape = SAMPLES[name]
    wires = [wirewarp.Wire(wire.vertices, wire.tolerance) for wire in shape.wires]
    if name not in seams:
        plain = wirewarp.flatten(shape.vertices, shape.triangles(), seams=shape.seams)
        seams[name] = [chain_of(seam.edges) for seam in plain.seams]
    tolerance = math.inf if entry == "eps inf" else float(entry.split()[1])
    along_seams = [wirewarp.Wire(chain, tolerance) for chain in seams[name]]
    result = wirewarp.flatten(shape.vertices, shape.triangles(), seams=shape.seams, wires=wires + along_seams)
    assert [piece.error for piece in result.pieces] == [None] * len(result.pieces)
    areas = [piece.metrics.area_3d for piece in result.pieces]
    objective = np.average([piece.report.objective for piece in result.pieces], weights=areas)
    assert objective == pytest.approx(expected["objective"], abs=1e-6)
    for number, seam in enumerate(result.seams):
        assert seam.mismatch <= 1e-9 * seam.length_3d
        assert seam.variation == pytest.approx(expected["h"][str(number)], abs=1e-3)
