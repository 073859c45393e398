# SPDX-License-Identifier: GPL-3.0-or-later
"""The overlay has correct lines, names and surfaces on models and on flat pieces. These tests do not draw them."""

import math

import bmesh
import bpy
import numpy as np
import pytest
from everything import sidebar
from flattening import flatten_fails, flattened, notify, raise_vertex, report_after
from mathutils import Vector
from surfaces import bump, flat_of, grid, make_object, mark, mark_seam, on_line, read, select_edges, select_only, tube
from view_context import look, marked_lines, view_context

pytestmark = pytest.mark.api

SEAM, RIGID, ELASTIC, FREE = on_line(0, 0.0), on_line(1, 0.0), on_line(1, 0.5), on_line(1, -0.5)


@pytest.fixture
def source():
    """Return a flattened, mirrored model of two pieces with one wire of each kind."""
    target = grid("Bump", bump)
    target.scale = (-1, 1, 2)
    mark_seam(target, SEAM)
    mark(target, RIGID)
    mark(target, ELASTIC, kind="ELASTIC", tolerance=0.05)
    mark(target, FREE, kind="SUPER_ELASTIC")
    target.data.wirewarp_names[0].name = "Waist"
    bpy.ops.object.wirewarp_flatten()
    return target


def edges_of(lines):
    return {kind: len(places) // 2 for kind, places in lines.places.items()}


def test_lines_of_each_kind_lie_on_their_edges_on_the_model_and_on_the_pieces(addon, source):
    wires = {"rigid": 8, "elastic": 8, "free": 8}
    assert edges_of(marked_lines(addon, source)) == {"seam": 8, "outline": 32, **wires}
    on_pieces = {"seam": 16, "outline": 32, "default grain": 2 * 3, **wires}  # two arrows of three edges
    assert edges_of(marked_lines(addon, flat_of(source))) == on_pieces
    places = marked_lines(addon, source).places
    assert np.all(np.abs(places["seam"][:, 0]) < 1e-6)
    for kind, y in (("rigid", 0.0), ("elastic", 0.5), ("free", -0.5)):
        assert places[kind][:, 1] == pytest.approx(np.full(16, y), abs=1e-6)
        ends = places[kind].reshape(-1, 2, 3)
        assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) == pytest.approx(np.full(8, 0.25), abs=0.1)


@pytest.mark.parametrize("flat", [False, True])
def test_edit_mode_shows_the_same_lines_and_names(addon, source, flat):
    target = flat_of(source) if flat else source
    before = marked_lines(addon, target)
    select_only(target)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    during = marked_lines(addon, target)
    before.places.pop("default grain", None)  # Arrows and names of pieces are drawn in Object Mode only.
    assert during.places.keys() == before.places.keys()
    for kind, places in before.places.items():
        assert np.array_equal(during.places[kind], places)
    texts = [name.texts[-1] for name in before.names if not name.texts[0].startswith("Top")]
    assert sorted(name.texts[-1] for name in during.names) == sorted(texts)


def test_an_object_with_the_same_mesh_shows_its_lines_in_edit_mode(addon, source):
    before = marked_lines(addon, source)
    select_only(source)
    bpy.ops.object.duplicate(linked=True)
    other = bpy.context.active_object
    select_only(source)
    bpy.ops.object.mode_set(mode="EDIT")
    assert (other.mode, source.mode) == ("OBJECT", "EDIT")
    assert edges_of(marked_lines(addon, other)).items() >= edges_of(before).items()
    shown = {drawing.target: drawing for drawing in addon.overlay.shown.drawings(view_context())}
    assert (shown[other].failures, shown[other].surface) == (None, None)


