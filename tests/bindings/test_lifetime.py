# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects can be pickled and used in any way, also while Python ends, without an abort or a leak of memory."""

import copy
import math
import os
import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
import wirewarp
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch, tetrahedron
from wirewarp import Cache, FlattenError, Options, Wire

PROTOCOLS = range(pickle.HIGHEST_PROTOCOL + 1)
CLASSES = [value for value in vars(wirewarp).values() if isinstance(value, type) and hasattr(value, "__new__")]
COMPILED = [cls for cls in CLASSES if not issubclass(cls, str | Exception)]


def rich_result() -> wirewarp.FlattenResult:
    """Return a result with a seam, wires of two kinds, and a piece whose error proposes seams."""
    vertices, faces = half_cylinder()
    closed, closed_faces = tetrahedron()
    return wirewarp.flatten(
        np.vstack([vertices, closed + 5]),
        np.vstack([faces, closed_faces + len(vertices)]),
        seams=chain_edges(column_chain(8, 4, 4)),
        wires=[Wire(column_chain(8, 4, 2), 0.05, "bust"), Wire(column_chain(8, 4, 6), math.inf)],
        options=Options(method="wirewarp++"),
    )


def same(one: object, other: object) -> bool:
    """Return whether two objects are equal field by field and bit by bit. NaN equals NaN."""
    if hasattr(one, "_fields"):
        pairs = ((getattr(one, name), getattr(other, name, None)) for name in type(one)._fields)
        return type(one) is type(other) and all(same(*pair) for pair in pairs)
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    if isinstance(one, list | tuple):
        return type(one) is type(other) and len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, FlattenError):
        return one.to_dict() == other.to_dict()
    return one == other or (one != one and other != other)


CLONES = [copy.copy, copy.deepcopy, *(lambda each, p=p: pickle.loads(pickle.dumps(each, p)) for p in PROTOCOLS)]


@pytest.mark.parametrize("clone", CLONES)
def test_a_copy_has_the_same_bits_and_outlives_its_result(clone):
    result = rich_result()
    assert {piece.error is None for piece in result.pieces} == {True, False}
    copied = clone(result)
    pieces = [clone(piece) for piece in copied.pieces]
    assert same(copied, result)
    del copied
    assert same(pieces, result.pieces)


@pytest.mark.parametrize("clone", CLONES)
def test_a_cache_cannot_be_copied_or_pickled(clone):
    with pytest.raises(TypeError, match="Cache"):
        clone(Cache())


def test_a_pickle_of_other_fields_is_refused():
    make, arguments, state = rich_result().seams[0].__reduce_ex__(2)
    with pytest.raises(ValueError, match="version"):
        make(*arguments).__setstate__(state[:-1])


def flatten_patch(bend: float) -> wirewarp.FlattenResult:
    vertices, faces = spherical_patch(6, 6)
    return wirewarp.flatten(vertices * [1, 1, bend], faces)


@pytest.mark.skipif("WINEPREFIX" in os.environ, reason="Wine starts no executor of several processes")
def test_a_process_pool_returns_results_and_errors():
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        results = pool.map(flatten_patch, (0.5, 1.0))
        for bend, result in zip((0.5, 1.0), results, strict=True):
            assert np.array_equal(result.corner_uv, flatten_patch(bend).corner_uv)
        with pytest.raises(wirewarp.FlattenError) as caught:
            pool.submit(wirewarp.flatten, [[0, 0, 0]], [[0, 1, 2]]).result()
        assert caught.value.code == "vertex_out_of_range"


@pytest.mark.parametrize("cls", COMPILED)
def test_an_object_without_a_value_is_refused_by_its_methods(cls):
    hollow = cls.__new__(cls)
    uses = [repr, copy.copy, pickle.dumps, lambda one: one.to_dict(), lambda one: one.size, lambda one: one.vertices]
    for use in uses:
        with pytest.raises((TypeError, AttributeError)):
            use(hollow)


@pytest.mark.parametrize(
    "arguments",
    [{"wires": [Wire.__new__(Wire)]}, {"options": Options.__new__(Options)}, {"cache": Cache.__new__(Cache)}],
    ids=["Wire", "Options", "Cache"],
)
def test_an_argument_without_a_value_is_refused(arguments):
    with pytest.raises(TypeError, match="__init__"):
        wirewarp.flatten(*half_cylinder(), **arguments)


def run(*program: str) -> subprocess.CompletedProcess:
    command = [sys.executable, "-c", "\n".join([f"import sys; sys.path[:0] = {sys.path!r}", *program])]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


