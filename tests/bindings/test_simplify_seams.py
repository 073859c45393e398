# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams that a model can do without, through Python."""

import json
import pickle

import numpy as np
import pytest
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch
from wirewarp import Ease, ErrorCode, FlattenError, Options, flatten, simplify_seams, start_simplify

DOME = spherical_patch(8, 8)
COLUMNS = np.concatenate([chain_edges(column_chain(8, 8, column)) for column in (2, 4, 6)])


def undirected(edges):
    return {frozenset(pair) for pair in edges.tolist()}


def test_a_developable_model_becomes_one_piece_again():
    vertices, faces = half_cylinder()
    seams = chain_edges(column_chain(8, 4, 4))
    fewer = simplify_seams(vertices, faces, seams=seams, strain=0)
    assert (fewer.num_pieces_before, fewer.num_pieces, fewer.edges.shape) == (2, 1, (0, 2))
    assert undirected(fewer.opened) == undirected(np.asarray(seams))


@pytest.mark.parametrize("options", [None, Options(cloth="woven"), Options(thickness=0.05)])
def test_figures_are_those_of_a_run_with_the_seams_that_remain(options):
    fewer = simplify_seams(*DOME, seams=COLUMNS, options=options, strain=0.1)
    assert len(fewer.opened) > 0 and undirected(fewer.edges) | undirected(fewer.opened) == undirected(COLUMNS)
    for seams, energy, count in (
        (COLUMNS, fewer.energy_before, fewer.num_pieces_before),
        (fewer.edges, fewer.energy, fewer.num_pieces),
    ):
        pieces = flatten(*DOME, seams=seams, options=options).pieces
        areas = [piece.metrics.area_3d for piece in pieces]
        has_cloth = options is not None and options.cloth is not None
        energies = [piece.metrics.cloth_energy if has_cloth else piece.metrics.arap_energy for piece in pieces]
        tolerance = 1e-4 if has_cloth else 1e-6  # the best direction of a fabric is found only to 1e-4
        assert energy == pytest.approx(np.average(energies, weights=areas), rel=tolerance)
        assert count == len(pieces)
    assert fewer.strain <= max(0.1, fewer.strain_before) and not fewer.was_stopped


def test_an_eased_seam_remains():
    column = column_chain(8, 8, 4)
    fewer = simplify_seams(*DOME, seams=COLUMNS, eases=[Ease(chain_edges(column), 0.02)], strain=0.5)
    assert undirected(fewer.edges) == undirected(np.asarray(chain_edges(column)))


def test_proposals_are_plain_values():
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1)
    assert json.loads(json.dumps(fewer.to_dict()))["edges"] == fewer.edges.tolist()
    assert pickle.loads(pickle.dumps(fewer)).to_dict() == fewer.to_dict()


def test_a_stopped_search_returns_its_best_result():
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1, progress=lambda _, fraction: fraction < 0.5)
    assert fewer.was_stopped and undirected(fewer.edges) | undirected(fewer.opened) == undirected(COLUMNS)
    with pytest.raises(FlattenError) as raised:
        simplify_seams(*DOME, seams=COLUMNS, progress=lambda *_: False)
    assert raised.value.code is ErrorCode.cancelled


def test_a_job_finds_the_same():
    job = start_simplify(*DOME, seams=COLUMNS, strain=0.1)
    assert job.result().to_dict() == simplify_seams(*DOME, seams=COLUMNS, strain=0.1).to_dict()


def test_a_strain_below_zero_is_refused():
    with pytest.raises(FlattenError, match="it must be 0 or more"):
        simplify_seams(*DOME, seams=COLUMNS, strain=-1)
