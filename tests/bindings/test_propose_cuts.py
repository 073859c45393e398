# SPDX-License-Identifier: GPL-3.0-or-later
"""Darts and seams proposed for pieces that are flat but distorted."""

import json
import pickle

import numpy as np
import pytest
import trimesh
from surfaces import chain_edges, column_chain, spherical_patch, tetrahedron
from wirewarp import Cloth, ErrorCode, FlattenError, Options, Wire, flatten, plan_cuts, propose_darts, propose_seams
from wirewarp.pattern import has_room
from wirewarp.report.make import make_report

DOME = spherical_patch(8, 8)
MIDDLE = column_chain(8, 8, 4)[2:5]


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
        report = make_report(
            flatten(**mesh, seams=seams), *DOME, wires=[wire], cloth=options.cloth if options else None
        )
        return max(piece.needed for piece in report.pieces)

    before = needed(None)
    for propose in (propose_darts, propose_seams):
        for proposal in propose(**mesh, count=1):
            assert proposal.strain_before == pytest.approx(before, abs=1e-6)
            assert proposal.strain == pytest.approx(needed(proposal.edges), abs=1e-6)
            assert min(proposal.strain, proposal.strain_with_twin or np.inf) < before


def test_cut_sets_have_pieces_that_are_wide_enough():
    ball = trimesh.creation.icosphere(subdivisions=1)
    vertices, faces = ball.vertices * (1 + 0.3 * ball.vertices[:, :1]), ball.faces

    def num_narrow(narrowest):
        sets = propose_seams(vertices, faces, strain=0.1, narrowest=narrowest)
        pieces = [piece for each in sets for piece in flatten(vertices, faces, seams=each.edges).pieces]
        return sum(not has_room(piece, 0.25) for piece in pieces)

    assert num_narrow(0.0) > 0
    assert num_narrow(0.5) == 0


def test_a_stopped_search_returns_the_cut_sets_found_by_then():
    ball = trimesh.creation.icosphere(subdivisions=1)
    sets = propose_seams(ball.vertices, ball.faces, progress=lambda _, fraction: fraction < 0.5)
    assert sets
    for each in sets:
        pieces = flatten(ball.vertices, ball.faces, seams=each.edges).pieces
        assert len(pieces) == each.num_pieces and all(piece.error is None for piece in pieces)


def test_a_closed_model_gets_cut_sets():
    vertices, faces = tetrahedron()
    first = propose_seams(vertices, faces)[0]
    assert all(piece.error is None for piece in flatten(vertices, faces, seams=first.edges).pieces)
    assert (first.energy_before, first.strain_before, first.twin) == (np.inf, np.inf, None)
    assert first.to_dict()["energy_before"] is None
    assert plan_cuts(vertices, faces, kind="seam", most=1)[0].edges.tolist() == first.edges.tolist()
    with pytest.raises(FlattenError, match="no set of seams along edges that may have a seam was found"):
        propose_seams(vertices, faces, no_seam=np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))


def test_proposals_are_plain_values():
    (proposal, *_) = propose_darts(*DOME, count=1)
    assert json.loads(json.dumps(proposal.to_dict()))["edges"] == proposal.edges.tolist()
    assert pickle.loads(pickle.dumps(proposal)).to_dict() == proposal.to_dict()


def test_existing_seams_stay():
    seams = chain_edges(column_chain(8, 8, 4))
    proposals = propose_darts(*DOME, seams=seams, piece=1)
    assert {proposal.piece for proposal in proposals} == {1}
    vertices = set(flatten(*DOME, seams=seams).pieces[1].source_vertex)
    assert all(set(proposal.edges.ravel()) <= vertices for proposal in proposals)


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
        (propose_darts, {"count": 0}, "count is 0"),
        (propose_darts, {"strain": -1.0}, "strain is -1"),
        (propose_darts, {"longest": 0.0}, "longest is 0"),
        (propose_darts, {"piece": 1}, "piece is 1"),
        (propose_seams, {"narrowest": -1.0}, "narrowest is -1: it must be a finite number of 0 or more"),
        (propose_seams, {"narrowest": np.inf}, "it must be a finite number of 0 or more"),
        (propose_seams, {"no_seam": [[0, 9999]]}, "with the pair 0, 9999: it must contain edges of the mesh only"),
        (
            propose_darts,
            {"no_crossing": [[0, 9999]]},
            "no_crossing is a list with the pair 0, 9999: it must contain edges",
        ),
        (plan_cuts, {"kind": "zip"}, "it must be dart or seam"),
        (plan_cuts, {"most": 0}, "option most is 0: it must be at least 1"),
        (plan_cuts, {"strain": 1.0}, "is accepted"),
    ],
)
def test_wrong_options_are_refused(find, limits, said):
    with pytest.raises(FlattenError, match=said):
        find(*DOME, **limits)


@pytest.mark.parametrize("propose", [propose_darts, propose_seams])
def test_no_cut_runs_along_an_edge_without_seams(propose):
    barred = propose(*DOME, count=1)[0].edges
    taken = {frozenset(pair) for pair in barred.tolist()}
    for proposal in propose(*DOME, no_seam=barred[:, ::-1]):
        assert not taken & {frozenset(pair) for pair in proposal.edges.tolist()}


def test_a_plan_keeps_to_its_limits():
    """The limits are the target strain, the number of cuts, their length, and edges without seams."""
    first, second = plan_cuts(*DOME, strain=0.0, most=2)
    assert second.strain_before == pytest.approx(first.strain, rel=1e-6)
    assert len(plan_cuts(*DOME, strain=first.strain + 1e-6, most=2)) == 1
    assert sum(cut.length for cut in plan_cuts(*DOME, strain=0.0, most=3, total_length=1.0)) <= 1
    taken = {frozenset(pair) for pair in first.edges.tolist()}
    for cut in plan_cuts(*DOME, strain=0.0, most=1, no_seam=first.edges, longest=1.0, seams=[]):
        assert cut.length <= 1.0 and not taken & {frozenset(pair) for pair in cut.edges.tolist()}
    cuts = plan_cuts(*DOME, kind="seam", strain=0.0, most=2)
    assert len(flatten(*DOME, seams=np.concatenate([cut.edges for cut in cuts])).pieces) == 3  # a part is cut again
