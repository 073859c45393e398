# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams that a model can do without, through Python. tests/native/test_simplify_seams.cpp tests which ones."""

import json
import pickle

import numpy as np
import pytest
from surfaces import chain_edges, column_chain, spherical_patch
from wirewarp import Ease, ErrorCode, FlattenError, Options, flatten, simplify_seams, start_simplify

DOME = spherical_patch(8, 8)
COLUMNS = np.concatenate([chain_edges(column_chain(8, 8, column)) for column in (2, 4, 6)])


def undirected(edges):
    return {frozenset(pair) for pair in np.asarray(edges).tolist()}


def test_the_arguments_reach_the_search_and_figures_are_those_of_a_run():
    eased = chain_edges(column_chain(8, 8, 4))
    arguments = {"seams": COLUMNS, "eases": [Ease(eased, 0.02)], "options": Options(thickness=0.05)}
    fewer = simplify_seams(*DOME, **arguments, strain=0.5)
    assert undirected(fewer.edges) == undirected(eased)  # they remain, because they have an ease
    assert undirected(fewer.edges) | undirected(fewer.opened) == undirected(COLUMNS)
    for seams, energy, count in (
        (COLUMNS, fewer.energy_before, fewer.num_pieces_before),
        (fewer.edges, fewer.energy, fewer.num_pieces),
    ):
        pieces = flatten(*DOME, **arguments | {"seams": seams}).pieces
        areas, energies = zip(*((piece.metrics.area_3d, piece.metrics.arap_energy) for piece in pieces), strict=True)
        assert energy == pytest.approx(np.average(energies, weights=areas), rel=1e-6)
        assert count == len(pieces)
    assert fewer.strain <= max(0.5, fewer.strain_before) and not fewer.was_stopped


def test_results_are_plain_values_and_jobs_find_the_same():
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1)
    assert json.loads(json.dumps(fewer.to_dict()))["edges"] == fewer.edges.tolist()
    assert pickle.loads(pickle.dumps(fewer)).to_dict() == fewer.to_dict()
    assert start_simplify(*DOME, seams=COLUMNS, strain=0.1).result().to_dict() == fewer.to_dict()


def test_a_stopped_search_returns_its_best_result():
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1, progress=lambda _, fraction: fraction < 0.5)
    assert fewer.was_stopped and undirected(fewer.edges) | undirected(fewer.opened) == undirected(COLUMNS)
    with pytest.raises(FlattenError) as raised:
        simplify_seams(*DOME, seams=COLUMNS, progress=lambda *_: False)
    assert raised.value.code is ErrorCode.cancelled
    with pytest.raises(FlattenError, match="it must be 0 or more"):
        simplify_seams(*DOME, seams=COLUMNS, strain=-1)
