# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces whose faces are not joined where they meet: told, for the pieces would be cut apart there."""

import bmesh
import bpy
import pytest
from surfaces import bump, flatten, grid, on_line, select_edges


def notes_of(addon, source):
    return [note["text"] for note in addon.report_store.last_report(source)["notes"]]


def split(source, line):
    """Along a line, each side with vertices of its own."""
    select_edges(source, line)
    bpy.ops.mesh.edge_split()
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize(
    ("line", "count"),
    [
        (on_line(0, 0.0), 16),  # from edge to edge: two pieces
        (lambda a, b: on_line(0, 0.0)(a, b) and max(a.y, b.y) < 0.1, 8),  # a slit of four edges
    ],
)
def test_edges_that_lie_on_each_other_are_told_until_they_are_merged(addon, line, count):
    source = grid("Bump", bump)
    flatten(source)
    assert notes_of(addon, source) == []
    split(source, line)
    flatten(source)
    (note,) = notes_of(addon, source)
    assert note.startswith(f"{count} edges of outlines lie on others without being joined to them.")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.remove_doubles()
    bpy.ops.object.mode_set(mode="OBJECT")
    flatten(source)
    assert notes_of(addon, source) == []


def test_seams_and_panels_that_stand_apart_are_no_tears(addon):
    source = grid("Bump", bump)
    split(source, on_line(0, 0.0))
    bpy.ops.object.mode_set(mode="EDIT")
    edit = bmesh.from_edit_mesh(source.data)
    for face in edit.faces:
        if face.calc_center_median().x > 0:
            for vertex in face.verts:
                vertex.tag = True
    for vertex in edit.verts:
        vertex.co.x += 1e-3 if vertex.tag else 0
    bmesh.update_edit_mesh(source.data)
    bpy.ops.object.mode_set(mode="OBJECT")
    flatten(source)
    assert notes_of(addon, source) == []


def test_a_piece_that_fails_may_do_so_for_its_tears():
    source = grid("Bump", bump)
    split(source, on_line(0, 0.0))
    source.data.polygons[0].flip()
    with pytest.raises(RuntimeError, match="look to opposite sides(.|\\n)*16 edges of outlines lie on others without"):
        flatten(source)
