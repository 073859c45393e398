# SPDX-License-Identifier: GPL-3.0-or-later
"""Files edited by hand or by other scripts: everything answers with a result or a sentence, and nothing is lost.

Each case spoils one thing for those that read it; the six that most code reads meet every command.
"""

import json
import math
import xml.etree.ElementTree as ElementTree
from types import SimpleNamespace

import bpy
import pytest
from everything import COMMANDS, READERS, answer, draw_panels
from surfaces import bump, flat_of, grid, mark, on_line, select_only

NAN = math.nan
EXTREMES = [-1, -(2**31), 2**31 - 1]
MODEL_ATTRIBUTES = {
    "wirewarp_wire": ("INT", "EDGE"),
    "wirewarp_tolerance": ("FLOAT", "EDGE"),
    "wirewarp_ease": ("FLOAT", "EDGE"),
    "wirewarp_allowance": ("FLOAT", "EDGE"),
    "wirewarp_seam": ("INT", "EDGE"),
    "wirewarp_piece": ("INT", "FACE"),
    "wirewarp_face": ("INT", "FACE"),
    "wirewarp_no_seam": ("FLOAT", "FACE"),
}
FLAT_ATTRIBUTES = {
    "piece": ("INT", "FACE"),
    "source_vertex": ("INT", "POINT"),
    "source_corner": ("INT", "CORNER"),
    "source_face": ("INT", "FACE"),
    "flat_length": ("FLOAT", "EDGE"),
    "stretch_color": ("FLOAT_COLOR", "CORNER"),
}
NAMES = ["", " ", "two\nlines", "\x01", "漢字 🧵", "x" * 1000, "../<&>\"'%s{0}"]
VALUES = [3, 2.5, "text", [1, 2, 3], [0.5, NAN], {"a": 1}]


def fill(mesh, name, value):
    data = (mesh.attributes.get(name) or mesh.attributes.new(name, *MODEL_ATTRIBUTES[name])).data
    data.foreach_set("value", [value] * len(data))


def retype(mesh, name, data_type, domain):
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])
    mesh.attributes.new(name, data_type, domain)


def fill_tolerances(model, value):
    for target in (model, flat_of(model)):
        fill(target.data, "wirewarp_tolerance", value)


def fill_ids(model, value):
    for name in ("wirewarp_wire", "wirewarp_piece", "wirewarp_seam"):
        fill(model.data, name, value)
    model.data.wirewarp_grain = value


def fill_flat_ids(model, value):
    for name in ("piece", "source_vertex", "source_corner", "source_face", "wirewarp_piece", "wirewarp_wire"):
        fill(flat_of(model).data, name, value)


def remove(mesh, name):
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])


def rename(model, first):
    """Piece by piece and wire by wire, beginning with one of NAMES."""
    for number, entry in enumerate([*model.wirewarp_pieces, *model.data.wirewarp_names], start=first):
        entry.name = NAMES[number % len(NAMES)]


def lengthen_lists(model):
    wire_id = model.data.wirewarp_names[0].wire_id if model.data.wirewarp_names else 1
    for number in range(3):
        model.wirewarp_pieces.add().piece_id = -number
        model.data.wirewarp_names.add().wire_id = wire_id


def clear_lists(model):
    model.wirewarp_pieces.clear()
    model.data.wirewarp_names.clear()


def store(model, value):
    flat_of(model).data["wirewarp_flat"] = value
    model.data["wirewarp_uv_scale"] = value


def store_below(model, value):
    """Below Blender's own properties, where the type that it expects is not checked."""
    scene = bpy.context.scene
    scene.wirewarp.spacing = 2.0
    choices = ("method", "spacing", "fairness", "shown_map", "auto_update", "orientation")
    places = [(scene["wirewarp"], choices)]
    places += [(model, ("wirewarp_pieces", "wirewarp_active_piece"))]
    places += [(model.data, ("wirewarp_names", "wirewarp_grain"))]
    for owner, names in places:
        for name in names:
            if name in owner:  # for its type is kept
                del owner[name]
            owner[name] = value


def store_report(model, value, name="wirewarp_report"):
    model[name] = value


def new_object(name, data=None):
    """The object of this name, made if there is none."""
    if name not in bpy.data.objects:
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, data))
    return bpy.data.objects[name]


def other_model():
    return bpy.data.objects.get("Other") or grid("Other", bump, size=2)


def convert(target, kind):
    if target.type == "MESH":
        select_only(target)
        bpy.ops.object.convert(target=kind)