def test_names_are_those_of_the_report_and_are_on_their_lines(addon, source):
    on_model = [name.texts[-1] for name in marked_lines(addon, source).names]
    assert sorted(on_model) == ["Seam 1", "Waist", "Wire 2 ±5%", "Wire 3"]
    on_pieces = [name.texts[-1] for name in marked_lines(addon, flat_of(source)).names]
    assert sorted(on_pieces) == sorted(2 * on_model + ["Top Left", "Top Right"])
    lines = marked_lines(addon, source)
    name = next(name for name in lines.names if name.texts == ("Waist",))
    for place in name.places:
        assert np.linalg.norm(lines.places["rigid"] - place, axis=1).min() < 0.25
    assert abs(name.places[0][0]) < 0.3 and min(name.places[:, 0]) < -0.5 < 0.5 < max(name.places[:, 0])
    assert name.normals[0][2] > 0.9


def test_edges_with_their_own_allowance_are_seen_on_the_model(addon, source):
    assert "allowance" not in marked_lines(addon, source).places
    select_edges(source, SEAM)
    bpy.ops.mesh.wirewarp_allowance(kind="HEM")
    lines = marked_lines(addon, source)
    assert np.array_equal(lines.places["allowance"], lines.places["seam"])
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.wirewarp_flatten()
    assert "allowance" not in marked_lines(addon, flat_of(source)).places  # Flat pieces have cutting lines instead.
    assert addon.overlay.lines.STYLES["allowance"].width > 1.5 * addon.overlay.lines.STYLES["seam"].width


def test_selected_edges_are_seen_on_their_lines(addon, source):
    select_edges(source, on_line(1, 0.0))
    lines = marked_lines(addon, source)
    assert len(lines.places["selected"]) == len(lines.places["rigid"])
    assert list(addon.overlay.lines.STYLES)[-1] == "selected"  # so that it is drawn last, over wider lines
    width_of = {kind: style.width for kind, style in addon.overlay.lines.STYLES.items()}
    assert all(width_of["selected"] < 0.6 * width_of[kind] for kind in ("outline", "seam", "free", "elastic", "rigid"))
    bpy.ops.mesh.select_all(action="DESELECT")
    assert "selected" not in marked_lines(addon, source).places
    bpy.ops.object.mode_set(mode="OBJECT")
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    bpy.context.view_layer.update()
    assert edges_of(marked_lines(addon, source))["rigid"] == 16  # The visible modifier halves edges.


def test_seams_of_a_changed_model_keep_their_names_without_the_joined_pieces(addon, source):
    raise_vertex(source)
    for mode in ("OBJECT", "EDIT"):
        select_only(source)
        bpy.ops.object.mode_set(mode=mode)
        assert ("Seam 1",) in [name.texts for name in marked_lines(addon, source).names]
    bpy.ops.object.mode_set(mode="OBJECT")
    source.data.edges.foreach_set("use_seam", np.zeros(len(source.data.edges), dtype=bool))
    assert ("Seam 1",) not in [name.texts for name in marked_lines(addon, source).names]
    assert "Seam 1" in [name.texts[-1] for name in marked_lines(addon, flat_of(source)).names]


def surface_of(addon, target, color_map):
    return addon.overlay.objects.colored_surface(target, bpy.context.evaluated_depsgraph_get(), color_map)


def colors_by_face(mesh, surface):
    mesh.calc_loop_triangles()
    faces = read(mesh.loop_triangles, "polygon_index", np.int32)
    return dict(zip(faces.tolist(), surface.colors.reshape(-1, 3, 4)[:, 0].tolist(), strict=True))


def test_a_face_has_the_color_of_its_flat_face(addon, source):
    flat = flat_of(source)
    color_map = addon.solve.maps.STRETCH
    on_model = colors_by_face(source.data, surface_of(addon, source, color_map))
    on_pieces = colors_by_face(flat.data, surface_of(addon, flat, color_map))
    sources = read(flat.data.attributes["source_face"].data, "value", np.int32).tolist()
    assert len(set(map(tuple, on_model.values()))) > 10 and len(on_pieces) == len(on_model)
    for face, color in on_pieces.items():
        assert color == pytest.approx(on_model[sources[face]], abs=1e-6)
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    bpy.context.view_layer.update()
    assert surface_of(addon, source, color_map) is None  # The pieces were made without the modifier.
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert len(surface_of(addon, source, color_map).places) == 3 * 2 * 4 * 64
    source.modifiers.clear()
    bpy.context.view_layer.update()
    assert surface_of(addon, source, color_map) is None  # The pieces were made with the modifier.
    assert surface_of(addon, flat, color_map) is not None


