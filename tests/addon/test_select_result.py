# SPDX-License-Identifier: GPL-3.0-or-later
"""Buttons select the edges or faces of an entry of the report."""

from functools import partial

import bpy
import numpy as np
import pytest
from flattening import edge_lengths, edge_vertices, fails
from surfaces import bump, flat_of, grid, mark, on_line, read, select_only

pytestmark = pytest.mark.api

SEAM = on_line(0, 0.0)
SELECT = bpy.ops.mesh.wirewarp_select_result


def selected(target, elements):
    assert (bpy.context.active_object, target.mode) == (target, "EDIT")
    bpy.ops.object.mode_set(mode="OBJECT")
    return np.flatnonzero(read(getattr(target.data, elements), "select", bool))


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_a_seam_is_selected_on_the_model_and_both_its_sides_on_the_flat_pieces(source, mode):
    SELECT(what="SEAM", index=0)
    assert np.array_equal(selected(source, "edges"), np.flatnonzero(read(source.data.edges, "use_seam", bool)))
    flat = flat_of(source)
    select_only(flat)
    bpy.ops.object.mode_set(mode=mode)
    SELECT(what="SEAM", index=0)
    edges = selected(flat, "edges")
    assert len(edges) == 16
    sources = read(flat.data.attributes["source_vertex"].data, "value", np.int32)[edge_vertices(flat.data)[edges]]
    assert all(SEAM(a, b) for a, b in read(source.data.vertices, "co", np.float32, 3)[sources])


def test_a_piece_is_selected_on_the_model_and_among_the_flat_pieces(source):
    flat, found = flat_of(source), []
    pieces = read(flat.data.attributes["piece"].data, "value", np.int32)
    for index in (0, 1):
        select_only(source)
        SELECT(what="PIECE", index=index)
        found.append(selected(source, "polygons"))
        select_only(flat)
        SELECT(what="PIECE", index=index)
        assert np.array_equal(selected(flat, "polygons"), np.flatnonzero(pieces == index))
    assert [len(faces) for faces in found] == [32, 32] and sorted(np.concatenate(found)) == list(range(64))


def test_places_that_cannot_be_shown_do_not_change_the_view(source, addon):
    flat, other = flat_of(source), grid("Other", bump)
    select_only(source, other)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.data.objects.remove(flat)
    fails(SELECT, "has no flat pieces", what="PIECE", index=0)
    select = partial(addon.blender.selection.select_elements, bpy.context)
    with pytest.raises(addon.issues.ObjectError, match="has changed"):
        select(source, addon.core.Elements(faces=[64]))
    with pytest.raises(addon.issues.ObjectError, match="not in this view layer"):
        select(bpy.data.objects.new("Nowhere", other.data), addon.core.Elements(faces=[0]))
    assert (source.mode, other.mode) == ("EDIT", "EDIT")
    assert (bpy.context.active_object, set(bpy.context.selected_objects)) == (source, {source, other})


def test_missing_places_are_reported(source):
    fails(SELECT, "The report no longer has this entry. Flatten again", what="SEAM", index=1)
    fails(SELECT, "The report no longer has this entry", what="OUTLINE", index=2)
    bpy.data.objects.remove(flat_of(source))
    fails(SELECT, '"Bump" has no flat pieces. Flatten it again', what="PIECE", index=0)
    grid("Other", bump)
    fails(SELECT, '"Other" has not been flattened yet. Press Flatten first', what="PIECE", index=0)


def test_a_changed_model_is_reported(source):
    source.data.vertices.add(1)
    source.data.update()
    fails(SELECT, '"Bump" has changed since it was flattened', what="SEAM", index=0)


def test_with_modifiers_the_flat_pieces_are_shown():
    target = grid("Other", bump, seam=SEAM)
    target.modifiers.new("Finer", "SUBSURF").levels = 1
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    SELECT(what="SEAM", index=0)
    assert len(selected(flat_of(target), "edges")) == 32  # 16 edges on each side, because the modifier halves edges


@pytest.fixture
def wired(source):
    mark(source, on_line(1, 0.0), kind="ELASTIC", tolerance=0.001)
    bpy.ops.object.wirewarp_flatten()
    return source


def places(target, edges):
    """Return the ends (k,2,3) of the edges."""
    return read(target.data.vertices, "co", np.float32, 3)[edge_vertices(target.data)[edges]]


@pytest.mark.parametrize("what", ["WIRE", "HINT"])
def test_a_wire_is_selected_on_the_model_and_on_the_flat_pieces(wired, what):
    SELECT(what=what, index=0)
    edges = selected(wired, "edges")
    assert len(edges) == 8 and (places(wired, edges)[..., 1] == 0).all()
    flat = flat_of(wired)
    select_only(flat)
    SELECT(what=what, index=0)
    edges = selected(flat, "edges")  # also leaves Edit Mode, in which attributes cannot be read
    ids = read(flat.data.attributes["wirewarp_wire"].data, "value", np.int32)
    assert np.array_equal(edges, np.flatnonzero(ids))


def test_an_outline_is_one_section_of_one_piece(source, addon):
    report = addon.state.reports.last_report(source)
    for index, (_, _, chain) in enumerate(addon.core.open_edges(report)):
        select_only(source)
        SELECT(what="OUTLINE", index=index)
        edges = selected(source, "edges")
        assert len(edges) == 16  # half of the square's outline
        assert edge_lengths(source)[edges].sum() == pytest.approx(chain.length_3d, rel=1e-6)
        side = np.sign(places(source, edges)[..., 0].mean())
        assert (side * places(source, edges)[..., 0] >= 0).all()
        select_only(flat_of(source))
        SELECT(what="OUTLINE", index=index)
        edges = selected(flat_of(source), "edges")
        assert edge_lengths(flat_of(source))[edges].sum() == pytest.approx(chain.length_2d[0], rel=1e-6)


@pytest.mark.parametrize("what", ["STRETCH", "EASE"])
def test_the_most_strained_place_is_selected(source, addon, what):
    piece = addon.state.reports.last_report(source).pieces[1]
    SELECT(what=what, index=1)
    faces = selected(source, "polygons")
    assert faces.tolist() == getattr(piece, f"{what.lower()}_faces") and 0 < len(faces) < 32
    select_only(flat_of(source))
    SELECT(what=what, index=1)
    on_flat = selected(flat_of(source), "polygons")
    sources = read(flat_of(source).data.attributes["source_face"].data, "value", np.int32)
    assert sorted(sources[on_flat]) == sorted(faces)


def test_one_of_several_issues_is_selected(model):
    select_only(flat_of(model))  # The flat pieces do not contain the cube, so it is selected on the model.
    SELECT(what="ISSUE", index=0)
    assert len(selected(model, "polygons")) == 6
    model["wirewarp_report"] = "{}"  # as if from another version of WireWarp
    SELECT(what="ISSUE", index=0)
    assert len(selected(model, "edges")) == 0


@pytest.mark.parametrize("name", ["select_result", "take_proposal", "select_issues"])
def test_buttons_say_what_they_do(addon, name):
    properties = bpy.context.window_manager.operator_properties_last(f"mesh.wirewarp_{name}")
    operator = getattr(bpy.types, f"MESH_OT_wirewarp_{name}")
    if name == "select_issues":
        assert operator.description(bpy.context, properties) == ""  # so that Blender shows the operator's docstring
        return
    said = []
    for item in properties.rna_type.properties["what"].enum_items:
        properties.what = item.identifier
        said.append(operator.description(bpy.context, properties))
    assert len(set(said)) == len(said) and all(said)