CASES = {
    "no number as tolerance": lambda model: fill_tolerances(model, NAN),
    "a negative tolerance": lambda model: fill_tolerances(model, -1.0),
    "a tolerance beyond all": lambda model: fill_tolerances(model, 1e30),
    "an ease that is no number": lambda model: fill(model.data, "wirewarp_ease", NAN),
    "an ease that leaves nothing": lambda model: fill(model.data, "wirewarp_ease", -1.0),
    "an infinite allowance": lambda model: fill(model.data, "wirewarp_allowance", math.inf),
    "wires without tolerances": lambda model: remove(model.data, "wirewarp_tolerance"),
    "tolerances without wires": lambda model: remove(model.data, "wirewarp_wire"),
    "names of any kind": lambda model: rename(model, 0),
    "names of any other kind": lambda model: rename(model, 4),
    "lists that are too long and double": lengthen_lists,
    "lists that are empty": clear_lists,
    "half a report": lambda model: store_report(model, '{"schema": "wirewarp-rep'),
    "a number as report": lambda model: store_report(model, 7),
    "a seal of another type": lambda model: store_report(model, [1.5, 2.5], "wirewarp_report_seal"),
    "pieces of an empty": lambda model: setattr(flat_of(model), "wirewarp_source", new_object("Empty")),
    "pieces of themselves": lambda model: setattr(flat_of(model), "wirewarp_source", flat_of(model)),
    "pieces of another model": lambda model: setattr(flat_of(model), "wirewarp_source", other_model()),
    "a model of its pieces": lambda model: setattr(model, "wirewarp_source", flat_of(model)),
    "an empty claims the model": lambda model: setattr(new_object("Empty"), "wirewarp_source", model),
    "pieces that are a curve": lambda model: convert(flat_of(model), "CURVE"),
    "a model that is a curve": lambda model: convert(model, "CURVE"),
    "pieces with the mesh of the model": lambda model: setattr(flat_of(model), "data", model.data),
    "a model with another mesh": lambda model: setattr(model, "data", other_model().data),
    "pieces with the mesh of another model": lambda model: setattr(flat_of(model), "data", other_model().data),
    "pieces without geometry": lambda model: flat_of(model).data.clear_geometry(),
    "pieces that are nowhere": lambda model: setattr(flat_of(model).data.vertices[0], "co", (NAN, NAN, NAN)),
    "a model in no scene": lambda model: [each.objects.unlink(model) for each in model.users_collection],
}


def add_cases(name, values, spoil):
    CASES.update({f"{name}: {value}": lambda model, value=value: spoil(model, value) for value in values})


add_cases("ids of the model", EXTREMES, fill_ids)
add_cases("ids of the pieces", EXTREMES, fill_flat_ids)
add_cases("stored", VALUES, store)
if bpy.app.version < (5, 0, 0):  # Blender 5 keeps what is below properties to itself
    add_cases("stored below properties", VALUES, store_below)
for attributes, owner in ((MODEL_ATTRIBUTES, lambda model: model), (FLAT_ATTRIBUTES, flat_of)):
    for attribute, (right_type, right_domain) in attributes.items():
        for kind in (("STRING", right_domain), (right_type, "POINT" if right_domain == "CORNER" else "CORNER")):
            CASES[f"{attribute} as {kind}"] = lambda model, attribute=attribute, kind=kind, owner=owner: retype(
                owner(model).data, attribute, *kind
            )
WORST = {
    "no number as tolerance",
    "names of any kind",
    "half a report",
    "a model with another mesh",
    f"ids of the pieces: {EXTREMES[-1]}",
    "wirewarp_wire as ('STRING', 'EDGE')",
}


@pytest.mark.parametrize("case", sorted(CASES.keys() - WORST))
def test_whatever_reads_it_answers(model, everything_answers, case):
    everything_answers(lambda: CASES[case](model), READERS)


@pytest.mark.api
@pytest.mark.parametrize("case", sorted(WORST))
def test_everything_answers(model, everything_answers, case):
    everything_answers(lambda: CASES[case](model), COMMANDS)


def test_the_worst_cases_are_cases():
    assert CASES.keys() >= WORST


def edited(**entries):
    """The report with other entries, for a stored text."""

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
        lambda _: "\udcff",  # a byte that is no character
        lambda _: 7,
        lambda _: [1, 2],
        lambda _: {"pieces": 3},
        edited(pieces=[]),
        edited(seams=[{"edges": [[0, 99]]}]),
        edited(schema="wirewarp-report-1"),
    ],
)
def test_a_report_that_another_hand_has_changed_is_not_believed(model, addon, edit):
    model["wirewarp_report"] = edit(model["wirewarp_report"])
    select_only(model)
    assert "from another version of WireWarp. Flatten again" in draw_panels(addon)


def test_a_tolerance_that_is_none_is_named_with_its_wire():
    model = grid("Bump", bump)
    mark(model, on_line(1, 0.0))
    fill(model.data, "wirewarp_tolerance", -0.5)
    assert 'Wire "Wire 1" has an invalid tolerance' in answer("object.wirewarp_flatten")
    assert "Bump Flat" not in bpy.data.objects


def test_a_flat_face_of_no_such_face_is_said(model):
    flat_of(model).data.attributes["source_face"].data[0].value = 1000
    select_only(model)
    said = answer("mesh.wirewarp_select_result", what="PIECE", index=0)
    assert '"Bump" has changed since it was flattened. Flatten it again' in said


@pytest.mark.skipif(bpy.app.version >= (5, 0, 0), reason="Blender 5 keeps what is below properties to itself")
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
