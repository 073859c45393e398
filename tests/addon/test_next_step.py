# SPDX-License-Identifier: GPL-3.0-or-later
"""A button below Flatten offers the next step after a run. One click fixes the model and flattens it."""

from types import SimpleNamespace

import bpy
import pytest
from everything import draw_panels, drawn_buttons
from flattening import fails, flatten_fails, flattened
from surfaces import bump, everywhere, flat_of, grid, make_object, mark, on_edges, on_line, select_only, tube
from test_proposals import CUT, inside, joined, seams_of

FIX = bpy.ops.object.wirewarp_mend


def step_of(addon, source, left_out=()):
    return addon.report_panel.next_step.next_step(addon.state.reports.last_report(source), list(left_out))


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_proposed_seams_are_marked_and_flattened_with_one_click(addon, mode):
    source = joined(tube(), tube("Other", place=4.0))
    assert "object.wirewarp_mend" not in drawn_buttons(addon)
    flatten_fails(CUT)
    bpy.ops.object.mode_set(mode=mode)
    assert "object.wirewarp_mend" in drawn_buttons(addon)
    step = step_of(addon, source)
    assert (step.text, step.settings) == ("Mark and Flatten", {"what": "SEAMS"})
    assert FIX(**step.settings) == {"FINISHED"}
    assert (source.mode, addon.state.reports.last_report(source).ok, step_of(addon, source)) == (mode, True, None)
    assert "object.wirewarp_mend" not in drawn_buttons(addon)


def contradiction():
    return grid("Saddle", lambda x, y: (x, y, 0.25 * x * y), size=4, faces="triangles", wire=inside)


def sliver():
    """Return two squares, and a face between them whose three vertices are collinear."""
    vertices = [(0, 0, 0), (1, 0, 0), (1, 0.5, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0)]
    return make_object("Sliver", vertices, [(0, 1, 2, 3, 4), (1, 5, 6, 3), (1, 3, 2)])


def loose_faces():
    """Return a mesh in which each face has vertices of its own, as in some files."""
    source = grid("Loose", bump, size=48)
    on_edges(source, bpy.ops.mesh.edge_split, everywhere)
    return source


def one_face_flipped():
    source = grid("Bump", bump, size=4)
    source.data.polygons[5].flip()
    return source


@pytest.mark.parametrize(
    ("make", "said", "button", "faces", "again"),
    [
        (contradiction, "flattened with", "Loosen and Flatten", 32, "does not suggest a tolerance"),
        (sliver, "no area", "Dissolve and Flatten", 2, "has no zero-area faces"),
        (loose_faces, "(?i)merge", "Merge and Flatten", 48 * 48, "Nothing to merge: no vertices"),
        (one_face_flipped, "to opposite sides", "Fix Normals and Flatten", 16, "so that more normals agree"),
    ],
)
def test_a_fault_is_fixed_and_the_model_flattened_with_one_click(addon, make, said, button, faces, again):
    source = make()
    flatten_fails(said)
    step = step_of(addon, source)
    assert step.text == button
    (issue,) = addon.state.reports.last_report(source).issues
    fault = issue.sentence.partition(". ")[0]
    # The fault is below the verdict and in the report. All panels are drawn twice: narrow and wide.
    assert draw_panels(addon).count(fault) == 4
    assert FIX(**step.settings) == {"FINISHED"}
    assert len(source.data.polygons) == faces and addon.state.reports.last_report(source).ok
    assert len(source.data.vertices) == (49 * 49 if make is loose_faces else len(source.data.vertices))
    fails(FIX, again, **step.settings)


def test_tooltips_of_fixes_are_one_sentence(addon):
    rna = FIX.get_rna_type()
    for item in rna.properties["what"].enum_items:
        shown = SimpleNamespace(what=item.identifier, rna_type=rna)
        tooltip = addon.report_panel.fix.OBJECT_OT_wirewarp_mend.description(bpy.context, shown)
        assert tooltip.endswith(", and flatten again") and ". " not in tooltip


def test_ignored_modifiers_turn_the_verdict_amber_and_are_used_afterwards(addon):
    source = grid("Bump", bump, size=4)
    source.modifiers.new("Smooth", "SUBSURF").levels = 1
    bpy.ops.object.wirewarp_flatten()
    assert "so sizes differ from what you see" in draw_panels(addon) and "Lengths are exact" not in draw_panels(addon)
    step = step_of(addon, source, ["modifiers"])
    assert step.text == "Flatten with Modifiers"
    assert FIX(**step.settings) == {"FINISHED"}
    assert len(flat_of(source).data.polygons) == 64
    assert bpy.context.scene.wirewarp.use_modifiers
    assert "Lengths are exact" in draw_panels(addon) and "Flatten with Modifiers" not in draw_panels(addon)
    source.modifiers.clear()
    bpy.ops.object.wirewarp_flatten()
    assert "Lengths are exact" in draw_panels(addon)
    modifier = source.modifiers.new("Smooth", "SUBSURF")
    bpy.context.view_layer.update()
    assert "so sizes differ from what you see" in draw_panels(addon)
    modifier.show_viewport = False
    bpy.context.view_layer.update()
    assert "Lengths are exact" in draw_panels(addon)


