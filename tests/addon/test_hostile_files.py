# SPDX-License-Identifier: GPL-3.0-or-later
"""Files edited by hand or by other scripts: everything answers with a result or a sentence, and nothing is lost."""

import json

import bpy
import numpy as np
import pytest
from everything import answer, draw_panels, use_everything
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, read, select_only

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
    """With model and flat pieces active, in both modes, after spoiling the file anew for each.

    Also what Blender calls by itself answers: of that it prints the errors.
    """

    def check(spoil):
        for name in (source.name, flat_of(source).name):
            for mode in ("OBJECT", "EDIT"):
                spoil()
                bpy.context.view_layer.update()
                shape = read(source.data.vertices, "co", np.float32, 3)
                use_everything(addon, name, mode, tmp_path)
                assert np.array_equal(read(source.data.vertices, "co", np.float32, 3), shape, equal_nan=True)
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
