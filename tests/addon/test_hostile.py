# SPDX-License-Identifier: GPL-3.0-or-later
"""In damaged files, every command works or is refused in a sentence, and loses no data.

- CASES: tested with READERS only
- WORST: damage of data that many commands read, tested with every command
"""

import json
import math
from types import SimpleNamespace

import bpy
import pytest
from everything import COMMANDS, READERS, answer, draw_panels
from surfaces import addon_module, bump, flat_of, grid, new_object, select_only

NAN = math.nan
NAMES = addon_module().names
# Together, OF_MODEL and OF_PIECES have an attribute of each type and domain, and each attribute that the add-on checks
# before it writes. WORST has a case for wires.
OF_MODEL = (
    *(NAMES.TOLERANCE, NAMES.EASED_SIDE, NAMES.SIDE_EASE, NAMES.ALLOWANCE, NAMES.FACE, NAMES.PIECE, NAMES.SEAM),
    NAMES.Attribute(NAMES.NO_SEAM, "FLOAT", "FACE"),
)
OF_PIECES = (NAMES.SOURCE_VERTEX, NAMES.Attribute("stretch_color", "FLOAT_COLOR", "CORNER"))
TITLES = ["", " ", "two\nlines", "\x01", "漢字 🧵", "x" * 1000, "../<&>\"'%s{0}"]
VALUES = [3, 2.5, "text", [1, 2, 3], [0.5, NAN], {"a": 1}]


def fill(mesh, value, *attributes):
    for each in attributes:
        data = (mesh.attributes.get(each.name) or mesh.attributes.new(each.name, each.data_type, each.domain)).data
        data.foreach_set("value", [value] * len(data))


def fill_tolerances(model, value):
    for target in (model, flat_of(model)):
        fill(target.data, value, NAMES.TOLERANCE)


def fill_ids(model, value):
    fill(model.data, value, NAMES.WIRE, NAMES.PIECE, NAMES.SEAM)
    model.data.wirewarp_grain = value


def fill_flat_ids(model, value):
    sources = (NAMES.SOURCE_VERTEX, NAMES.SOURCE_CORNER, NAMES.SOURCE_FACE)
    fill(flat_of(model).data, value, NAMES.PIECE_INDEX, *sources, NAMES.PIECE, NAMES.WIRE)


def remove(mesh, attribute):
    if attribute.name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[attribute.name])


def retype(mesh, attribute, data_type, domain):
    remove(mesh, attribute)
    mesh.attributes.new(attribute.name, data_type, domain)


def rename(model, first):
    """Rename pieces and wires with the texts of TITLES in turn. first: index of the first text."""
    for number, entry in enumerate([*model.wirewarp_pieces, *model.data.wirewarp_names], start=first):
        entry.name = TITLES[number % len(TITLES)]


def lengthen_lists(model):
    wire_id = model.data.wirewarp_names[0].wire_id if model.data.wirewarp_names else 1
    for number in range(3):
        model.wirewarp_pieces.add().piece_id = -number
        model.data.wirewarp_names.add().wire_id = wire_id


def clear_lists(model):
    model.wirewarp_pieces.clear()
    model.data.wirewarp_names.clear()


def store(model, first):
    """Store one of VALUES in each property. first: index of the first value."""
    places = [(flat_of(model).data, "wirewarp_flat"), (model.data, "wirewarp_uv_scale")]
    if bpy.app.version < (5, 0, 0):  # Blender 5 hides the data behind properties
        scene = bpy.context.scene
        scene.wirewarp.spacing = 2.0
        choices = ("method", "spacing", "fairness", "shown_map", "auto_update", "orientation")
        places += [(scene["wirewarp"], name) for name in choices]
        places += [(model, "wirewarp_pieces"), (model, "wirewarp_active_piece")]
        places += [(model.data, "wirewarp_names"), (model.data, "wirewarp_grain")]
    for number, (owner, name) in enumerate(places, start=first):
        if name in owner:  # An existing property would keep its type.
            del owner[name]
        owner[name] = VALUES[number % len(VALUES)]


def empty():
    return bpy.data.objects.get("Empty") or new_object("Empty")


def other_model():
    return bpy.data.objects.get("Other") or grid("Other", bump, size=2)


def convert(target, kind):
    if target.type == "MESH":
        select_only(target)
        bpy.ops.object.convert(target=kind)