def test_every_map_can_be_shown(addon, source):
    items = bpy.context.scene.wirewarp.bl_rna.properties["shown_map"].enum_items
    wanted = {item.identifier for item in items if item.identifier != "NONE"}
    assert wanted == {each.attribute.upper() for each in addon.solve.maps.COLOR_MAPS}
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN")
    for color_map in addon.solve.maps.COLOR_MAPS:
        assert surface_of(addon, source, color_map).colors.shape == (3 * 128, 4)


def test_only_models_and_pieces_are_drawn_with_the_chosen_layers(addon, source):
    grid("Bystander", bump, seam=SEAM)
    drawings, settings = addon.overlay.shown.drawings, bpy.context.scene.wirewarp
    shown = list(drawings(view_context()))
    assert {drawing.target for drawing in shown} == {source, flat_of(source)}
    assert all(drawing.lines and drawing.surface is None for drawing in shown)
    settings.shown_map = "ASPECT_RATIO_COLOR"
    assert all(drawing.surface for drawing in drawings(view_context()))
    settings.show_lines = False
    assert all(drawing.surface and not drawing.lines for drawing in drawings(view_context()))
    assert list(drawings(view_context(show_overlays=False))) == []
    settings.shown_map = "NONE"
    assert list(drawings(view_context())) == []


@pytest.mark.parametrize("perspective", [True, False])
def test_names_are_written_where_their_lines_are_seen(addon, source, perspective):
    source.location, source.scale = (10, 0, 0), (1, 1, 1)
    bpy.context.view_layer.update()
    above = look(addon, source, (10, 0, 4.4), (10, 0, 0), perspective)
    assert above["Waist"].points[0] == pytest.approx([400, 300], abs=15)
    assert np.ptp(above["Waist"].points[:, 0]) > 80 and np.ptp(above["Waist"].points[:, 1]) < 1
    (reach,) = (name.reach for name in marked_lines(addon, source).names if name.texts == ("Waist",))
    assert above["Waist"].reach == pytest.approx(100 * reach, rel=0.03)  # 100 pixels per unit at this distance
    assert look(addon, source, (10, 0, -4.4), (10, 0, 0), perspective) == {}  # from behind the surface
    assert look(addon, source, (10, 0, 4.4), (10, 0, 9), perspective) == {}  # in the other direction
    assert look(addon, source, (10, 0, 150), (10, 0, 0), perspective) == {}  # from too far away, so it is clipped
    right = 12 if perspective else 14.3
    aside = look(addon, source, (right, 0, 1.5), (right, 0, 0), perspective)
    assert len(aside["Waist"].points) < len(above["Waist"].points)  # without points outside of the region
    assert np.all((aside["Waist"].points >= 0) & (aside["Waist"].points <= (800, 600)))


@pytest.mark.parametrize("perspective", [True, False])
def test_names_behind_another_part_of_the_model_are_not_written(addon, perspective):
    """A sheet with a wire is below a larger sheet of the same object."""
    source = grid("Low", lambda x, y: (x, y, 0.0), wire=on_line(1, 0.0))
    high = grid("High", lambda x, y: (3 * x, 3 * y, 1.0))
    select_only(source, high)
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    assert "Wire 1" not in look(addon, source, (0, 0, 4), (0, 0, 0), perspective)
    assert "Wire 1" in look(addon, source, (0, 0, 4), (0, 0, 0), perspective, xray=True)
    bpy.ops.object.mode_set(mode="EDIT")
    assert "Wire 1" not in look(addon, source, (0, 0, 4), (0, 0, 0), perspective)
    edit = bmesh.from_edit_mesh(source.data)
    for face in edit.faces:
        face.hide_set(face.calc_center_median().z > 0.5)
    bmesh.update_edit_mesh(source.data)
    bpy.context.view_layer.update()
    assert "Wire 1" in look(addon, source, (0, 0, 4), (0, 0, 0), perspective)


