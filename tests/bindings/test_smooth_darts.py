# SPDX-License-Identifier: GPL-3.0-or-later
"""Darts as smooth lines across triangles: their figures are the figures of the mesh that is cut along them."""

import math
from itertools import pairwise

import numpy as np
import pytest
from samples import SAMPLES
from surfaces import column_chain, spherical_patch
from wirewarp import (
    Cloth,
    Options,
    SurfacePath,
    Wire,
    cut_mesh,
    flatten,
    plan_cuts,
    propose_darts,
    propose_seams,
)
from wirewarp.report.make import make_report

DOME = spherical_patch(8, 8)
MIDDLE = column_chain(8, 8, 4)[2:6]


def flat(paths: list[SurfacePath], **more):
    """Flatten the dome with these cuts; return its report and the cut mesh."""
    vertices, faces, edges, sources = cut_mesh(*DOME, paths)
    result = flatten(vertices, faces, seams=edges, **more)
    options = more.get("options")
    report = make_report(result, vertices, faces, wires=more.get("wires", ()), cloth=options.cloth if options else None)
    return result, report, edges, sources


def turns(path: SurfacePath) -> np.ndarray:
    """Return the turns of a line at its inner points on the surface, radians, without the curvature of the sphere."""
    vertices, faces = DOME
    places = np.einsum("ij,ijk->ik", path.coordinates, vertices[faces[path.faces]])
    normals = places / np.linalg.norm(places, axis=1)[:, None]  # normals of the sphere
    steps = np.diff(places, axis=0)
    before = steps[:-1] - (steps[:-1] * normals[1:-1]).sum(axis=1)[:, None] * normals[1:-1]
    after = steps[1:] - (steps[1:] * normals[1:-1]).sum(axis=1)[:, None] * normals[1:-1]
    cosine = (before * after).sum(axis=1) / (np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1))
    return np.arccos(np.clip(cosine, -1, 1))


@pytest.mark.parametrize(
    ("wires", "options"),
    [
        ([], None),
        ([Wire(MIDDLE)], None),
        ([Wire(MIDDLE, ease=0.02)], Options(cloth="woven")),
        ([], Options(cloth=Cloth(stretch=(0.1, 0.05)))),
        ([], Options(thickness=0.05)),
    ],
)
def test_the_figures_are_those_of_the_cut_mesh(wires, options):
    mesh = {"wires": wires, "options": options}
    before = flat([], **mesh)[1].pieces[0].needed
    proposals = propose_darts(*DOME, **mesh, count=2, smooth=True)
    assert any(len(proposal.edges) == 0 for proposal in proposals), "none crosses a triangle"
    for proposal in proposals:
        result, report, edges, sources = flat(proposal.paths, **mesh)
        (piece,), (reported,) = result.pieces, report.pieces
        assert piece.error is None
        metrics = piece.metrics
        energy = metrics.cloth_energy if options and options.cloth else metrics.arap_energy
        assert proposal.energy == pytest.approx(energy, rel=1e-6)
        assert proposal.strain == pytest.approx(reported.needed, abs=1e-6)
        assert proposal.strain_before == pytest.approx(before, abs=1e-6)
        assert min(proposal.strain, proposal.strain_with_twin or math.inf) < before
        if not (options and options.thickness):  # lengths are measured in the middle of the material
            places = cut_mesh(*DOME, proposal.paths)[0][edges]
            assert proposal.length == pytest.approx(np.linalg.norm(np.diff(places, axis=1), axis=2).sum(), rel=1e-12)
        wired = {tuple(sorted(pair)) for wire in wires for pair in pairwise(wire.vertices.tolist())}
        assert wired.isdisjoint(tuple(line[[0, -1]].tolist()) for line in sources.divided_edges)
        (dart,) = result.seams
        assert dart.pieces == (0, 0) and dart.mismatch <= 1e-9 * dart.length_3d
        if not len(proposal.edges):
            assert turns(proposal.paths[0]).max(initial=0) < math.radians(30)


def test_mirror_images_have_the_figures_of_both():
    ball = SAMPLES["Ball of six gores"]
    vertices, faces = ball.vertices, ball.triangles()
    wires = [Wire(wire.vertices, wire.tolerance) for wire in ball.wires]
    proposals = propose_darts(vertices, faces, seams=ball.seams, wires=wires, count=2, smooth=True)
    pairs = [proposal for proposal in proposals if proposal.strain_with_twin is not None]
    assert pairs, "its gores are symmetric"
    for proposal in pairs[:2]:
        twin = proposals[proposal.twin]
        assert (twin.strain, twin.energy) == pytest.approx((proposal.strain, proposal.energy), rel=1e-6)
        cut = cut_mesh(vertices, faces, [*proposal.paths, *twin.paths])
        result = flatten(cut[0], cut[1], seams=np.concatenate([ball.seams, cut[2]]), wires=wires)
        report = make_report(result, cut[0], cut[1], wires=wires)
        assert proposal.strain_with_twin == pytest.approx(report.pieces[proposal.piece].needed, abs=1e-6)
        assert proposal.energy_with_twin == pytest.approx(result.pieces[proposal.piece].metrics.arap_energy, rel=1e-6)


def test_darts_do_not_depend_on_the_place_of_the_model():
    rotation, _ = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))
    rotation *= np.linalg.det(rotation)
    vertices, faces = spherical_patch(12, 12)
    first = propose_darts(vertices, faces, count=1, smooth=True)[0]
    turned = propose_darts(vertices @ rotation.T + 5, faces, count=1, smooth=True)[0]
    assert turned.strain == pytest.approx(first.strain, rel=1e-6)
    assert turned.length == pytest.approx(first.length, rel=1e-6)


@pytest.mark.parametrize("propose", [propose_darts, propose_seams, plan_cuts])
def test_cuts_along_edges_have_paths_that_change_no_mesh(propose):
    vertices, faces = DOME
    proposal = propose(vertices, faces)[0]
    new_vertices, new_faces, edges, _ = cut_mesh(vertices, faces, proposal.paths)
    assert (new_vertices == vertices).all() and (new_faces == faces).all()
    assert (edges == proposal.edges).all()


@pytest.mark.parametrize("name", ["no_seam", "no_crossing"])
def test_forbidden_edges_are_not_crossed(name):
    vertices, faces = DOME
    first = propose_darts(vertices, faces, count=1, smooth=True)[0]
    crossed = cut_mesh(vertices, faces, first.paths)[3].divided_edges
    barred = np.array([line[[0, -1]] for line in crossed])
    for proposal in propose_darts(vertices, faces, smooth=True, **{name: barred}):
        divided = {tuple(line[[0, -1]].tolist()) for line in cut_mesh(vertices, faces, proposal.paths)[3].divided_edges}
        assert divided.isdisjoint(map(tuple, barred.tolist()))


def test_darts_along_edges_may_run_where_no_smooth_dart_may_cross():
    vertices, faces = DOME
    every = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    along = propose_darts(vertices, faces, count=9)
    best, *others = propose_darts(vertices, faces, count=9, smooth=True, no_crossing=every)

    def left(dart):
        return dart.strain if dart.strain_with_twin is None else dart.strain_with_twin

    assert len(best.edges) and left(best) == pytest.approx(min(map(left, along)), rel=1e-9)
    assert len(others) == (0 if best.twin is None else 1)
