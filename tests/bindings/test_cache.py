# SPDX-License-Identifier: GPL-3.0-or-later
"""Only changed pieces are solved again, and the result is the same as without the cache."""

import math

import numpy as np
import pytest
import wirewarp
from surfaces import chain_edges, column_chain, grid, half_cylinder
from wirewarp import Cache, ErrorCode, Wire

COLUMNS, ROWS = 12, 6


@pytest.fixture
def sheet():
    """Return arguments of flatten() for three bumps in a row, with seams between them and a wire across each bump."""

    def point(u, v):
        return 3 * u, v, 0.2 * abs(math.sin(3 * math.pi * u)) * math.sin(3 * v)

    vertices, faces = grid(COLUMNS, ROWS, point)
    seams = [*chain_edges(column_chain(COLUMNS, ROWS, 4)), *chain_edges(column_chain(COLUMNS, ROWS, 8))]
    wires = [Wire(column_chain(COLUMNS, ROWS, i), 0.02, f"wire {i}") for i in (2, 6, 10)]
    return {"vertices": vertices, "faces": faces, "seams": seams, "wires": wires}


def contents(result):
    """Return the plain values of a result, without its report and the times of its pieces."""
    plain = result.to_dict()
    del plain["report"]
    for piece in plain["pieces"]:
        del piece["report"]["seconds"]
    return plain


def run_again(cache, arguments, reused):
    """Run with and without the cache, check that both results are equal, and return the result.

    reused: expected number of reused pieces.
    """
    result = wirewarp.flatten(**arguments, cache=cache)
    fresh = wirewarp.flatten(**arguments)
    assert contents(result) == contents(fresh)
    assert np.array_equal(result.corner_uv, fresh.corner_uv, equal_nan=True)
    assert result.report["reused_pieces"] == reused
    assert fresh.report["reused_pieces"] == 0
    return result


def test_the_same_input_is_solved_again_only_after_the_cache_is_cleared(sheet):
    cache = Cache()
    run_again(cache, sheet, 0)
    assert cache.size == 3
    stages = []
    wirewarp.flatten(**sheet, cache=cache, progress=lambda stage, fraction: stages.append(stage))
    assert set(stages) == {"charts", "measure"}
    result = run_again(cache, sheet, 3)
    assert [piece.report.seconds for piece in result.pieces] == [{}] * 3
    assert repr(cache) == "Cache(size=3)"
    cache.clear()
    assert cache.size == 0
    run_again(cache, sheet, 0)


def test_only_the_piece_of_a_changed_wire_is_solved(sheet):
    cache = Cache()
    run_again(cache, sheet, 0)
    chain = sheet["wires"][1].vertices
    run_again(cache, sheet | {"wires": [sheet["wires"][0], Wire(chain, 0.04, "wire 6"), sheet["wires"][2]]}, 2)
    run_again(cache, sheet | {"wires": [sheet["wires"][0], sheet["wires"][2]]}, 2)
    # The cache has the pieces of the last run only, so the middle piece is solved again. Names do not matter.
    run_again(cache, sheet | {"wires": [Wire(wire.vertices, wire.tolerance) for wire in sheet["wires"]]}, 2)


def test_pieces_are_reused_if_only_the_numbers_of_their_elements_change(sheet):
    cache = Cache()
    run_again(cache, sheet, 0)
    more = half_cylinder()
    n = len(more[0])
    shifted = {
        "vertices": np.concatenate([more[0] + 10, sheet["vertices"]]),
        "faces": np.concatenate([more[1], sheet["faces"] + n]),
        "seams": np.array(sheet["seams"]) + n,
        "wires": [Wire([0, 1]), *(Wire(wire.vertices + n, wire.tolerance, wire.name) for wire in sheet["wires"])],
    }
    result = run_again(cache, shifted, 3)
    assert len(result.pieces) == 4


def test_an_error_is_reused_only_if_it_names_the_same_elements():
    vertices, faces = grid(8, 8, lambda u, v: (u, v, 5 * math.sin(math.pi * u) * math.sin(math.pi * v)))
    cache = Cache()
    first = run_again(cache, {"vertices": vertices, "faces": faces}, 0)
    assert first.pieces[0].error.code is ErrorCode.boundary_too_short
    run_again(cache, {"vertices": vertices, "faces": faces}, 1)
    shifted = {"vertices": np.concatenate([[[5.0, 5, 5]], vertices]), "faces": faces + 1}
    again = run_again(cache, shifted, 0)
    assert again.pieces[0].error.faces == first.pieces[0].error.faces
    assert again.pieces[0].error.vertices != first.pieces[0].error.vertices


def test_a_canceled_piece_is_solved_in_the_next_run(sheet):
    cache = Cache()
    cancelled = wirewarp.flatten(**sheet, cache=cache, progress=lambda stage, fraction: stage == "charts")
    ends = [piece.report.termination for piece in cancelled.pieces]
    assert "cancelled" in ends  # always the piece of the calling thread; pieces of other threads may be finished
    assert cache.size == ends.count("converged")
    run_again(cache, sheet, cache.size)


def test_a_canceled_run_keeps_reused_pieces(sheet):
    cache = Cache()
    run_again(cache, sheet, 0)
    vertices = sheet["vertices"].copy()
    vertices[1, 2] += 0.01
    changed = sheet | {"vertices": vertices}
    wirewarp.flatten(**changed, cache=cache, progress=lambda *call: False)
    assert cache.size == 3, "the run ended before any piece, so the cache must not change"
    wirewarp.flatten(**changed, cache=cache, progress=lambda stage, fraction: stage == "charts")
    assert cache.size == 2
    run_again(cache, sheet | {"vertices": vertices}, 2)