def test_all_names_of_the_piece_that_is_chosen_in_the_list_are_written(addon):
    source = flattened("Bump", bump, seam=on_line(0, 0.0))
    flat = flat_of(source)
    eye = sum((Vector(corner) for corner in flat.bound_box), Vector()) / 8 + Vector((0, 0, 20))
    for chosen in range(2):
        source.wirewarp_active_piece = chosen
        names = look(addon, flat, flat.matrix_world @ eye, flat.matrix_world @ (eye - Vector((0, 0, 20))))
        assert {name.owner[1] for name in names.values() if name.is_selected} <= {chosen}
        assert any(name.is_selected for name in names.values())


@pytest.fixture
def notes(addon):
    """Return a function that shows a map and returns the result of the overlay's function `of`: notes or a value."""

    def notes_of(shown_map, of="missing_maps"):
        addon.state.drawings.forget()
        bpy.context.scene.wirewarp.shown_map = shown_map
        shown, context = addon.overlay.shown, view_context()
        return getattr(shown, of)(list(shown.drawings(context)), shown.shown_map(context))

    return notes_of


def test_a_map_shows_its_figure_or_why_it_is_missing(addon, source, notes):
    needed = max(piece.needed for piece in addon.state.reports.last_report(source).pieces)
    figure = f"99% of the area: up to {addon.core.percent_text(needed)} in the worst direction"
    assert notes("STRETCH_COLOR", "map_notes") == [figure]
    assert notes("LENGTH_VARIATION_COLOR", "map_notes") == [] and notes("STRETCH_COLOR") == []
    assert notes("WEFT_STRAIN_COLOR") == ["No fabric was chosen: no map"]
    raise_vertex(source)
    assert notes("STRETCH_COLOR") == ["Model changed: flatten again"]
    mark(grid("New", bump), RIGID)
    assert notes("STRETCH_COLOR") == ["Not flattened: no map", "Model changed: flatten again"]


def test_the_legend_shows_the_figures_of_the_piece_list_and_no_others(addon, source, notes):
    threads = [piece.threads for piece in report_after(addon, source, cloth="JERSEY").pieces]
    across, along, shear = (max(getattr(each, way) for each in threads) for way in ("across", "along", "shear"))
    figures = {
        "WEFT_STRAIN_COLOR": addon.core.percent_text(across),
        "WARP_STRAIN_COLOR": addon.core.percent_text(along),
        "SHEAR_ANGLE_COLOR": f"{math.degrees(shear):.0f}°",
        "STRETCH_COLOR": f"{addon.core.percent_text(across)} across and {addon.core.percent_text(along)} along",
    }
    for shown_map, figure in figures.items():
        assert notes(shown_map, "map_notes") == [f"99% of the area: up to {figure}"]
        assert notes(shown_map, "highest_value") is None  # It would be a second figure for the same strain.
    assert notes("LENGTH_VARIATION_COLOR", "highest_value") > 0


def test_edit_mode_of_flat_pieces_is_not_a_change(source, notes):
    bpy.context.view_layer.objects.active = flat_of(source)
    bpy.ops.object.mode_set(mode="EDIT")
    assert notes("STRETCH_COLOR") == ["In Edit Mode: no map"]
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.objects.active = source
    bpy.ops.object.mode_set(mode="EDIT")
    assert notes("STRETCH_COLOR") == []  # The flat pieces show the map.


