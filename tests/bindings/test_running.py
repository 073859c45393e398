# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs report their progress, can be canceled, and let other threads run."""

import signal
import sys
import threading
import time

import numpy as np
import pytest
import wirewarp
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch


def test_progress_goes_from_nothing_to_everything():
    calls = []
    seams = chain_edges(column_chain(8, 4, 4))
    wirewarp.flatten(*half_cylinder(), seams=seams, progress=lambda *call: calls.append(call))
    stages, fractions = zip(*calls, strict=True)
    assert all(isinstance(stage, str) for stage in stages)
    assert list(fractions) == sorted(fractions) and (fractions[0], fractions[-1]) == (0, 1)


@pytest.mark.parametrize("answer", [False, np.False_, 0, True, None, 1], ids=repr)
def test_only_a_false_answer_cancels(answer):
    calls = []

    def progress(stage, fraction):
        calls.append(stage)
        return answer

    result = wirewarp.flatten(*half_cylinder(), progress=progress)
    (piece,) = result.pieces
    if answer in (True, None):
        assert piece.error is None
    else:
        assert len(calls) == 1
        assert (piece.error.code, piece.report.termination) == ("cancelled", "cancelled")
        assert np.isnan(result.corner_uv).all()


def test_an_exception_in_progress_stops_the_run_and_is_raised():
    error = RuntimeError("no more")
    calls = []

    def progress(stage, fraction):
        calls.append(stage)
        raise error

    with pytest.raises(RuntimeError) as caught:
        wirewarp.flatten(*half_cylinder(), progress=progress)
    assert caught.value is error
    assert len(calls) == 1


def test_an_answer_without_a_truth_value_is_an_exception():
    with pytest.raises(ValueError, match="ambiguous"):
        wirewarp.flatten(*half_cylinder(), progress=lambda stage, fraction: np.zeros(2))


def test_ctrl_c_stops_the_run(python_handles_ctrl_c):
    with pytest.raises(KeyboardInterrupt):
        wirewarp.flatten(*half_cylinder(), progress=lambda stage, fraction: signal.raise_signal(signal.SIGINT))


@pytest.fixture
def no_forced_switches():
    """Make Python switch threads only when a thread releases the GIL itself."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    yield
    sys.setswitchinterval(interval)


@pytest.mark.parametrize("measuring", [False, True], ids=["flatten", "measure"])
def test_other_threads_run_meanwhile(no_forced_switches, measuring):
    vertices, faces = spherical_patch(columns=60, rows=60)
    uv = wirewarp.flatten(vertices, faces).corner_uv if measuring else None
    ticks = 0
    stop = threading.Event()

    def tick():
        nonlocal ticks
        while not stop.is_set():
            ticks += 1
            time.sleep(0)  # lets another thread take the GIL

    thread = threading.Thread(target=tick)
    thread.start()
    before = ticks
    for _ in range(1000):  # repeated, because a busy machine may not wake the thread within one call
        if measuring:
            wirewarp.measure(vertices, faces, uv)
        else:
            wirewarp.flatten(vertices, faces)
        after = ticks
        if after > before:
            break
    stop.set()
    thread.join()
    assert after > before
