# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks are mesh attributes. They stay on their lines when the mesh is copied, joined and edited.

Attributes of another type with the name of a mark are refused.
"""

import math

import bpy
import pytest
from flattening import fails, wire_marks
from surfaces import bump, everywhere, flat_of, grid, mark, mark_seam, on_edges, on_line, select_edges, select_only
from view_context import marked_lines

pytestmark = pytest.mark.api

ALONG, ACROSS = on_line(1, 0.0), on_line(0, 0.0)
WHOLE = {0.05: pytest.approx(2), math.inf: pytest.approx(2)}  # lengths of wires, by tolerance


@pytest.fixture
def marked():
    """Return a flat grid with a seam, an elastic wire along y = 0 and a free wire along x = 0."""
    target = grid("Flat", lambda x, y: (x, y, 0.0))
    mark(target, ALONG, kind="ELASTIC", tolerance=0.05)
    mark(target, ACROSS, kind="SUPER_ELASTIC")
    mark_seam(target, on_line(0, 0.5))
    target.data.wirewarp_names[0].name = "Bust"
    return target


def saved(path, append=False):
    """Save the open file and close it. Return the object "Flat" of the saved file, opened or appended."""
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    if append:
        with bpy.data.libraries.load(str(path)) as (_, wanted):
            wanted.objects = ["Flat"]
    else:
        bpy.ops.wm.open_mainfile(filepath=str(path))
    return bpy.data.objects["Flat"]


def duplicated():
    bpy.ops.object.duplicate()
    return bpy.context.active_object


def joined_into_one_without_marks(marked):
    bare = grid("Bare", bump)
    select_only(bare, marked)
    bpy.ops.object.join()
    return bare


@pytest.mark.parametrize("how", ["saved", "appended", "duplicated", "joined"])
def test_marks_and_names_stay_with_the_mesh(marked, tmp_path, how):
    before, path = wire_marks(marked.data), tmp_path / "marked.blend"
    after = {
        "saved": lambda: saved(path),
        "appended": lambda: saved(path, append=True),
        "duplicated": duplicated,
        "joined": lambda: joined_into_one_without_marks(marked),
    }[how]()
    assert wire_marks(after.data) == before
    assert how in ("duplicated", "joined") or after.data.wirewarp_names[0].name == "Bust"


def test_join_keeps_the_wires_of_both_objects_and_their_names_are_saved(marked, addon, tmp_path):
    other, foreign = grid("Other", bump), grid("Foreign", bump)
    mark(other, on_line(1, 0.25))
    other.data.wirewarp_names[0].name = "Hip"
    foreign.data.attributes.new("wirewarp_wire", "FLOAT", "POINT")  # not a mark, because marks are integers on edges
    both = wire_marks(marked.data) | wire_marks(other.data)
    select_only(marked, other)
    bpy.ops.object.join()
    assert wire_marks(marked.data) == both
    names = [name for name, _ in addon.state.identities.listed_wires(saved(tmp_path / "joined.blend"))]
    assert names == ["Bust", "Wire 2", "Hip"]


def split_and_merge():
    bpy.ops.mesh.edge_split()
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.remove_doubles()


def to_triangles_and_back():
    bpy.ops.mesh.quads_convert_to_tris()
    bpy.ops.mesh.tris_convert_to_quads()


def between_two_columns(a, b):
    return abs(a.y - b.y) < 1e-6 and abs(a.x + b.x - 0.75) < 1e-6


EDITS = {  # the line to select, and the edit of the selection
    "subdivided": (everywhere, lambda: bpy.ops.mesh.subdivide(number_cuts=2)),
    "wire alone subdivided": (ALONG, lambda: bpy.ops.mesh.subdivide()),
    "loop cut": (between_two_columns, lambda: bpy.ops.mesh.subdivide_edgering(number_cuts=1)),
    "loop dissolved": (on_line(0, 0.5), lambda: bpy.ops.mesh.dissolve_edges()),
    "cut by a plane": (everywhere, lambda: bpy.ops.mesh.bisect(plane_co=(0.1, 0, 0), plane_no=(1, 0.3, 0))),
    "triangles": (everywhere, lambda: bpy.ops.mesh.quads_convert_to_tris()),
    "triangles and back": (everywhere, to_triangles_and_back),
    "split and merged": (ALONG, split_and_merge),
    "dissolved": (ALONG, lambda: bpy.ops.mesh.dissolve_edges()),
}


@pytest.mark.parametrize("how", EDITS)
def test_wires_stay_on_their_lines_as_the_mesh_is_edited(marked, how):
    line, edit = EDITS[how]
    on_edges(marked, edit, line)
    mesh, found = marked.data, {}
    for row, edge in enumerate(mesh.edges):
        a, b = (mesh.vertices[vertex].co for vertex in edge.vertices)
        if mesh.attributes["wirewarp_wire"].data[row].value:
            tolerance = round(mesh.attributes["wirewarp_tolerance"].data[row].value, 6)
            assert (ALONG if tolerance == 0.05 else ACROSS)(a, b)
            found[tolerance] = found.get(tolerance, 0) + (a - b).length
    assert found == (WHOLE if how != "dissolved" else {math.inf: pytest.approx(2)})


@pytest.mark.parametrize("use_modifiers", [False, True])
def test_a_copy_of_a_wire_has_the_name_of_its_original(addon, use_modifiers):
    source = grid("Half", lambda x, y: (x + 1, y, 0.2 * x * x))
    # The wire ends before the mirror plane, so its mirror image is another wire.
    mark(source, lambda a, b: ALONG(a, b) and min(a.x, b.x) > 0.4)
    source.modifiers.new("Other Half", "MIRROR")
    if not use_modifiers:
        bpy.ops.object.modifier_apply(modifier="Other Half")
    bpy.ops.object.wirewarp_flatten(use_modifiers=use_modifiers)
    source.data.wirewarp_names[0].name = "Hip"
    both = ["Hip", "Hip (2)"]
    assert [wire.name for wire in addon.state.reports.last_report(source).wires] == both
    assert sorted(name.texts[-1] for name in marked_lines(addon, flat_of(source)).names) == ["Half", *both]
    parts = addon.export.read.read_pattern(bpy.context.scene, source)
    assert [wire.name for piece in parts.pieces for wire in piece.wires] == both


@pytest.mark.parametrize(
    ("name", "kind", "command"),
    [
        ("wirewarp_wire", "INT on edges", {"mark": {}}),
        ("wirewarp_allowance", "FLOAT on edges", {"allowance": {"kind": "WIDTH"}}),
        ("wirewarp_ease", "FLOAT on edges", {"ease": {"sides": "ALL"}}),
        ("wirewarp_side_ease", "FLOAT on face corners", {"ease": {"sides": "ONE"}}),
        ("wirewarp_side_ratio", "FLOAT on edges", {"ease": {"sides": "ONE"}}),
        ("wirewarp_eased_side", "INT on edges", {"ease": {"sides": "ONE"}}),
        ("wirewarp_piece", "INT on faces", {}),
    ],
)
def test_a_foreign_attribute_with_our_name_is_refused(name, kind, command):
    source = grid("Bump", bump)
    source.data.attributes.new(name, "FLOAT_VECTOR", "POINT")
    expected = f'attribute "{name}" of mesh "Bump" is not of type {kind}'
    if name != "wirewarp_allowance":  # Flatten ignores an allowance attribute of another type.
        fails(bpy.ops.object.wirewarp_flatten, expected)
    select_edges(source, on_line(0, -1.0))
    for operator, settings in command.items():
        with pytest.raises(RuntimeError, match=expected):
            getattr(bpy.ops.mesh, f"wirewarp_{operator}")(**settings)
    assert source.mode == "EDIT" and "Bump Flat" not in bpy.data.objects
