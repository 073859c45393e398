# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles become faces and wire numbers become names in the library's sentences."""

import numpy as np
import pytest

TWO_TRIANGLES_A_FACE = np.arange(40) // 2


@pytest.mark.parametrize(
    ("sentence", "faces", "expected"),
    [
        (
            "There is no area in faces 6 and 9: dissolve them.",
            [3, 4],
            "There is no area in faces 3 and 4: dissolve them.",
        ),
        ("There is no area in faces 6 and 7.", [3], "There is no area in face 3."),
        ("At faces 0, 1, 2, 3, 4 and 3 more.", [0, 1, 2, 9], "At faces 0, 1, 2 and 1 more."),
        ("At faces 0, 2, 4, 6, 8 and 1 more.", [0, 1, 2, 3, 4], "At faces 0, 1, 2, 3 and 4."),
        (
            "The outline and wire 1 around face 30 of 3 faces.",
            [],
            'The outline and wire "Hip" around face 15 of 3 faces.',
        ),
        ("Wire 0 (Bust) ends at vertex 7.", [], 'Wire "Bust" ends at vertex 7.'),
        ("Wire 2 (Wire 1) ends at vertex 7.", [], 'Wire "Wire 1" ends at vertex 7.'),
        ("Wires: wires 0 and 1 at vertex 7.", [], 'Wires: wires "Bust" and "Hip" at vertex 7.'),
    ],
)
def test_names(addon, sentence, faces, expected):
    assert (
        addon.solve.sentences.name_elements(sentence, TWO_TRIANGLES_A_FACE, faces, ["Bust", "Hip", "Wire 1"])
        == expected
    )


@pytest.mark.parametrize(
    ("sentence", "counts", "expected"),
    [
        ("A closed surface (12 faces): cut it.", [(12, 6), (0, 0)], "A closed surface (6 faces): cut it."),
        ("A closed surface (12 triangles).", [(12, 6), (0, 0)], "A closed surface (6 faces)."),
        ("It overlaps itself at 138 faces.", [(900, 450), (3, 2), (138, 80)], "It overlaps itself at 80 faces."),
        ("It has 3 flipped faces and more.", [(900, 450), (3, 1)], "It has 1 flipped face and more."),
        ("Could be two things: 3 faces.", [(3, 1), (3, 2)], "Could be two things: 3 triangles."),
        ("Of an unknown set: 3 faces.", [], "Of an unknown set: 3 triangles."),
        ("At faces 3 and 4: three faces or more meet.", [(4, 2)], "At faces 3 and 4: three faces or more meet."),
    ],
)
def test_counts(addon, sentence, counts, expected):
    assert addon.solve.sentences.count_faces(sentence, counts) == expected


@pytest.mark.parametrize(
    ("sentence", "expected"),
    [
        (
            "The piece around face 0 (24 faces) is a tube: mark a seam, such as along edge 46-47; its outlines, 0.3134 "
            "long at vertex 3 and 1.2e-05 long at vertex 0, can hold no more than 6.23% of its area in the plane (a "
            "distortion of at least 0.875).",
            "The piece is a tube: mark a seam, such as the proposed one; its outlines, 313 mm and 0.012 mm long, "
            "are too short to lie around it.",
        ),
        (
            "mark a seam; its outline, 0.5 long at vertex 3, can hold no more than 6.23% of its area in the plane.",
            "mark a seam; its outline, 500 mm long, is too short to lie around it.",
        ),
        ('The wire "Hip 3 long" is not valid.', 'The wire "Hip 3 long" is not valid.'),
        ("Wire 4 of the piece around face 7 is as long as its outline.", None),
        ("The outline of the piece around face 7 cannot keep", "The outline of the piece cannot keep"),
        ("Its outline, 12000 units long at vertex 1,", "Its outline, 12000000 mm long,"),
    ],
)
def test_sentences_have_units(addon, sentence, expected):
    units = addon.words.LengthText("mm", 1000.0)
    expected = expected or "Wire 4 of the piece is as long as its outline."
    assert addon.solve.sentences.plain_sentence(sentence, units) == expected


@pytest.mark.parametrize(
    ("sentence", "expected"),
    [
        ("There is no area in face 0: dissolve it.", "There is no area in one face: dissolve it."),
        ("Turned over at faces 10, 11 and 12, and more.", "Turned over at 3 faces, and more."),
        ("Vertices 1, 2, 3, 4, 5 and 12 more are far away.", "17 vertices are far away."),
        ("The length of edges 3-7 and 7-9 (the first is short)", "The length of 2 edges (the first is short)"),
        ("mark a seam such as edges 1-2, 2-3 and 9 more.", "mark a seam such as the proposed one."),
        ('The wire "Edge 4" ends at vertex 7.', 'The wire "Edge 4" ends at one vertex.'),
        ("It overlaps itself at 2 faces (of 64 faces).", "It overlaps itself at 2 faces (of 64 faces)."),
    ],
)
def test_sentences_count_what_a_button_selects(addon, sentence, expected):
    units = addon.words.LengthText("mm", 1000.0)
    assert addon.solve.sentences.plain_sentence(sentence, units) == expected
