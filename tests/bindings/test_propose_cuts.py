# SPDX-License-Identifier: GPL-3.0-or-later
"""Proposed darts, proposed seams and simplified seams have the figures of the model that is flattened with them."""

import json
import pickle

import numpy as np
import pytest
import trimesh
from refusals import code_of
from surfaces import chain_edges, column_chain, spherical_patch, tetrahedron
from wirewarp import (
    Cloth,
    Ease,
    ErrorCode,
    FlattenError,
    Options,
    Wire,
    cut_mesh,
    flatten,
    plan_cuts,
    propose_darts,
    propose_seams,
    simplify_seams,
    start_simplify,
)
from wirewarp.pattern import has_room
from wirewarp.report.make import make_report

DOME = spherical_patch(8, 8)
MIDDLE = column_chain(8, 8, 4)[2:5]
COLUMNS = np.concatenate([chain_edges(column_chain(8, 8, column)) for column in (2, 4, 6)])


@pytest.mark.core
@pytest.mark.parametrize(
    ("wire", "options"),
    [
        (Wire(MIDDLE), None),
        (Wire(MIDDLE, ease=0.02), None),
        (Wire(MIDDLE), Options(cloth="woven")),
        (Wire(MIDDLE, ease=-0.03), Options(cloth=Cloth(stretch=(0.1, 0.05)))),
        (Wire(MIDDLE), Options(thickness=0.05)),
    ],
)
def test_strain_is_the_figure_of_the_report_and_decreases(wire, options):
    mesh = {"vertices": DOME[0], "faces": DOME[1], "wires": [wire], "options": options}

    def needed(seams):
        cloth = options.cloth if options else None
        report = make_report(flatten(**mesh, seams=seams), *DOME, wires=[wire], cloth=cloth)
        return max(piece.needed for piece in report.pieces)

    before = needed(None)
    for propose in (propose_darts, propose_seams):
        for proposal in propose(**mesh, count=1):
            assert proposal.strain_before == pytest.approx(before, abs=1e-6)
            assert proposal.strain == pytest.approx(needed(proposal.edges), abs=1e-6)
            assert min(proposal.strain, proposal.strain_with_twin or np.inf) < before


def test_smooth_cuts_have_the_figures_of_the_mesh_that_is_cut_along_them():
    darts = propose_darts(*DOME, count=1, smooth=True)
    assert any(len(each.edges) == 0 for each in darts), "no dart crosses a triangle"
    for each in darts:
        vertices, faces, edges, _ = cut_mesh(*DOME, each.paths)
        (piece,) = make_report(flatten(vertices, faces, seams=edges), vertices, faces).pieces
        assert piece.needed == pytest.approx(each.strain, abs=1e-6)
    crossed = np.array([line[[0, -1]] for line in cut_mesh(*DOME, darts[0].paths)[3].divided_edges])
    for other in propose_darts(*DOME, smooth=True, no_crossing=crossed):
        divided = {tuple(line[[0, -1]].tolist()) for line in cut_mesh(*DOME, other.paths)[3].divided_edges}
        assert divided.isdisjoint(map(tuple, crossed.tolist()))


@pytest.mark.parametrize("propose", [propose_darts, propose_seams, plan_cuts])
def test_cuts_along_edges_have_paths_that_change_no_mesh(propose):
    vertices, faces = DOME
    proposal = propose(vertices, faces)[0]
    new_vertices, new_faces, edges, _ = cut_mesh(vertices, faces, proposal.paths)
    assert (new_vertices == vertices).all() and (new_faces == faces).all()
    assert (edges == proposal.edges).all()


def test_a_stopped_search_returns_the_wide_cut_sets_found_by_then():
    ball = trimesh.creation.icosphere(subdivisions=1)
    mesh = (ball.vertices * (1 + 0.3 * ball.vertices[:, :1]), ball.faces)

    def pieces(**options):
        sets = propose_seams(*mesh, strain=0.1, **options)
        cut = [flatten(*mesh, seams=each.edges).pieces for each in sets]
        assert sets and [len(each) for each in cut] == [each.num_pieces for each in sets]
        return [piece for each in cut for piece in each]

    assert not all(has_room(piece, 0.25) for piece in pieces(narrowest=0.0))
    assert all(has_room(piece, 0.25) for piece in pieces(narrowest=0.5))
    assert all(piece.error is None for piece in pieces(progress=lambda _, fraction: fraction < 0.5))


