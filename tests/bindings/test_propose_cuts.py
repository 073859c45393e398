# SPDX-License-Identifier: GPL-3.0-or-later
"""Darts and seams proposed for pieces that are flat but distorted."""

import json
import pickle

import numpy as np
import pytest
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch
from wirewarp import Cloth, ErrorCode, FlattenError, Options, Wire, flatten, plan_cuts, propose_darts, propose_seams
from wirewarp.report.make import make_report

DOME = spherical_patch(8, 8)
MIDDLE = column_chain(8, 8, 4)[2:5]


@pytest.mark.parametrize("propose", [propose_darts, propose_seams])
def test_the_figures_are_those_of_a_run_with_the_edges_as_seams(propose):
    wires = [Wire(column_chain(8, 8, 4)[2:5])]
    before = flatten(*DOME, wires=wires).pieces[0].metrics.arap_energy
    proposals = propose(*DOME, wires=wires, count=2)
    for proposal in proposals:
        pieces = flatten(*DOME, wires=wires, seams=proposal.edges).pieces
        assert [piece.error for piece in pieces if piece.error] == []
        areas = [piece.metrics.area_3d for piece in pieces]
        energy = np.average([piece.metrics.arap_energy for piece in pieces], weights=areas)
        assert proposal.energy == pytest.approx(energy, abs=1e-6 * before)
        assert proposal.energy_before == pytest.approx(before, rel=1e-6)
        assert proposal.energy < proposal.energy_before
    assert len(proposals) in (2, 3, 4)  # twins counted once


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
def test_strain_is_the_figure_of_the_report_and_gets_less(wire, options):
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


def ball(around=12, rings=10):
    """Return a closed ball of radius 1."""
    angles, heights = 2 * np.pi * np.arange(around) / around, np.pi * np.arange(1, rings) / rings
    x, y = (np.outer(np.sin(heights), each(angles)).ravel() for each in (np.cos, np.sin))
    vertices = np.vstack([[0, 0, -1], np.column_stack([x, y, -np.repeat(np.cos(heights), around)]), [0, 0, 1]])
    top, faces = len(vertices) - 1, []
    for i in range(around):
        j = (i + 1) % around
        faces += [[0, 1 + j, 1 + i], [top, top - around + i, top - around + j]]
        for low in range(1, top - around, around):
            faces += [[low + i, low + j, low + around + j], [low + i, low + around + j, low + around + i]]
    return vertices, np.array(faces)


def test_a_ball_gets_sets_of_first_cuts():
    sets = propose_seams(*ball(), strain=0.25)
    assert sets[0].strain <= 0.25
    assert [each.strain for each in sets] == sorted(each.strain for each in sets)
    for each in sets:
        pieces = flatten(*ball(), seams=each.edges).pieces
        assert [piece.error for piece in pieces if piece.error] == []
        areas = [piece.metrics.area_3d for piece in pieces]
        energy = np.average([piece.metrics.arap_energy for piece in pieces], weights=areas)
        assert each.energy == pytest.approx(energy, rel=1e-6)
        assert (each.energy_before, each.strain_before, each.twin) == (np.inf, np.inf, None)
        assert each.to_dict()["energy_before"] is None
    assert plan_cuts(*ball(), kind="seam", strain=0.25, most=1)[0].edges.tolist() == sets[0].edges.tolist()


def test_where_no_seam_may_run_there_are_no_first_cuts():
    vertices, faces = ball()
    with pytest.raises(FlattenError, match="no set of seams along edges that may have a seam was found") as raised:
        propose_seams(vertices, faces, no_seam=np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))
    assert raised.value.code is ErrorCode.no_proposal


def test_proposals_are_plain_values():
    (proposal, *_) = propose_darts(*DOME, count=1)
    assert json.loads(json.dumps(proposal.to_dict()))["edges"] == proposal.edges.tolist()
    assert pickle.loads(pickle.dumps(proposal)).to_dict() == proposal.to_dict()


def test_seams_that_are_there_stay():
    seams = chain_edges(column_chain(8, 8, 4))
    proposals = propose_darts(*DOME, seams=seams, piece=1)
    assert {proposal.piece for proposal in proposals} == {1}
    vertices = set(flatten(*DOME, seams=seams).pieces[1].source_vertex)
    assert all(set(proposal.edges.ravel()) <= vertices for proposal in proposals)


