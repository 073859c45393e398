# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel and the export name each setting that has changed after the pieces were made."""

from unittest.mock import MagicMock

import bpy
import pytest
from everything import draw_panels
from flattening import flatten_fails, flattened
from surfaces import bump, flat_of, grid, half_cylinder, on_line

SENTENCE = "Settings changed after Flatten: {}. Flatten again to use them."


@pytest.fixture
def source():
    return flattened("Bump", bump, size=4, wire=on_line(1, 0.0))


def test_settings_of_the_methods_of_the_paper_are_under_advanced(addon):
    def drawn(part):
        layout = MagicMock()
        addon.ui.settings.draw_settings(layout, bpy.context.scene.wirewarp, part)
        return {call.args[1] for call in layout.row.return_value.prop.call_args_list}

    bpy.context.scene.wirewarp.cloth = "CUSTOM"
    front, main, advanced = map(drawn, addon.state.settings.PARTS)
    assert front == {"cloth", "gives_across", "gives_along"}  # only settings that everybody has to enter
    assert advanced == {"thickness", "surface", "method", "node_weight"}
    everything = set(addon.state.settings.FlattenSettings.__annotations__)
    assert front | main | advanced == everything and len(front) + len(main) + len(advanced) == len(everything)
    bpy.context.scene.wirewarp.cloth = "JERSEY"
    assert drawn("FRONT") == {"cloth"} and {"gives_across", "gives_along"} <= drawn("MAIN")


def give(addon, source, **settings):
    """Change settings of the panel. Return the sentence that names settings changed since the run."""
    for name, value in settings.items():
        setattr(bpy.context.scene.wirewarp, name, value)
    report = addon.state.reports.pieces_report(source)
    return addon.ui.settings.settings_sentence(source, report, bpy.context.scene.wirewarp)


def test_a_verdict_for_other_settings_has_no_tick(addon, source, monkeypatch):
    drawn = []
    panel = addon.report_panel.flatten_panel
    monkeypatch.setattr(panel, "draw_sentence", lambda _context, _layout, text, icon: drawn.append((text, icon)))
    bpy.context.scene.wirewarp.cloth = "NEOPRENE"
    bpy.ops.object.wirewarp_flatten(cloth="NEOPRENE")
    draw_panels(addon)
    (verdict,) = {text for text, icon in drawn if icon == "TICK"}
    drawn.clear()
    bpy.context.scene.wirewarp.cloth = "WOVEN"
    draw_panels(addon)
    assert (SENTENCE.format("Fabric"), "INFO") in drawn and (verdict, "BLANK1") in drawn
    assert all(icon != "TICK" for _, icon in drawn)


@pytest.mark.parametrize(
    ("settings", "names"),
    [
        ({"mirror": True, "method": "WIREWARPING"}, "Method, Mirrored"),
        ({"fairness": 0.2, "spacing": 100.0}, "Smooth Outlines, Gap"),
        ({"layout_kind": "ROW", "orientation": "BOUNDARY", "thickness": 3.0}, "Thickness, Layout, Upright"),
        ({"cloth": "WOVEN"}, "Fabric"),
        ({"cloth": "CUSTOM", "gives_along": 3.0}, "Fabric"),
    ],
)
def test_settings_that_would_change_the_pieces_are_named(addon, source, settings, names, tmp_path, capfd):
    assert give(addon, source) == ""
    assert give(addon, source, **settings) == SENTENCE.format(names)
    assert SENTENCE.format(names) in draw_panels(addon)
    bpy.ops.object.wirewarp_export_svg(filepath=str(tmp_path / "pattern.svg"))
    printed = capfd.readouterr().out
    # The pieces are still good, so this is not a warning.
    assert SENTENCE.format(names) in printed and "Warning" not in printed
    bpy.ops.object.wirewarp_flatten(**settings)
    assert give(addon, source) == ""


def test_settings_without_effect_are_not_named(addon, source):
    assert give(addon, source, node_weight="UNIFORM", use_modifiers=True, keep_places=False, orientation="UP") == ""
    source.modifiers.new("Smooth", "SUBSURF")
    bpy.ops.object.wirewarp_flatten()
    assert give(addon, source) == SENTENCE.format("Modifiers")
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert give(addon, source) == ""
    bpy.ops.object.wirewarp_flatten(method="WIREWARPING", use_modifiers=True, node_weight="UNIFORM")
    assert give(addon, source, method="WIREWARPING", fairness=0.5) == ""


def test_a_setting_for_one_run_is_not_an_error_and_failures_do_not_mention_settings(addon, source):
    bpy.ops.object.wirewarp_flatten(fairness=0.2)
    assert give(addon, source) == SENTENCE.format("Smooth Outlines")
    source.data.vertices[6].co.z = float("nan")
    flatten_fails(".")
    assert "Not flattened" in draw_panels(addon)
    assert "Settings changed" not in draw_panels(addon)  # Flattening again would not help.


def test_another_grain_wire_is_named(addon, source):
    source.data.wirewarp_grain = source.data.wirewarp_names[0].wire_id
    assert give(addon, source) == SENTENCE.format("Grain Wire")
    bpy.ops.object.wirewarp_flatten()
    assert give(addon, source) == ""
    bpy.ops.object.wirewarp_flatten(orientation="UP")  # This run does not use the grain wire.
    assert give(addon, source, orientation="WIRE") == SENTENCE.format("Upright")


def test_overlapping_pieces_are_named_at_the_export(source, tmp_path, capfd):
    source.data.edges.foreach_set("use_seam", [True] * len(source.data.edges))
    bpy.ops.object.wirewarp_flatten()
    path = str(tmp_path / "pattern.svg")
    bpy.ops.object.wirewarp_export_svg(filepath=path)
    assert "over one another" not in capfd.readouterr().out
    flat = flat_of(source).data
    pieces = [flat.attributes["piece"].data[face].value for face in (0, 5)]
    by = flat.polygons[0].center - flat.polygons[5].center
    for vertex in list(flat.polygons[5].vertices):
        flat.vertices[vertex].co += by
    bpy.ops.object.wirewarp_export_svg(filepath=path)
    names = [entry.name for entry in source.wirewarp_pieces]
    over = " and ".join(names[index] for index in sorted(pieces))
    assert f"These pieces overlap: {over}. Move them apart before you cut." in capfd.readouterr().out


def test_a_run_that_failed_with_the_settings_need_not_be_repeated(addon):
    source = grid("Half Tube", half_cylinder, size=4)
    source.modifiers.new("Whole", "MIRROR").use_axis = (False, False, True)
    bpy.ops.object.wirewarp_flatten()
    bpy.context.scene.wirewarp.use_modifiers = True
    assert SENTENCE.format("Modifiers") in draw_panels(addon)
    flatten_fails("mark a seam", use_modifiers=True)
    assert "Settings changed" not in draw_panels(addon)