def test_a_closed_model_gets_cut_sets():
    vertices, faces = tetrahedron()
    first = propose_seams(vertices, faces)[0]
    assert all(piece.error is None for piece in flatten(vertices, faces, seams=first.edges).pieces)
    assert (first.energy_before, first.strain_before, first.twin) == (np.inf, np.inf, None)
    assert first.to_dict()["energy_before"] is None
    assert plan_cuts(vertices, faces, kind="seam", most=1)[0].edges.tolist() == first.edges.tolist()
    with pytest.raises(FlattenError, match="No set of seams along edges that may have a seam was found"):
        propose_seams(vertices, faces, no_seam=np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))


def test_proposals_are_plain_values_and_a_job_finds_the_same():
    (proposal, *_) = propose_darts(*DOME, count=1)
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1)
    for each in (proposal, fewer):
        assert json.loads(json.dumps(each.to_dict()))["edges"] == each.edges.tolist()
        assert pickle.loads(pickle.dumps(each)).to_dict() == each.to_dict()
    assert start_simplify(*DOME, seams=COLUMNS, strain=0.1).result().to_dict() == fewer.to_dict()


def test_progress_is_reported_and_can_cancel():
    reported = []
    propose_darts(*DOME, count=1, progress=lambda stage, fraction: reported.append((stage, fraction)))
    assert {stage for stage, _ in reported} == {"cuts"}
    fractions = [fraction for _, fraction in reported]
    assert fractions == sorted(fractions) and fractions[0] >= 0 and fractions[-1] < 1
    with pytest.raises(FlattenError, match="Canceled") as raised:
        propose_darts(*DOME, progress=lambda *_: False)
    assert raised.value.code is ErrorCode.cancelled


@pytest.mark.parametrize(
    ("find", "limits", "said"),
    [
        (propose_darts, {"strain": -1.0}, "strain is -1"),
        (propose_seams, {"narrowest": np.inf}, "it must be a finite number of 0 or more"),
        (propose_seams, {"no_seam": [[0, 9999]]}, "with the pair 0, 9999: it must contain edges of the mesh only"),
        (propose_darts, {"no_crossing": [[0, 9999]]}, "no_crossing is a list with the pair 0, 9999: it must contain"),
        (plan_cuts, {"kind": "zip"}, "it must be dart or seam"),
        (plan_cuts, {"most": 0}, "option most is 0: it must be at least 1"),
        (plan_cuts, {"strain": 1.0}, "is accepted"),
        (simplify_seams, {"seams": COLUMNS, "strain": -1}, "it must be 0 or more"),
    ],
)
def test_wrong_options_are_refused(find, limits, said):
    with pytest.raises(FlattenError, match=said):
        find(*DOME, **limits)


def test_a_plan_keeps_to_its_limits():
    first, second = plan_cuts(*DOME, strain=0.0, most=2)
    assert second.strain_before == pytest.approx(first.strain, rel=1e-6)
    assert len(plan_cuts(*DOME, strain=first.strain + 1e-6, most=2)) == 1
    assert sum(cut.length for cut in plan_cuts(*DOME, strain=0.0, most=3, total_length=1.0)) <= 1
    taken = {frozenset(pair) for pair in first.edges.tolist()}
    for cut in plan_cuts(*DOME, strain=0.0, most=1, no_seam=first.edges, longest=1.0, seams=[]):
        assert cut.length <= 1.0 and not taken & {frozenset(pair) for pair in cut.edges.tolist()}
    cuts = plan_cuts(*DOME, kind="seam", strain=0.0, most=2)
    # The second cut divides one of the two parts.
    assert len(flatten(*DOME, seams=np.concatenate([cut.edges for cut in cuts])).pieces) == 3


def undirected(edges):
    return {frozenset(pair) for pair in np.asarray(edges).tolist()}


def test_fewer_seams_keep_to_the_arguments_and_have_the_figures_of_a_run():
    eased = chain_edges(column_chain(8, 8, 4))
    arguments = {"seams": COLUMNS, "eases": [Ease(eased, 0.02)], "options": Options(thickness=0.05)}
    fewer = simplify_seams(*DOME, **arguments, strain=0.5)
    assert undirected(fewer.edges) == undirected(eased)  # seams with an ease remain
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


def test_a_stopped_search_returns_the_fewest_seams_found_by_then():
    fewer = simplify_seams(*DOME, seams=COLUMNS, strain=0.1, progress=lambda _, fraction: fraction < 0.5)
    assert fewer.was_stopped and undirected(fewer.edges) | undirected(fewer.opened) == undirected(COLUMNS)
    canceled = code_of(lambda: simplify_seams(*DOME, seams=COLUMNS, progress=lambda *_: False))
    assert canceled is ErrorCode.cancelled
