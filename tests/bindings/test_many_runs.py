# SPDX-License-Identifier: GPL-3.0-or-later
"""Many runs, canceled at every step, leave no memory behind."""

import os
import sys
from pathlib import Path

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


def resident_megabytes():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("method", METHODS)
def test_many_runs_leave_no_memory_behind(method):
    """One result takes about 0.2 MB: a leak of a fortieth of it would be seen."""

    def run(times):
        for number in range(times):
            flatten(method, progress=lambda *_, number=number: number % 3 > 0)  # every third run is canceled at once
            with pytest.raises(wirewarp.FlattenError):
                wirewarp.flatten(VERTICES, FACES + len(VERTICES))

    run(100)  # first lets the allocator get enough memory
    before = resident_megabytes()
    run(400)
    assert resident_megabytes() - before < 2