def test_places_without_a_remedy_are_shown(addon):
    """The button shows the worst place of a strained piece, or the place of a failure."""
    source = flattened("Peak", lambda x, y: (x, y, 3 * (1 - x * x) * (1 - y * y)), size=6)
    step = step_of(addon, source)
    assert (step.text, step.settings) == ("Show Worst Place", {"what": "HINT", "index": 0})
    assert drawn_buttons(addon).count("object.wirewarp_suggest_darts") == 2  # narrow and wide
    assert bpy.ops.mesh.wirewarp_select_result(**step.settings) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    source.data.vertices[6].co.z = float("nan")
    flatten_fails(".")
    assert step_of(addon, source).text == "Show Failed Place"


def test_an_evenly_strained_piece_gets_a_suggested_cut(addon):
    """Some fabrics cannot stretch as much as this piece, but no place in it is strained enough for a hint."""
    source = flattened("Low", lambda x, y: (x, y, 0.3 * (1 - x * x) * (1 - y * y)), size=6)
    report = addon.state.reports.last_report(source)
    assert report.pieces[0].is_strained and not report.hints and step_of(addon, source) is None
    assert drawn_buttons(addon).count("object.wirewarp_suggest_darts") == 2  # narrow and wide


def test_the_button_is_refused_without_a_fault(addon):
    source = grid("Bump", bump)
    fails(FIX, "has not been flattened yet", what="SEAMS")
    bpy.ops.object.wirewarp_flatten()
    fails(FIX, "does not suggest a seam", what="SEAMS")
    assert len(seams_of(source)) == 0


def test_flat_pieces_represent_their_model(addon):
    source = flattened("Bump", bump)
    mark(source, on_line(0, 0.0))
    select_only(flat_of(source))
    assert bpy.ops.object.wirewarp_flatten() == {"FINISHED"}
    assert [wire.name for wire in addon.state.reports.last_report(source).wires] == ["Wire 1"]
    assert bpy.context.active_object == flat_of(source)
    bpy.ops.object.mode_set(mode="EDIT")
    assert bpy.ops.object.wirewarp_flatten(only_active=True, keep_places=False) == {"FINISHED"}
    assert flat_of(source).mode == "EDIT"


def test_edges_proposed_for_mirror_images_are_counted_once(addon):
    source = joined(tube(place=-2.0), tube("Other", place=2.0))
    flatten_fails(CUT)
    issues = addon.state.reports.last_report(source).issues
    # There is one issue for each of the two tubes. Each issue proposes 6 edges on each tube.
    assert sum(len(issue.proposed_seams) for issue in issues) == 2 * 2 * 6
    assert step_of(addon, source).sentence == "Suggested seam: 12 edges."


def test_refusals_of_flatten_are_reported(addon):
    source = flattened("Bump", bump)
    source.hide_set(True)
    fails(FIX, '"Bump" is hidden', what="MODIFIERS")
    assert not bpy.context.scene.wirewarp.use_modifiers


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_modifiers_are_applied_so_that_proposed_edges_can_be_marked(addon, mode):
    source = tube()
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    bpy.context.scene.wirewarp.use_modifiers = True
    flatten_fails(CUT, use_modifiers=True)
    bpy.ops.object.mode_set(mode=mode)
    step = step_of(addon, source)
    assert step.text == "Apply Modifiers and Flatten"
    coarse = len(source.data.vertices)
    fails(FIX, "mark a seam", **step.settings, use_modifiers=True)
    assert not source.modifiers and source.mode == mode
    assert not bpy.context.scene.wirewarp.use_modifiers
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(source.data.vertices) > coarse
    step = step_of(addon, source)
    assert step.text == "Mark and Flatten"
    assert FIX(**step.settings) == {"FINISHED"}
    assert addon.state.reports.last_report(source).ok


def test_modifiers_of_a_shared_mesh_are_not_applied(addon):
    source = tube()
    source.modifiers.new("Finer", "SUBSURF").levels = 1
    other = source.copy()
    fails(FIX, "shares its mesh with other objects", what="APPLY")
    assert source.modifiers and other.data == source.data


def test_the_strained_place_is_the_largest_of_the_worst_piece(addon):
    """The button does not show wires at their limits or small strained places."""

    def entry(code, piece, faces, edges=()):
        return addon.core.Hint(code, "", piece, edges=list(edges), faces=list(range(faces)))

    piece = SimpleNamespace(is_strained=True)
    report = addon.solve.report.ObjectReport(pieces=[piece, piece])
    report.hints = [
        entry("wire_at_limit", None, 0, [(0, 1)]),
        entry("strained", 1, 1),
        entry("strained", 0, 50),
        entry("strained", 1, 20),
    ]
    step = addon.report_panel.next_step.next_step(report, [])
    assert (step.text, step.settings) == ("Show Worst Place", {"what": "HINT", "index": 3})


