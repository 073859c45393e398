# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs flatten meshes and search for cuts while Python continues."""

import copy
import gc
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from refusals import code_of
from surfaces import half_cylinder, spherical_patch


def test_a_job_ends_with_the_result_of_flatten():
    vertices, faces = spherical_patch(20, 20)
    wires = [wirewarp.Wire([0, 1, 2], name="edge")]
    options = wirewarp.Options(fairness=0.2)
    other = wirewarp.start(*half_cylinder(20, 20))  # runs at the same time
    job = wirewarp.start(vertices, faces, wires=wires, options=options)
    result = job.result()
    assert np.array_equal(other.result().corner_uv, wirewarp.flatten(*half_cylinder(20, 20)).corner_uv)
    assert job.is_done() and job.progress() == ("measure", 1.0)
    assert job.result() is result
    assert np.array_equal(result.corner_uv, wirewarp.flatten(vertices, faces, wires=wires, options=options).corner_uv)


def test_the_caller_may_change_the_arrays():
    vertices, faces = spherical_patch(20, 20)
    expected = wirewarp.flatten(vertices, faces).corner_uv
    job = wirewarp.start(vertices, faces)
    vertices[:], faces[:] = 0, 0
    assert np.array_equal(job.result().corner_uv, expected)


def test_a_job_fills_its_cache():
    cache = wirewarp.Cache()
    wirewarp.start(*half_cylinder(), cache=cache).result()
    assert wirewarp.start(*half_cylinder(), cache=cache).result().report["reused_pieces"] == 1


def test_a_canceled_job_reports_it():
    job = wirewarp.start(*spherical_patch(300, 300))
    job.cancel()
    assert [piece.error.code for piece in job.result().pieces] == [wirewarp.ErrorCode.cancelled]


def test_start_refuses_wrong_types_and_result_raises_errors_of_the_mesh():
    for wrong in ({"options": 3}, {"cache": {}}):
        assert code_of(lambda wrong=wrong: wirewarp.start(*half_cylinder(), **wrong)) == "invalid_type"
    job = wirewarp.start(half_cylinder()[0], [[0, 1, 10_000_000]])
    assert [code_of(job.result) for _ in range(2)] == ["vertex_out_of_range"] * 2


@pytest.mark.parametrize(
    ("start", "find", "limits"),
    [
        (wirewarp.start_darts, wirewarp.propose_darts, {"count": 2, "longest": 1.5}),
        (wirewarp.start_darts, wirewarp.propose_darts, {"count": 1, "smooth": True}),
        (wirewarp.start_seams, wirewarp.propose_seams, {"count": 2, "longest": 1.5, "smooth": True}),
        (wirewarp.start_plan, wirewarp.plan_cuts, {"kind": "dart", "strain": 0.0, "most": 2, "twins": True}),
    ],
)
def test_proposals_are_found_in_a_job(start, find, limits):
    mesh = spherical_patch(8, 8)
    job = start(*mesh, **limits)
    found = job.result()
    assert job.progress()[0] == "cuts" and job.result() is found
    assert [each.to_dict() for each in found] == [each.to_dict() for each in find(*mesh, **limits)]
    assert code_of(start(*half_cylinder()).result) == "no_proposal"
    assert code_of(start(*half_cylinder(), strain=-1.0).result) == "invalid_option"
    with pytest.raises(wirewarp.FlattenError, match="no_seam"):
        start(*mesh, no_seam="all")
    job = start(*spherical_patch(100, 100))
    job.cancel()
    assert code_of(job.result) == "cancelled"


def test_a_job_without_references_is_canceled():
    cache = wirewarp.Cache()
    job = wirewarp.start(*spherical_patch(300, 300), cache=cache)
    del job
    gc.collect()  # waits until the job's thread has ended
    assert cache.size == 0  # a cache keeps no canceled pieces


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="this system sends no signals to threads")
def test_ctrl_c_while_waiting_cancels():
    waits, has_ended = False, threading.Event()

    def press(_signal, _frame):
        if waits:
            raise KeyboardInterrupt

    def press_again_and_again():
        while not has_ended.wait(0.01):
            signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)

    handler = signal.signal(signal.SIGINT, press)
    presser = threading.Thread(target=press_again_and_again)
    presser.start()
    try:
        job = wirewarp.start(*spherical_patch(300, 300))
        with pytest.raises(KeyboardInterrupt):
            waits = True
            job.result()
        waits = False
        assert [piece.error.code for piece in job.result().pieces] == [wirewarp.ErrorCode.cancelled]
    finally:
        waits = False
        has_ended.set()
        presser.join()
        signal.signal(signal.SIGINT, handler)


def test_a_job_is_neither_copied_nor_pickled_nor_made_without_start():
    job = wirewarp.start(*half_cylinder())
    for clone in (copy.copy, pickle.dumps):
        with pytest.raises(TypeError, match="cannot be copied or pickled"):
            clone(job)
    with pytest.raises(TypeError):
        wirewarp.Job()
    with pytest.raises(TypeError):
        wirewarp.Job.__new__(wirewarp.Job).progress()


ENDS_WITH_A_JOB = """
import sys, wirewarp
sys.path.insert(0, {folder!r})
from surfaces import spherical_patch
job = wirewarp.start(*spherical_patch(300, 300))
print("the end")
"""


def test_python_ends_while_a_job_runs():
    code = ENDS_WITH_A_JOB.format(folder=str(Path(__file__).parent))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (0, "the end\n", "")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
def test_a_job_is_not_in_a_forked_process():
    job = wirewarp.start(*spherical_patch(100, 100))

    def ask(answers):
        for method in (job.result, job.progress, job.is_done):
            try:
                method()
            except RuntimeError as error:
                answers.put(str(error))

    context = multiprocessing.get_context("fork")
    answers = context.SimpleQueue()
    child = context.Process(target=ask, args=(answers,))
    child.start()
    child.join(60)
    assert child.exitcode == 0
    assert all("not in one forked from it" in answers.get() for _ in range(3))
    assert not job.result().pieces[0].error


def test_progress_goes_up_to_the_end():
    job = wirewarp.start(*spherical_patch(200, 200))
    fractions = [job.progress()[1]]
    while not job.is_done():
        fractions.append(job.progress()[1])
        time.sleep(0.001)
    assert fractions == sorted(fractions)
