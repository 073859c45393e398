# SPDX-License-Identifier: GPL-3.0-or-later
"""Files edited by hand or by other scripts: everything answers with a result or a sentence, and nothing is lost."""

import itertools
import json

import bpy
import numpy as np
import pytest
from everything import answer, draw_panels, use_everything
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, read, select_only

NAN = float("nan")
SEAM, WIRE = on_line(0, 0.0), on_line(1, 0.0)


@pytest.fixture
def source():
    """Two good pieces with a wire that ends inside one, which gets a helper wire, and a closed piece that fails."""
    target = grid("Bump", bump, size=4)
    bpy.ops.mesh.primitive_cube_add(location=(4, 0, 0))
    closed = bpy.context.object
    select_only(target, closed)
    bpy.ops.object.join()
    mark_seam(target, SEAM)
    mark(target, lambda a, b: WIRE(a, b) and max(a[0], b[0]) < 0.6, kind="ELASTIC", tolerance=0.05)
    with pytest.raises(RuntimeError, match="is closed"):
        bpy.ops.object.wirewarp_flatten(method="WIREWARP_PLUS_PLUS")
    return target


@pytest.fixture
def everything_answers(source, addon, tmp_path, capfd):
    """With each object active, in both modes, after spoiling the file anew for each; no model loses its shape.

    Also what Blender calls by itself answers: of that it prints the errors.
    """

    def shapes():
        models = [bpy.data.objects[name] for name in ("Bump", "Other") if name in bpy.data.objects]
        return [read(model.data.vertices, "co", np.float32, 3) for model in models if model.type == "MESH"]

    def check(spoil):
        spoil()
        names = [each.name for each in bpy.context.scene.objects if each.type != "FONT"]
        for name, mode in itertools.product(names, ("OBJECT", "EDIT")):
            spoil()
            bpy.context.view_layer.update()
            before = shapes()
            use_everything(addon, name, mode, tmp_path)
            for shape, after in zip(before, shapes(), strict=True):
                assert np.array_equal(shape, after, equal_nan=True)
        printed = capfd.readouterr()
        assert "Traceback" not in printed.out + printed.err

    return check


def change_type(mesh, name, data_type, domain):
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])
    mesh.attributes.new(name, data_type, domain)


KINDS = [("FLOAT_COLOR", "POINT"), ("INT", "CORNER"), ("STRING", "FACE")]
MODEL_ATTRIBUTES = ["wirewarp_wire", "wirewarp_tolerance", "wirewarp_piece"]
FLAT_ATTRIBUTES = ["piece", "source_vertex", "source_corner", "source_face", "flat_length", "stretch_color"]


@pytest.mark.parametrize("kind", KINDS)
def test_model_attributes_of_another_type_or_domain(source, everything_answers, kind):
    def spoil():
        for name in MODEL_ATTRIBUTES:
            change_type(source.data, name, *kind)

    everything_answers(spoil)


@pytest.mark.parametrize("kind", KINDS[:2])
@pytest.mark.parametrize("name", MODEL_ATTRIBUTES + FLAT_ATTRIBUTES)
def test_flat_attributes_of_another_type_or_domain(source, everything_answers, name, kind):
    everything_answers(lambda: change_type(flat_of(source).data, name, *kind))


@pytest.mark.parametrize("number", [-1, -(2**31), 2**31 - 1])
def test_flat_pieces_of_no_such_elements(source, everything_answers, number):
    def spoil():
        attributes = flat_of(source).data.attributes
        for name in ("piece", "source_vertex", "source_corner", "source_face", "wirewarp_piece", "wirewarp_wire"):
            values = attributes[name].data
            values.foreach_set("value", [number] * len(values))

    everything_answers(spoil)


def test_a_flat_face_of_no_such_face_is_said(source):
    flat_of(source).data.attributes["source_face"].data[0].value = 1000
    select_only(source)
    said = answer("mesh.wirewarp_select_result", what="PIECE", index=0)
    assert '"Bump" has changed since it was flattened: flatten it again' in said


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
        lambda _: '{"schema": "wirewarp-report-2"}',
        lambda _: "\udcff",  # a byte that is no character
        lambda _: 7,
        lambda _: [1, 2],
        lambda _: {"pieces": 3},
        edited(pieces=[]),
        edited(seams=[{"edges": [[0, 99]]}]),
        edited(schema="wirewarp-report-1"),
    ],
)
def test_a_report_that_another_hand_has_changed_is_not_believed(source, addon, everything_answers, edit):
    text = source["wirewarp_report"]

    def spoil():
        source["wirewarp_report"] = edit(text)
        select_only(source)
        assert "not one of this version of WireWarp: flatten again" in draw_panels(addon)

    everything_answers(spoil)


def test_a_seal_of_another_type(source, everything_answers):
    def spoil():
        source["wirewarp_report_seal"] = [1.5, 2.5]

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
    "pieces of an empty": lambda source: point(flat_of(source), "wirewarp_source", new_object("Empty")),
    "pieces of themselves": lambda source: point(flat_of(source), "wirewarp_source", flat_of(source)),
    "pieces of another model": lambda source: point(flat_of(source), "wirewarp_source", other_model()),
    "a model of its pieces": lambda source: point(source, "wirewarp_source", flat_of(source)),
    "an empty claims the model": lambda source: point(new_object("Empty"), "wirewarp_source", source),
    "an empty claims the helper wires": lambda source: point(new_object("Empty"), "wirewarp_helpers_of", source),
    "a surface claims to be helper wires": lambda source: point(other_model(), "wirewarp_helpers_of", source),
    "a model claims to be its own helper wires": lambda source: point(source, "wirewarp_helpers_of", source),
    "pieces that are a curve": lambda source: convert(flat_of(source), "CURVE"),
    "a model that is a curve": lambda source: convert(source, "CURVE"),
    "pieces with the mesh of the model": lambda source: point(flat_of(source), "data", source.data),
    "a model with another mesh": lambda source: point(source, "data", other_model().data),
    "pieces with the mesh of another model": lambda source: point(flat_of(source), "data", other_model().data),
    "pieces without geometry": lambda source: flat_of(source).data.clear_geometry(),
    "pieces that are nowhere": lambda source: point(flat_of(source).data.vertices[0], "co", (NAN, NAN, NAN)),
    "a model in no scene": lambda source: [each.objects.unlink(source) for each in source.users_collection],
}


@pytest.mark.parametrize("what", OBJECTS)
def test_objects_that_are_not_what_they_were(source, everything_answers, what):
    everything_answers(lambda: OBJECTS[what](source))