WORST = {
    "tolerances that are NaN": lambda model: fill_tolerances(model, NAN),
    "names of any kind": lambda model: rename(model, 0),
    "half a report": lambda model: model.__setitem__("wirewarp_report", '{"schema": "wirewarp-rep'),
    "a model with another mesh": lambda model: setattr(model, "data", other_model().data),
    "ids of the pieces above all others": lambda model: fill_flat_ids(model, 2**31 - 1),
    "wires that are text": lambda model: retype(model.data, NAMES.WIRE, "STRING", "EDGE"),
}
CASES = {
    "a negative tolerance": lambda model: fill_tolerances(model, -1.0),
    "a huge tolerance": lambda model: fill_tolerances(model, 1e30),
    "an ease that is NaN": lambda model: fill(model.data, NAN, NAMES.EASE),
    "an ease that leaves nothing": lambda model: fill(model.data, -1.0, NAMES.EASE),
    "an infinite allowance": lambda model: fill(model.data, math.inf, NAMES.ALLOWANCE),
    "wires without tolerances": lambda model: remove(model.data, NAMES.TOLERANCE),
    "tolerances without wires": lambda model: remove(model.data, NAMES.WIRE),
    "names of any other kind": lambda model: rename(model, 4),
    "lists that are too long and double": lengthen_lists,
    "lists that are empty": clear_lists,
    "a seal of another type": lambda model: model.__setitem__("wirewarp_report_seal", [1.5, 2.5]),
    "pieces of an empty": lambda model: setattr(flat_of(model), "wirewarp_source", empty()),
    "pieces of themselves": lambda model: setattr(flat_of(model), "wirewarp_source", flat_of(model)),
    "pieces of another model": lambda model: setattr(flat_of(model), "wirewarp_source", other_model()),
    "a model of its pieces": lambda model: setattr(model, "wirewarp_source", flat_of(model)),
    "an empty claims the model": lambda model: setattr(empty(), "wirewarp_source", model),
    "pieces that are a curve": lambda model: convert(flat_of(model), "CURVE"),
    "a model that is a curve": lambda model: convert(model, "CURVE"),
    "pieces with the mesh of the model": lambda model: setattr(flat_of(model), "data", model.data),
    "pieces with the mesh of another model": lambda model: setattr(flat_of(model), "data", other_model().data),
    "pieces without geometry": lambda model: flat_of(model).data.clear_geometry(),
    "pieces that are nowhere": lambda model: setattr(flat_of(model).data.vertices[0], "co", (NAN, NAN, NAN)),
    "a model in no scene": lambda model: [each.objects.unlink(model) for each in model.users_collection],
    "ids of the model below all others": lambda model: fill_ids(model, -(2**31)),
    "ids of the model above all others": lambda model: fill_ids(model, 2**31 - 1),
    "ids of the pieces below 0": lambda model: fill_flat_ids(model, -1),
    "other values in every property": lambda model: store(model, 0),
    "lists and texts in every property": lambda model: store(model, 3),
}
# Every second attribute is on other elements of the mesh. The attributes between them get another type.
for number, attribute in enumerate((*OF_MODEL, *OF_PIECES)):
    other = "POINT" if attribute.domain == "CORNER" else "CORNER"
    kind = (attribute.data_type, other) if number % 2 else ("STRING", attribute.domain)
    CASES[f"{attribute.name} as {kind}"] = lambda model, attribute=attribute, kind=kind: retype(
        (model if attribute in OF_MODEL else flat_of(model)).data, attribute, *kind
    )


@pytest.mark.parametrize("case", CASES)
def test_every_reader_of_damaged_data_works_or_is_refused(model, everything_answers, case):
    # The modes alternate after two cases. Otherwise, each fault of attributes would be tested in one mode only.
    modes = ("OBJECT", "EDIT") if list(CASES).index(case) // 2 % 2 else ("EDIT", "OBJECT")
    everything_answers(lambda: CASES[case](model), READERS, modes)


# cases that depend on Blender's Python interface
OF_BLENDER = ("a model with another mesh", "wires that are text")


@pytest.mark.parametrize("case", [pytest.param(c, marks=[pytest.mark.api] * (c in OF_BLENDER)) for c in WORST])
def test_every_command_works_or_is_refused(model, everything_answers, case):
    everything_answers(lambda: WORST[case](model), COMMANDS)


def edited(**entries):
    def edit(text):
        return json.dumps(json.loads(text) | entries)

    return edit


@pytest.mark.parametrize(
    "edit",
    [
        lambda text: text[: len(text) // 2],
        lambda _: "",
        lambda _: "{}",
        lambda _: "[" * 100_000,
        lambda _: '{"schema": "wirewarp-report-4"}',
        lambda _: "\udcff",  # a byte that is not a character
        lambda _: 7,
        lambda _: [1, 2],
        lambda _: {"pieces": 3},
        edited(pieces=[]),
        edited(seams=[{"edges": [[0, 99]]}]),
        edited(schema="wirewarp-report-1"),
    ],
)
def test_a_report_edited_by_hand_is_refused(model, addon, edit):
    model["wirewarp_report"] = edit(model["wirewarp_report"])
    select_only(model)
    assert "from another version of WireWarp. Flatten again" in draw_panels(addon)
    assert not addon.state.reports.last_report(model).ok
    assert bpy.ops.mesh.wirewarp_select_issues() == {"CANCELLED"}


def test_a_flat_face_without_its_source_face_is_reported(model):
    flat_of(model).data.attributes["source_face"].data[0].value = 1000
    select_only(model)
    said = answer("mesh.wirewarp_select_result", what="PIECE", index=0)
    assert '"Bump" has changed since it was flattened. Flatten it again' in said


@pytest.mark.skipif(bpy.app.version >= (5, 0, 0), reason="Blender 5 hides the data behind properties")
def test_a_choice_of_another_version_becomes_the_default(addon):
    settings = bpy.context.scene.wirewarp
    settings.spacing = 2.0
    bpy.context.scene["wirewarp"]["method"] = 77
    assert settings.method == ""
    draw_panels(addon)
    operator = SimpleNamespace(properties=SimpleNamespace(is_property_set=lambda _: False))
    addon.properties.take_settings(operator, settings)
    assert (operator.method, operator.spacing, settings.method) == ("REFINED", 2.0, "REFINED")
