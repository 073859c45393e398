# SPDX-License-Identifier: GPL-3.0-or-later
"""Real garment parts without a flat shape, and the seams proposed for them. Skipped if they are not available."""

import numpy as np
import pytest
from test_reference_figures import PANELS, read_panel
from wirewarp import ErrorCode, FlattenError, flatten

TUBES = ["tee_sleeve_annulus", "wetsuit_leg_annulus", "jeans_leg_annulus", "skirt_whole_annulus"]
WHOLE = ["jeans_whole_3loops", "tshirt_whole_4loops", "wetsuit_upper_body_4loops"]
OPEN = ["pillow_front", "hat_half", "shoe_upper_annulus", "shirt_collar", "wetsuit_bust_side", "sofa_seat_face"]

pytestmark = pytest.mark.skipif(not PANELS.exists(), reason="the garment parts are not at hand")


def refused(vertices: np.ndarray, faces: np.ndarray) -> FlattenError:
    (piece,) = flatten(vertices, faces).pieces
    assert piece.error.code is ErrorCode.boundary_too_short
    assert np.isnan(piece.vertices).all()
    return piece.error


@pytest.mark.parametrize("name", TUBES)
def test_a_tube_is_refused_and_is_flat_with_its_proposed_seams(name: str):
    vertices, faces, _ = read_panel(name)
    error = refused(vertices, faces)
    assert len(error.vertices) == 2  # one vertex for each end
    (opened,) = flatten(vertices, faces, seams=error.proposed_seams).pieces
    assert opened.error is None


@pytest.mark.parametrize("name", WHOLE)
def test_a_whole_garment_is_flat_after_one_proposal(name: str):
    vertices, faces, _ = read_panel(name)
    result = flatten(vertices, faces, seams=refused(vertices, faces).proposed_seams)
    assert [piece.error for piece in result.pieces if piece.error] == []


@pytest.mark.parametrize("name", OPEN)
def test_a_part_that_can_be_cut_is_not_refused(name: str):
    (piece,) = flatten(*read_panel(name)[:2]).pieces
    assert piece.error is None or piece.error.code is not ErrorCode.boundary_too_short
