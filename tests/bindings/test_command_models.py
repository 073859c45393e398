# SPDX-License-Identifier: GPL-3.0-or-later
"""Models are read from files in any encoding. Their materials have no effect."""

import numpy as np
import pytest
from commands import FOLDED
from wirewarp.command.model import read_model


@pytest.mark.parametrize(
    "head",
    [
        b"\xef\xbb\xbf",  # a byte order mark
        "# Größe: Ärmel\ng Rückenteil\n".encode("cp1252"),
        # In Shift-JIS, the last byte of this line is a backslash, which must not join the line and the next line.
        "# 前身頃の表\n".encode("shift-jis"),
        "# Größe 前身頃\nusemtl Stoff\n".encode(),
    ],
    ids=["byte order mark", "cp1252", "Shift-JIS", "UTF-8"],
)
def test_names_and_comments_may_be_in_any_encoding(tmp_path, head):
    (tmp_path / "a.obj").write_bytes(head + FOLDED.encode())
    (tmp_path / "b.obj").write_text(FOLDED)
    marked, plain = read_model(tmp_path / "a.obj"), read_model(tmp_path / "b.obj")
    assert np.array_equal(marked.vertices, plain.vertices) and np.array_equal(marked.faces, plain.faces)
    assert np.array_equal(marked.corner_uv, plain.corner_uv)


def test_materials_change_neither_numbers_nor_maps(tmp_path):
    first, second = FOLDED[: FOLDED.index("f ")], FOLDED[FOLDED.index("f ") :].splitlines()
    (tmp_path / "a.mtl").write_text("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n")
    # In the file, the first face has the second material, and does not use the first vertex.
    (tmp_path / "a.obj").write_text(f"mtllib a.mtl\n{first}usemtl red\n{second[1]}\nusemtl blue\n{second[0]}\n")
    (tmp_path / "b.obj").write_text(f"{first}{second[1]}\n{second[0]}\n")
    colored, plain = read_model(tmp_path / "a.obj"), read_model(tmp_path / "b.obj")
    assert plain.vertices.tolist() == [[float(x) for x in line.split()[1:]] for line in first.splitlines()[:6]]
    assert np.array_equal(colored.vertices, plain.vertices) and np.array_equal(colored.faces, plain.faces)
    assert np.array_equal(colored.corner_uv, plain.corner_uv)
