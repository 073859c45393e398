# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers, names and stored properties that nobody would choose: everything answers, and nothing is lost."""

import math
import xml.etree.ElementTree as ElementTree
from types import SimpleNamespace

import bpy
import pytest
from everything import answer, draw_panels
from surfaces import bump, flat_of, grid, mark, on_line, select_only

NAN = math.nan
WIRE = on_line(1, 0.0)


def fill(mesh, name, value):
    data = mesh.attributes[name].data
    data.foreach_set("value", [value] * len(data))


@pytest.mark.parametrize("tolerance", [NAN, -math.inf, -1.0, 1.0, 1e30])
def test_tolerances_that_are_none(model, everything_answers, tolerance):
    def spoil():
        for target in (model, flat_of(model)):
            fill(target.data, "wirewarp_tolerance", tolerance)

    everything_answers(spoil)


def test_a_tolerance_that_is_none_is_named_with_its_wire():
    model = grid("Bump", bump)
    mark(model, WIRE)
    fill(model.data, "wirewarp_tolerance", -0.5)
    assert 'Wire "Wire 1" has an invalid tolerance' in answer("object.wirewarp_flatten")
    assert "Bump Flat" not in bpy.data.objects


@pytest.mark.parametrize("number", [-1, -(2**31), 2**31 - 1])
def test_ids_of_any_number(model, everything_answers, number):
    def spoil():
        for name in ("wirewarp_wire", "wirewarp_piece"):
            fill(model.data, name, number)
        model.data.wirewarp_grain = number

    everything_answers(spoil)


@pytest.mark.parametrize("name", ["wirewarp_wire", "wirewarp_tolerance"])
def test_marks_by_halves(model, everything_answers, name):
    def spoil():
        if name in model.data.attributes:
            model.data.attributes.remove(model.data.attributes[name])

    everything_answers(spoil)


NAMES = ["", " ", "two\nlines", "\x01", "漢字 🧵", "x" * 1000, "../<&>\"'%s{0}"]


@pytest.mark.parametrize("name", NAMES)
def test_names_of_any_kind(model, everything_answers, name):
    def spoil():
        for entry in [*model.wirewarp_pieces, *model.data.wirewarp_names]:
            entry.name = name

    everything_answers(spoil)


def test_lists_that_are_too_long_or_double(model, everything_answers):
    wire_id = model.data.wirewarp_names[0].wire_id

    def spoil():
        for number in range(3):
            model.wirewarp_pieces.add().piece_id = -number
            model.data.wirewarp_names.add().wire_id = wire_id

    everything_answers(spoil)


def test_lists_that_are_empty(model, everything_answers):
    def spoil():
        model.wirewarp_pieces.clear()
        model.data.wirewarp_names.clear()

    everything_answers(spoil)


BELOW = pytest.mark.skipif(bpy.app.version >= (5, 0, 0), reason="Blender 5 keeps what is below properties to itself")
STORED = [3, 2.5, "text", [1, 2, 3], [0.5, NAN], {"a": 1}]
ON_FLAT_MESH = ["flat_counts", "flat_areas", "range_stretch_color", "layout", "source_faces", "up", "away"]


@pytest.mark.parametrize("value", STORED)
def test_stored_properties_of_another_type(model, everything_answers, value):
    def spoil():
        flat = flat_of(model)
        for name in ON_FLAT_MESH:
            flat.data[f"wirewarp_{name}"] = value
        model.data["wirewarp_uv_scale"] = value

    everything_answers(spoil)


@BELOW
@pytest.mark.parametrize("value", STORED)
def test_what_is_below_blenders_properties(model, everything_answers, value):
    choices = ("method", "spacing", "fairness", "shown_map", "auto_update", "orientation")

    def put(owner, *names):
        for name in names:
            if name in owner:  # for its type is kept
                del owner[name]
            owner[name] = value

    def spoil():
        scene = bpy.context.scene
        scene.wirewarp.spacing = 2.0
        put(scene["wirewarp"], *choices)
        put(model, "wirewarp_pieces", "wirewarp_active_piece")
        put(model.data, "wirewarp_names", "wirewarp_grain")

    everything_answers(spoil)


@BELOW
def test_a_choice_of_another_version_goes_back_to_its_default(addon):
    settings = bpy.context.scene.wirewarp
    settings.spacing = 2.0
    bpy.context.scene["wirewarp"]["method"] = 77
    assert settings.method == ""
    draw_panels(addon)
    operator = SimpleNamespace(properties=SimpleNamespace(is_property_set=lambda _: False))
    addon.properties.take_settings(operator, settings)
    assert (operator.method, operator.spacing, settings.method) == ("REFINED", 2.0, "REFINED")


def test_a_pattern_of_names_that_are_no_text(model, tmp_path):
    for entry, name in zip(model.wirewarp_pieces, ["\x01 Front", "\ufffe", "Back"], strict=True):
        entry.name = name
    path = tmp_path / "pattern.svg"
    select_only(model)
    assert answer("object.wirewarp_export_svg", filepath=str(path), failed_pieces=True) == "{'FINISHED'}"
    titles = [element.text for element in ElementTree.parse(path).iter() if element.tag.endswith("title")]
    assert "\ufffd Front" in titles
    assert "\ufffd" in titles
