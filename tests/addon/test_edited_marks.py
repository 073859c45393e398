# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh is edited after it was marked: wires stay on their lines as far as Blender carries edge attributes."""

import math

import bpy
import pytest
from surfaces import grid, mark, on_line, select_edges, wire_marks

pytestmark = pytest.mark.api

ALONG, ACROSS = on_line(1, 0.0), on_line(0, 0.0)
WHOLE = {0.05: pytest.approx(2), math.inf: pytest.approx(2)}  # tolerance to length


@pytest.fixture
def marked():
    """A flat grid with an elastic wire along y = 0 and a free one across it."""
    target = grid("Flat", lambda x, y: (x, y, 0.0))
    mark(target, ALONG, kind="ELASTIC", tolerance=0.05)
    mark(target, ACROSS, kind="SUPER_ELASTIC")
    return target


def edit(target, operator, line=lambda *_: True, **settings):
    select_edges(target, line)
    operator(**settings)
    bpy.ops.object.mode_set(mode="OBJECT")
    return lengths(target)


def lengths(target):
    """Tolerance to length, none of it off the lines."""
    mesh, found = target.data, {}
    for row, edge in enumerate(mesh.edges):
        a, b = (mesh.vertices[vertex].co for vertex in edge.vertices)
        if mesh.attributes["wirewarp_wire"].data[row].value:
            tolerance = round(mesh.attributes["wirewarp_tolerance"].data[row].value, 6)
            assert (ALONG if tolerance == 0.05 else ACROSS)(a, b)
            found[tolerance] = found.get(tolerance, 0) + (a - b).length
    return found


def test_subdivide(marked):
    assert edit(marked, bpy.ops.mesh.subdivide, number_cuts=2) == WHOLE


def test_subdivide_the_wire_alone(marked):
    assert edit(marked, bpy.ops.mesh.subdivide, ALONG) == WHOLE


def test_an_edge_loop_is_cut_across(marked):
    between = lambda a, b: abs(a.y - b.y) < 1e-6 and abs(a.x + b.x - 0.75) < 1e-6  # noqa: E731
    assert edit(marked, bpy.ops.mesh.subdivide_edgering, between, number_cuts=1) == WHOLE


def test_an_edge_loop_across_is_dissolved(marked):
    assert edit(marked, bpy.ops.mesh.dissolve_edges, on_line(0, 0.5)) == WHOLE


def test_cut_by_a_plane(marked):
    assert edit(marked, bpy.ops.mesh.bisect, plane_co=(0.1, 0, 0), plane_no=(1, 0.3, 0)) == WHOLE


def test_triangles_and_back(marked):
    assert edit(marked, bpy.ops.mesh.quads_convert_to_tris) == WHOLE
    assert edit(marked, lambda: (bpy.ops.mesh.quads_convert_to_tris(), bpy.ops.mesh.tris_convert_to_quads())) == (WHOLE)


def test_split_and_merged_again(marked):
    def split_and_merge():
        bpy.ops.mesh.edge_split()
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.remove_doubles()

    assert edit(marked, split_and_merge, ALONG) == WHOLE


def test_dissolving_the_wire_itself_takes_only_that_wire(marked):
    assert edit(marked, bpy.ops.mesh.dissolve_edges, ALONG) == {math.inf: pytest.approx(2)}


@pytest.mark.parametrize(("levels", "kind"), [(2, "SIMPLE"), (1, "CATMULL_CLARK")])
def test_subdivision_is_applied(marked, levels, kind):
    before = wire_marks(marked.data)
    modifier = marked.modifiers.new("Smooth", "SUBSURF")
    modifier.levels, modifier.subdivision_type = levels, kind
    bpy.ops.object.modifier_apply(modifier="Smooth")
    assert wire_marks(marked.data) == {key: 2**levels * count for key, count in before.items()}


def test_a_mirror_is_applied_and_the_copies_are_wires_of_their_own(marked, addon):
    marked.location.x = 3
    modifier = marked.modifiers.new("Mirror", "MIRROR")
    modifier.mirror_object = bpy.data.objects.new("Middle", None)
    bpy.ops.object.modifier_apply(modifier="Mirror")
    names = [name for name, _ in addon.state.identities.listed_wires(marked)]
    assert names == ["Wire 1", "Wire 1 (2)", "Wire 2", "Wire 2 (2)"]