def test_the_method_and_the_cloth_asked_for_are_what_is_measured():
    options = Options(cloth="woven")
    (proposal, *_) = propose_darts(*DOME, options=options, count=1)
    cut = flatten(*DOME, seams=proposal.edges, options=options).pieces[0].metrics
    assert proposal.energy == pytest.approx(cut.cloth_energy, rel=1e-6)


def test_a_piece_that_is_flat_needs_none():
    with pytest.raises(FlattenError, match="is flat enough") as raised:
        propose_darts(*half_cylinder())
    assert raised.value.code is ErrorCode.no_proposal


def test_progress_is_told_and_can_cancel():
    told = []
    propose_darts(*DOME, count=1, progress=lambda stage, fraction: told.append((stage, fraction)))
    assert {stage for stage, _ in told} == {"cuts"}
    fractions = [fraction for _, fraction in told]
    assert fractions == sorted(fractions) and fractions[0] >= 0 and fractions[-1] < 1
    with pytest.raises(FlattenError, match="Canceled") as raised:
        propose_darts(*DOME, progress=lambda *_: False)
    assert raised.value.code is ErrorCode.cancelled


def test_wrong_options_are_refused():
    for wish in ({"count": 0}, {"strain": -1.0}, {"longest": 0.0}, {"piece": 1}):
        with pytest.raises(FlattenError) as raised:
            propose_darts(*DOME, **wish)
        assert raised.value.code is ErrorCode.invalid_option


@pytest.mark.parametrize("propose", [propose_darts, propose_seams])
def test_no_cut_runs_along_an_edge_that_is_to_have_none(propose):
    barred = propose(*DOME, count=1)[0].edges
    taken = {frozenset(pair) for pair in barred.tolist()}
    for proposal in propose(*DOME, no_seam=barred[:, ::-1]):
        assert not taken & {frozenset(pair) for pair in proposal.edges.tolist()}
    with pytest.raises(FlattenError, match="with the pair 0, 9999: it must hold edges of the mesh") as raised:
        propose(*DOME, no_seam=[[0, 9999]])
    assert raised.value.code is ErrorCode.invalid_option


def test_a_plan_keeps_off_what_is_to_have_no_seam():
    barred = plan_cuts(*DOME, strain=0.0, most=1)[0].edges
    taken = {frozenset(pair) for pair in barred.tolist()}
    for cut in plan_cuts(*DOME, strain=0.0, most=2, no_seam=barred, longest=1.0):
        assert cut.length <= 1.0 and not taken & {frozenset(pair) for pair in cut.edges.tolist()}


def test_a_plan_ends_where_its_aim_is_met():
    before = propose_darts(*DOME, count=1)[0].strain_before
    first, *rest = plan_cuts(*DOME, strain=0.8 * before, most=3)
    assert first.strain_before == pytest.approx(before)
    for previous, cut in zip([first, *rest], rest, strict=False):
        assert cut.strain_before == pytest.approx(previous.strain, rel=1e-6)
        assert previous.strain > 0.8 * before


def test_a_plan_keeps_to_its_number_and_total_length():
    assert len(plan_cuts(*DOME, strain=0.0, most=2)) == 2
    cuts = plan_cuts(*DOME, strain=0.0, most=3, total_length=1.0)
    assert sum(cut.length for cut in cuts) <= 1
    told = []
    plan_cuts(*DOME, strain=0.0, most=2, progress=lambda _, fraction: told.append(fraction))
    assert told == sorted(told) and told[-1] > 0.5


def test_a_plan_of_seams_cuts_pieces_of_pieces():
    cuts = plan_cuts(*DOME, kind="seam", strain=0.0, most=2)
    edges = np.concatenate([cut.edges for cut in cuts])
    assert len(flatten(*DOME, seams=edges).pieces) == 3


def test_no_seams_are_an_empty_list_or_none():
    target = {"strain": 0.0, "most": 2}
    assert repr(plan_cuts(*DOME, seams=[], **target)) == repr(plan_cuts(*DOME, **target))


def test_a_plan_needs_a_kind_of_cut_and_a_piece_that_is_strained():
    with pytest.raises(FlattenError, match="it must be dart or seam"):
        plan_cuts(*DOME, kind="zip")
    with pytest.raises(FlattenError, match="option most is 0: it must be at least 1"):
        plan_cuts(*DOME, most=0)
    with pytest.raises(FlattenError, match="is accepted"):
        plan_cuts(*DOME, strain=1.0)
