# SPDX-License-Identifier: GPL-3.0-or-later
"""Files edited by hand or by other scripts: everything answers with a result or a sentence, and nothing is lost."""

import json

import bpy
import pytest
from everything import answer, draw_panels
from surfaces import bump, flat_of, grid, on_line, select_only

NAN = float("nan")
SEAM, WIRE = on_line(0, 0.0), on_line(1, 0.0)


def change_type(mesh, name, data_type, domain):
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])
    mesh.attributes.new(name, data_type, domain)


KINDS = [("FLOAT_COLOR", "POINT"), ("INT", "CORNER"), ("STRING", "FACE")]
MODEL_ATTRIBUTES = ["wirewarp_wire", "wirewarp_tolerance", "wirewarp_piece"]
FLAT_ATTRIBUTES = ["piece", "source_vertex", "source_corner", "source_face", "flat_length", "stretch_color"]


@pytest.mark.parametrize("kind", KINDS)
def test_model_attributes_of_another_type_or_domain(model, everything_answers, kind):
    def spoil():
        for name in MODEL_ATTRIBUTES:
            change_type(model.data, name, *kind)

    everything_answers(spoil)


@pytest.mark.parametrize("kind", KINDS[:2])
@pytest.mark.parametrize("name", MODEL_ATTRIBUTES + FLAT_ATTRIBUTES)
def test_flat_attributes_of_another_type_or_domain(model, everything_answers, name, kind):
    everything_answers(lambda: change_type(flat_of(model).data, name, *kind))


@pytest.mark.parametrize("number", [-1, -(2**31), 2**31 - 1])
def test_flat_pieces_of_no_such_elements(model, everything_answers, number):
    def spoil():
        attributes = flat_of(model).data.attributes
        for name in ("piece", "source_vertex", "source_corner", "source_face", "wirewarp_piece", "wirewarp_wire"):
            values = attributes[name].data
            values.foreach_set("value", [number] * len(values))

    everything_answers(spoil)


def test_a_flat_face_of_no_such_face_is_said(model):
    flat_of(model).data.attributes["source_face"].data[0].value = 1000
    select_only(model)
    said = answer("mesh.wirewarp_select_result", what="PIECE", index=0)
    assert '"Bump" has changed since it was flattened. Flatten it again' in said


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
def test_a_report_that_another_hand_has_changed_is_not_believed(model, addon, everything_answers, edit):
    text = model["wirewarp_report"]

    def spoil():
        model["wirewarp_report"] = edit(text)
        select_only(model)
        assert "from another version of WireWarp. Flatten again" in draw_panels(addon)

    everything_answers(spoil)


def test_a_seal_of_another_type(model, everything_answers):
    def spoil():
        model["wirewarp_report_seal"] = [1.5, 2.5]

    everything_answers(spoil)


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


def point(owner, name, target):
    setattr(owner, name, target)


OBJECTS = {
    "pieces of an empty": lambda model: point(flat_of(model), "wirewarp_source", new_object("Empty")),
    "pieces of themselves": lambda model: point(flat_of(model), "wirewarp_source", flat_of(model)),
    "pieces of another model": lambda model: point(flat_of(model), "wirewarp_source", other_model()),
    "a model of its pieces": lambda model: point(model, "wirewarp_source", flat_of(model)),
    "an empty claims the model": lambda model: point(new_object("Empty"), "wirewarp_source", model),
    "pieces that are a curve": lambda model: convert(flat_of(model), "CURVE"),
    "a model that is a curve": lambda model: convert(model, "CURVE"),
    "pieces with the mesh of the model": lambda model: point(flat_of(model), "data", model.data),
    "a model with another mesh": lambda model: point(model, "data", other_model().data),
    "pieces with the mesh of another model": lambda model: point(flat_of(model), "data", other_model().data),
    "pieces without geometry": lambda model: flat_of(model).data.clear_geometry(),
    "pieces that are nowhere": lambda model: point(flat_of(model).data.vertices[0], "co", (NAN, NAN, NAN)),
    "a model in no scene": lambda model: [each.objects.unlink(model) for each in model.users_collection],
}


@pytest.mark.parametrize("what", OBJECTS)
def test_objects_that_are_not_what_they_were(model, everything_answers, what):
    everything_answers(lambda: OBJECTS[what](model))