def test_failed_elements_are_drawn_on_model_pieces_and_map(addon, notes):
    source = grid("Spike", lambda x, y: (x, y, 2 * (1 - x * x) * (1 - y * y)), wire=on_line(0, 0.0))
    mark(source, on_line(1, 0.0))
    flatten_fails("flipped", method="WIREWARPING")
    faces = {face for issue in addon.state.reports.last_report(source).issues for face in issue.faces}
    (in_map,) = addon.overlay.shown.uv_drawings(sidebar())
    for found in (*map(addon.overlay.failures.failures, (source, flat_of(source))), in_map.failures):
        assert len(found.triangles) == 3 * 2 * len(faces)  # corners of two triangles for each quad
        assert len(found.lines["failed"]) > 0
    centers = addon.overlay.failures.failures(source).triangles.reshape(-1, 6, 3).mean(axis=1)
    expected = [source.data.polygons[face].center for face in sorted(faces)]
    assert np.linalg.norm(centers[:, :2] - np.array(expected)[:, :2], axis=1).max() < 0.1
    source.data.vertices[0].co = source.data.vertices[1].co  # Invalid input is drawn with edges only.
    notify(source)
    flatten_fails("no area")
    assert addon.overlay.failures.failures(source).lines.keys() == {"failed"}
    other = grid("Wide", bump, size=4)
    other.data.vertices[6].co.z = float("nan")
    flatten_fails("Wide: ")
    bpy.data.objects.remove(flat_of(source))
    bpy.data.objects.remove(source)
    assert notes("STRETCH_COLOR") == ["Not flattened: no map"]  # The model has not changed since the run.


def test_a_failed_piece_has_lines_around_it_and_none_inside(addon):
    bpy.ops.mesh.primitive_cylinder_add(vertices=12, end_fill_type="NOTHING")
    tube = bpy.context.active_object
    flatten_fails("tube")
    assert "failed" not in addon.overlay.failures.failures(tube).lines  # A tube alone has not failed, but needs a cut.
    select_only(tube, grid("Bump", bump))
    bpy.ops.object.join()
    flatten_fails("tube")
    (issue,) = addon.state.reports.last_report(tube).issues
    found = addon.overlay.failures.failures(tube)
    assert len(found.triangles) == 3 * 2 * 12
    drawn = found.lines["failed"].reshape(-1, 2, 3)
    around = np.abs(drawn[:, 0, 2] - drawn[:, 1, 2]) < 1e-6
    assert around.sum() == 2 * 12 and (~around).sum() <= len(issue.vertices)


def test_a_closed_model_has_not_failed_but_a_closed_piece_beside_a_good_one_is_in_the_legend(addon):
    """The proposed slit of the closed model is not drawn, because no button below Flatten marks it."""
    corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    source = make_object("Closed", corners, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    assert list(addon.overlay.shown.drawings(view_context())) == []
    flatten_fails("is closed")
    (drawing,) = addon.overlay.shown.drawings(view_context())
    assert drawing.target == source and drawing.failures.kinds == set()
    assert addon.state.reports.last_report(source).issues[0].proposed_seams
    select_only(source, grid("Bump", bump))
    bpy.ops.object.join()
    flatten_fails("closed")
    found = addon.overlay.failures.failures(bpy.context.active_object)
    assert found.kinds == {"failed"} and len(found.triangles) > 0


def test_proposed_seams_are_drawn_while_a_button_marks_them(addon):
    source = tube()
    flatten_fails("tube")
    issue = addon.state.reports.last_report(source).issues[0]
    drawn = addon.overlay.failures.failures(source).lines["proposed"]
    ends = [tuple(source.data.vertices[vertex].co) for pair in issue.proposed_seams for vertex in sorted(pair)]
    assert sorted(map(tuple, drawn.tolist())) == sorted(ends)
    bpy.ops.object.mode_set(mode="EDIT")
    assert np.array_equal(addon.overlay.failures.failures(source).lines["proposed"], drawn)
    # After this search, the button below Flatten marks the suggested cuts instead of the proposed seams.
    assert bpy.ops.object.wirewarp_suggest_seams() == {"FINISHED"}
    assert "proposed" not in addon.overlay.failures.failures(source).lines
