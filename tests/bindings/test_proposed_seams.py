# SPDX-License-Identifier: GPL-3.0-or-later
"""Real garment parts that cannot lie flat, and the seams proposed for them. Skipped where they are not at hand."""

import numpy as np
import pytest
from test_reference_figures import PANELS
from wirewarp import ErrorCode, flatten

TUBES = ["tee_sleeve_annulus", "wetsuit_leg_annulus", "jeans_leg_annulus", "skirt_whole_annulus", "jeans_whole_3loops"]
OPEN = ["pillow_front", "hat_half", "shoe_upper_annulus", "shirt_collar", "wetsuit_bust_side", "sofa_seat_face"]

pytestmark = pytest.mark.skipif(not PANELS.exists(), reason="the garment parts are not at hand")


def read_mesh(name: str) -> tuple[np.ndarray, np.ndarray]:
    lines = [line.split() for line in (PANELS / f"{name}.obj").read_text().splitlines()]
    vertices = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]]
    faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[:1] == ["f"]]
    triangles = [(face[0], b, c) for face in faces for b, c in zip(face[1:], face[2:], strict=False)]
    return np.array(vertices), np.array(triangles)


@pytest.mark.parametrize("name", TUBES)
def test_a_tube_is_refused_and_lies_flat_along_its_proposed_seams(name: str):
    vertices, faces = read_mesh(name)
    (piece,) = flatten(vertices, faces).pieces
    assert piece.error.code is ErrorCode.boundary_too_short
    assert np.isnan(piece.vertices).all()
    assert len(piece.error.proposed_seams) > 0
    (opened,) = flatten(vertices, faces, seams=piece.error.proposed_seams).pieces
    assert len(opened.boundaries) > 0
    assert opened.error is None or opened.error.has_layout


@pytest.mark.parametrize("name", OPEN)
def test_a_part_that_can_be_cut_is_not_refused(name: str):
    (piece,) = flatten(*read_mesh(name)).pieces
    assert piece.error is None or piece.error.code is not ErrorCode.boundary_too_short
