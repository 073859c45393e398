# SPDX-License-Identifier: GPL-3.0-or-later
"""wirewarp.pattern works inside Blender: what it needs beside Blender's own Python is in the zip."""

import sys
from pathlib import Path

import numpy as np


def test_a_square_becomes_a_pdf(addon, tmp_path):
    square = np.array([[0, 0, 0], [0.2, 0, 0], [0.2, 0.2, 0], [0, 0.2, 0]])
    result = addon.core.library().flatten(square, np.array([[0, 1, 2], [0, 2, 3]]))
    written = addon.core.pattern.Pattern.from_result(result, allowance=10.0).write(tmp_path / "square.pdf")
    assert str(written) == "1 piece on 3 sheets, read again: 0.00 mm off"
    assert (tmp_path / "square.pdf").read_bytes().startswith(b"%PDF-")


def test_what_it_needs_comes_with_the_add_on_and_leaves_the_path_alone(addon):
    inside = Path(addon.core.__file__).parent / "_core"
    if inside.is_dir():
        assert {path.name for path in (inside / "libraries").iterdir()} == {"pyclipper", "pydyf", "uharfbuzz"}
    assert not [folder for folder in sys.path if Path(folder).is_relative_to(inside)]
