# SPDX-License-Identifier: GPL-3.0-or-later
"""Many runs, canceled at every step, leave no memory behind."""

import os
import sys
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from surfaces import spherical_patch

METHODS = ["refined", "wirewarp++", "wirewarping"]
VERTICES, FACES = spherical_patch(columns=10, rows=10)
WIRES = [wirewarp.Wire(range(55, 66), tolerance=0.03)]  # a wire along the middle row


def flatten(method, progress=None):
    return wirewarp.flatten(
        VERTICES, FACES, wires=WIRES, options=wirewarp.Options(method=method), progress=progress
    ).pieces[0]


@pytest.mark.parametrize("method", METHODS)
def test_a_piece_of_a_run_canceled_at_any_call_is_canceled_or_exact(method):
    calls = []
    whole = flatten(method, lambda *call: calls.append(call))
    assert whole.error is None
    for last in range(len(calls)):
        asked = []
        piece = flatten(method, lambda *call, asked=asked, last=last: asked.append(call) or len(asked) <= last)
        if piece.error is None:  # without an error, the guarantee holds
            assert piece.report.termination in ("cancelled", "converged", "stalled")
            assert not piece.report.objective < (1 - 1e-9) * whole.report.objective  # NaN except for the refined method
            assert max(chain.max_edge_error for chain in (*piece.wires, *piece.boundaries)) < 1e-9
            said = any(warning.startswith("Canceled") for warning in piece.report.warnings)
            assert said == (piece.report.termination == "cancelled")
        else:
            assert piece.error.code == "cancelled" and not piece.error.has_layout
            assert np.isnan(piece.vertices).all()


def resident_megabytes():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("method", METHODS)
def test_a_thousand_runs_leave_no_memory_behind(method):
    """One result takes about 0.2 MB: a leak of a hundredth of it would be seen."""

    def run(times):
        for number in range(times):
            flatten(method, progress=lambda *_, number=number: number % 3 > 0)  # every third run is canceled at once
            with pytest.raises(wirewarp.FlattenError):
                wirewarp.flatten(VERTICES, FACES + len(VERTICES))

    run(100)  # first lets the allocator get enough memory
    before = resident_megabytes()
    run(1000)
    assert resident_megabytes() - before < 2