def test_amber_offers_fabrics_and_one_click_flattens_for_one(addon):
    source = flattened("Bump", bump, size=4)
    report = addon.state.reports.last_report(source)
    offered, others = addon.report_panel.flatten_panel.fabrics_to_choose(report)
    needed = report.pieces[0].needed
    limits = {name: min(addon.core.Cloth.preset(name).limits) for name in addon.core.Cloth.presets()}
    assert set(offered) == {name for name, limit in limits.items() if limit >= needed}
    assert offered and others and {*offered, *others} == set(limits)
    labels = [addon.state.settings.fabric_label(name) for name in [*offered, *others]]
    assert all(label in draw_panels(addon) for label in labels)
    everyday = addon.report_panel.flatten_panel.EVERYDAY
    one_click = f"Flatten for {addon.core.Cloth.about(next(name for name in offered if name in everyday))['label']}"
    assert one_click in draw_panels(addon)
    bpy.context.scene.wirewarp.cloth = "WOVEN"
    assert "Flatten for" not in draw_panels(addon)
    bpy.context.scene.wirewarp.cloth = "NONE"
    bpy.context.scene.wirewarp.gives_along = 2.0  # a value for an earlier fabric
    assert FIX(what="FABRIC", cloth=offered[0].upper()) == {"FINISHED"}
    assert bpy.context.scene.wirewarp.cloth == offered[0].upper()
    assert addon.core.verdict(addon.state.reports.last_report(source)).is_ready
    assert labels[-1] not in draw_panels(addon) and one_click not in draw_panels(addon)
    bpy.ops.object.wirewarp_flatten(cloth="WOVEN", gives_across=0.1, gives_along=0.1)
    assert not addon.core.verdict(addon.state.reports.last_report(source)).is_ready
    assert "Flatten for" not in draw_panels(addon)  # because the user has chosen a fabric


@pytest.mark.parametrize(("needed", "label"), [(0.06, "Fleece"), (0.11, "Jersey"), (0.6, "Swim Knit"), (0.9, "")])
def test_one_click_names_no_special_material(addon, needed, label):
    """For 6%, leather would suffice, but the button names fleece, because more people sew it."""
    drawn = []
    row = SimpleNamespace(operator=lambda _name, text, icon: drawn.append(text) or SimpleNamespace())
    report = SimpleNamespace(pieces=[SimpleNamespace(threads=None, needed=needed)])
    addon.report_panel.flatten_panel._draw_fabric(SimpleNamespace(row=lambda: row), report)
    assert drawn == ([f"Flatten for {label}"] if label else [])


def test_no_fabric_stretches_farther_than_swim_knit(addon):
    preset, names = addon.core.Cloth.preset, set(addon.core.Cloth.presets())
    assert names >= addon.report_panel.flatten_panel.EVERYDAY
    assert all(preset(name).limits[side] <= preset("swim").limits[side] for name in names for side in (0, 1))


def test_a_fabric_is_offered_if_it_stretches_far_enough_in_each_direction(addon):
    """Minky stretches 20% across and 5% along the grain, foam 10% and felt 5% in both directions."""
    strains = [SimpleNamespace(across=0.1, along=0.01), SimpleNamespace(across=0.02, along=0.04)]
    report = SimpleNamespace(pieces=[SimpleNamespace(threads=threads) for threads in strains])
    choose = addon.report_panel.flatten_panel.fabrics_to_choose
    offered, others = choose(report)
    assert {"minky", "foam"} <= set(offered) and "felt" in others
    assert choose(report, "felt")[1] == [name for name in others if name != "felt"]


def test_pieces_without_room_for_their_allowances_are_named(addon, capfd):
    source = flattened("Strip", lambda x, y: (0.1 * x, 0.008 * y, 0.0))  # a strip of 200 by 16 mm
    message = capfd.readouterr().out
    assert "no room for two allowances" in message and "Ready to cut" not in message
    words = "has no room for two allowances in one place, and may be too narrow to sew."
    for allowance, is_named in ((10.0, True), (5.0, False), (10.0, True)):
        bpy.context.scene.wirewarp.allowance = allowance
        assert (f"{source.wirewarp_pieces[0].name} {words}" in draw_panels(addon)) == is_named
    on_edges(source, bpy.ops.mesh.wirewarp_allowance, everywhere, kind="WIDTH", width=2.0)
    capfd.readouterr()
    bpy.ops.object.wirewarp_flatten()
    shown, message = draw_panels(addon), capfd.readouterr().out
    assert "Ready to cut" in shown and words not in shown
    assert "Ready to cut" in message and words not in message


def test_normals_are_fixed_before_seams_are_marked(addon):
    """A flipped face can look like an opening of the piece. A seam would only hide the wrong normal."""
    issues = [
        addon.core.Issue("too_many_boundaries", "It has three openings.", piece=0, proposed_seams=((0, 1),)),
        addon.core.Issue("inconsistent_orientation", "Faces are turned.", piece=1),
    ]
    report = SimpleNamespace(issues=issues, with_modifiers=False, uv_seams=None, offered_seams=[(0, 1)])
    assert addon.report_panel.next_step.next_step(report, []).settings == {"what": "NORMALS"}
