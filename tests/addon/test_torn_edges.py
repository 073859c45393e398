# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces whose faces are not joined where they meet: told, for the pieces would be cut apart there."""

import bmesh
import bpy
import pytest
from surfaces import bump, flatten, grid, on_line, select_edges


def hints_of(addon, source):
    return [hint for hint in addon.state.reports.last_report(source).hints if hint.code == "torn"]


def selected_ends(target):
    """Of the edges that are selected, both ends (2,) as vectors."""
    bpy.ops.object.mode_set(mode="OBJECT")
    vertices = target.data.vertices
    return [[vertices[end].co for end in edge.vertices] for edge in target.data.edges if edge.select]


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
    assert hints_of(addon, source) == []
    split(source, line)
    flatten(source)
    (hint,) = hints_of(addon, source)
    assert hint.short == f"{count} edges"
    assert addon.state.reports.last_report(source).notes == []  # for it may be meant
    index = addon.state.reports.last_report(source).hints.index(hint)
    bpy.ops.mesh.wirewarp_select_result(what="HINT", index=index)
    assert len(selected_ends(source)) == count
    assert all(line(*ends) for ends in selected_ends(source))
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.remove_doubles()
    bpy.ops.object.mode_set(mode="OBJECT")
    flatten(source)
    assert hints_of(addon, source) == []


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
    assert hints_of(addon, source) == []


def test_a_piece_that_fails_may_do_so_for_its_tears():
    source = grid("Bump", bump)
    split(source, on_line(0, 0.0))
    source.data.polygons[0].flip()
    with pytest.raises(RuntimeError, match="look to opposite sides(.|\\n)*Some edges overlap but are not joined"):
        flatten(source)
