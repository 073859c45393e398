# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on elastic seams, which may change their length equally on both sides."""

from __future__ import annotations

import time

import wirewarp
from inputs import Inputs
from measures import summarize
from methods import flatten
from palette import plain_percent
from shapes import Shape, chain_of
from text import differ, table

TOLERANCES = (0.0, 0.01, 0.03)
FLAT = 1e-9  # shapes with less energy count as undistorted


def with_elastic_seams(shape: Shape, chains: list[list[int]], tolerance: float) -> tuple[wirewarp.FlattenResult, float]:
    """Return a flattening with elastic wires along these chains, none for tolerance 0, and its processor seconds."""
    along_seams = [wirewarp.Wire(chain, tolerance) for chain in chains if tolerance > 0]
    begin = time.process_time()
    result = flatten(shape, along_seams)
    return result, time.process_time() - begin


def section(inputs: Inputs) -> str:
    rows, gains, mismatch = [], {}, 0.0
    seconds = dict.fromkeys(TOLERANCES, 0.0)
    for name, shape in inputs.shapes.items():
        chains = [chain_of(seam.edges) for seam in inputs.by_all_methods(name)["Refined"].seams]
        if not chains:
            continue
        energy = []
        for tolerance in TOLERANCES:
            result, taken = with_elastic_seams(shape, chains, tolerance)
            found = summarize(shape.vertices, result)
            energy.append(found.energy)
            seconds[tolerance] += taken
            mismatch = max(mismatch, found.seam_mismatch or 0.0)
        if energy[0] < FLAT:
            continue
        gains[name] = 1 - energy[-1] / energy[0]
        changed = [f"{e:.5f} ({plain_percent(1 - e / energy[0])} less)" for e in energy[1:]]
        rows.append([name, str(len(chains)), f"{energy[0]:.5f}", *changed])
    least, most = min(gains, key=gains.get), max(gains, key=gains.get)
    header = ["", "seams", "*E*: rigid", *(f"±{100 * tolerance:.0f}%" for tolerance in TOLERANCES[1:])]
    ratios = " and ".join(f"{seconds[t] / seconds[0.0]:.1f}" for t in TOLERANCES[1:])
    return f"""## Elastic seams

All seams of a sample may become longer or shorter by up to the percentage above the column, equally on both sides. Each
seam gets the length that is best for all pieces together. Other outlines and the wires keep their lengths.

{table(header, rows)}

With ±3%, *E* falls by {plain_percent(gains[least])} ({least}) to {plain_percent(gains[most])} ({most}). The two sides
of a flat seam {differ(mismatch)}. The runs take {ratios} times as much processor time as with rigid seams.

**What to choose.** Keep seams rigid if their lengths must be exact: waist, collar, a zip. Let the other seams change by
an amount that is easy to sew: 1% in firm fabric, 3% in a knit or in neoprene. The pieces then have less distortion,
and all pairs of edges still match. If one side must be longer than the other, as for a sleeve head or for gathers,
enter an ease.
"""
