# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces of a fabric: the strain of threads, and lengths with built-in stretch."""

import math

import numpy as np
from surfaces import column_chain, spherical_patch
from wirewarp import Cloth, Options, Wire, flatten


def test_metrics_have_the_strain_of_threads_with_and_without_a_fabric():
    vertices, faces = spherical_patch()
    marked = [Wire(column_chain(8, 8, 4))]
    plain = flatten(vertices, faces, wires=marked).pieces[0].metrics
    woven = flatten(vertices, faces, wires=marked, options=Options(cloth="woven")).pieces[0].metrics
    assert math.isnan(plain.cloth_energy)
    assert woven.cloth_energy > 0
    for metrics in (plain, woven):
        for measured in (metrics.face_weft_strain, metrics.face_warp_strain, metrics.face_shear_angle):
            assert measured.shape == (len(faces),)
            assert np.isfinite(measured).all()
    assert np.abs(woven.face_shear_angle).max() > np.abs(plain.face_shear_angle).max()
    assert np.square(woven.face_weft_strain).sum() < np.square(plain.face_weft_strain).sum()


def test_seams_are_proposed_for_a_piece_that_only_the_stretch_makes_infeasible():
    """The stretch shortens the legs of a slim triangle to a fifth, but its seam only to three fifths. The seam joins
    the triangle to a square. It runs across the grain of one piece and along the grain of the other."""
    around = [(i / 4, 0, 0) for i in range(5)] + [(0.5, 0.08, 0)]
    vertices = [*around, *((i / 4, 0, -1) for i in range(5))]
    faces = [(i, i + 1, 5) for i in range(4)]
    faces += [face for i in range(4) for face in ((i, 6 + i, 7 + i), (i, 7 + i, i + 1))]
    seams = [(i, i + 1) for i in range(4)]
    fabric = {"orientation": "up", "up": (0.1, 1, 0)}
    stretched = Options(**fabric, cloth=Cloth(stretch=(4, 0)))
    plain = Options(**fabric, cloth=Cloth())
    assert all(piece.error is None for piece in flatten(vertices, faces, seams=seams, options=plain).pieces)
    error = flatten(vertices, faces, seams=seams, options=stretched).pieces[0].error
    assert error.arguments["reason"] == "stretch"
    assert "use less stretch, or mark a seam, such as along edge" in str(error)
    cut = flatten(vertices, faces, seams=[*seams, *error.proposed_seams], options=stretched)
    assert [piece.error for piece in cut.pieces] == [None, None, None]