SHEET = [
    "import threading, time, numpy as np, wirewarp",
    "n = 200",
    "x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))",
    "vertices = np.c_[x.ravel(), y.ravel(), (0.3 * np.sin(3 * x) * np.cos(2 * y)).ravel()]",
    "i, j = np.meshgrid(np.arange(n), np.arange(n))",
    "a = (j * (n + 1) + i).ravel()",
    "faces = np.concatenate([np.c_[a, a + 1, a + n + 2], np.c_[a, a + n + 2, a + n + 1]])",
    "begun = threading.Event()",
]


@pytest.mark.parametrize("stage", ["charts", "start", "shape"])
@pytest.mark.parametrize("calls_on", [False, True])
def test_python_ends_while_a_thread_flattens(stage, calls_on):
    ended = run(
        *SHEET,
        "def progress(stage, fraction):",
        f"    if stage == {stage!r}: begun.set()",
        "def work():",
        "    wirewarp.flatten(vertices, faces, progress=progress)",
        *(["    while True: wirewarp.flatten(vertices, faces)"] if calls_on else []),
        "threading.Thread(target=work, daemon=True).start()",
        "begun.wait()",
    )
    assert ended.returncode == 0, ended.stderr


@pytest.mark.parametrize(
    "call",
    [
        "flatten(slow, faces)",
        "measure(slow, faces, vertices[faces][:, :, :2])",
        "straighten_path(slow, faces, [0, 1, 2])",
        "cut_mesh(slow, faces, [])",
        "simplify_seams(slow, faces, seams=[])",
        "propose_darts(slow, faces)",
        "start(slow, faces)",
        "SurfacePath(slow, vertices)",
        "Ease(slow, 0.05)",
        "Cloth(slow)",
        "Options(gap=slow)",
    ],
)
def test_python_ends_while_a_thread_reads_arguments(call):
    ended = run(
        *SHEET,
        "import atexit",
        "ending = threading.Event()",
        "atexit.register(ending.set)",  # registered after wirewarp's handler, so it runs before that handler
        "class Slow:",
        "    def __array__(self, dtype=None, copy=None):",
        "        begun.set()",
        "        ending.wait()",
        "        time.sleep(0.1)",  # if wirewarp's handler did not wait for this call, Python would end now
        "        wirewarp.measure(vertices, faces, vertices[faces][:, :, :2])",
        "        print('read', file=sys.stderr)",
        "        return vertices",
        "slow = Slow()",
        f"threading.Thread(target=lambda: wirewarp.{call}, daemon=True).start()",
        "begun.wait()",
    )
    assert (ended.returncode, ended.stderr) == (0, "read\n")


def test_a_mesh_is_flattened_while_python_ends():
    ended = run(
        "import atexit",
        # registered before wirewarp's handler, so it runs after that handler
        "atexit.register(lambda: print(wirewarp.flatten(vertices, faces).pieces[0].error))",
        *SHEET,
    )
    assert ended.stdout == "None\n", ended.stderr


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
def test_a_child_process_ends_although_its_parent_flattens():
    ended = run(
        *SHEET,
        "import os",
        "def progress(stage, fraction): begun.set(); time.sleep(0.01)",
        "threading.Thread(target=wirewarp.flatten, args=(vertices, faces), kwargs={'progress': progress}).start()",
        "begun.wait()",
        "child = os.fork()",
        "if child == 0: sys.exit(7)",
        "sys.exit(0 if os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7 else 1)",
    )
    assert ended.returncode == 0, ended.stderr


@pytest.mark.skipif(sys.version_info >= (3, 13), reason="_xxsubinterpreters has another name, and numpy refuses first")
@pytest.mark.parametrize("imported_before", [False, True])
def test_a_subinterpreter_is_refused(imported_before):
    ended = run(
        "import wirewarp" if imported_before else "",
        "import _xxsubinterpreters as interpreters",
        "interpreter = interpreters.create()",
        "interpreters.run_string(interpreter, 'import sys; sys.path[:0] = ' + repr(sys.path) + '\\nimport wirewarp')",
    )
    assert "main interpreter alone" in ended.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("method", ["refined", "wirewarp++", "wirewarping"])
def test_many_runs_leave_no_memory_behind(method):
    """A result takes about 0.2 MB. The test fails if each run leaks 0.005 MB or more."""
    vertices, faces = spherical_patch(columns=10, rows=10)
    across = {"wires": [Wire(range(55, 66), tolerance=0.03)], "options": Options(method=method)}

    def run(times):
        for number in range(times):
            # every third run is canceled immediately
            wirewarp.flatten(vertices, faces, **across, progress=lambda *_, n=number: n % 3 > 0)
            with pytest.raises(FlattenError):
                wirewarp.flatten(vertices, faces + len(vertices))

    def resident_megabytes():
        pages = int(Path("/proc/self/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / 2**20

    run(100)  # after these runs, the allocator has enough memory
    before = resident_megabytes()
    run(400)
    assert resident_megabytes() - before < 2
