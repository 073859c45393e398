# SPDX-License-Identifier: GPL-3.0-or-later
"""Fast reading of a mesh returns the same data as reading it from Blender element by element."""

from types import SimpleNamespace

import bmesh
import bpy
import numpy as np
import pytest
from surfaces import grid, make_object, on_line, read, round_bump, select_edges

pytestmark = pytest.mark.api

READERS = {
    "edge_vertices": ("edges", "vertices", 2),
    "corner_vertices": ("loops", "vertex_index", 1),
    "corner_edges": ("loops", "edge_index", 1),
    "face_starts": ("polygons", "loop_start", 1),
    "face_sizes": ("polygons", "loop_total", 1),
    "triangle_corners": ("loop_triangles", "loops", 3),
    "triangle_vertices": ("loop_triangles", "vertices", 3),
    "triangle_faces": ("loop_triangles", "polygon_index", 1),
}


@pytest.fixture(params=["OBJECT", "EDIT", "no faces", "nothing"])
def mesh(addon, request):
    """Yield the current mesh. In Edit Mode, it has changes that the mesh of the object does not have yet."""
    target = grid("Bump", round_bump, faces="ngons", seam=on_line(0, 0.0))
    if request.param == "EDIT":
        select_edges(target, on_line(1, 0.0))
        bpy.ops.mesh.mark_seam()
        bpy.ops.mesh.hide()
        select_edges(target, on_line(1, 0.25))
        edit = bmesh.from_edit_mesh(target.data)
        edit.verts.ensure_lookup_table()
        edit.verts[3].co.z = 7.0
    elif request.param == "no faces":
        target.data.clear_geometry()
        target.data.from_pydata([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1), (1, 2)], [])
        target.data.edges[1].use_seam = True
    elif request.param == "nothing":
        target.data.clear_geometry()
    with addon.blender.mesh.current_mesh(target) as current:
        current.calc_loop_triangles()
        yield current


def test_all_data_is_read(addon, mesh):
    for name, (elements, field, columns) in READERS.items():
        found = getattr(addon.blender.mesh, name)(mesh)
        assert found.dtype == np.int32, name
        assert np.array_equal(found, read(getattr(mesh, elements), field, np.int32, columns)), name
    places = addon.blender.mesh.vertex_places(mesh)
    assert places.dtype == np.float32
    assert places.tolist() == [list(vertex.co) for vertex in mesh.vertices]
    for name, field in (("read_seams", "use_seam"), ("read_selected_edges", "select"), ("read_hidden_edges", "hide")):
        found = getattr(addon.blender.mesh, name)(mesh)
        assert found.tolist() == [getattr(edge, field) for edge in mesh.edges], name


def test_in_edit_mode_the_current_mesh_has_all_edits(addon):
    target = grid("Bump", round_bump, wire=on_line(0, 0.0))
    select_edges(target, on_line(1, 0.0))
    bpy.ops.mesh.mark_seam()
    bpy.ops.mesh.wirewarp_mark()
    edit = bmesh.from_edit_mesh(target.data)
    edit.verts.ensure_lookup_table()
    edit.verts[3].co.z = 7.0
    with addon.blender.mesh.current_mesh(target) as mesh:
        assert mesh.vertices[3].co.z == 7.0
        seams, marks = addon.blender.mesh.read_seams(mesh), addon.state.marked_mesh.read_marks(mesh)
    assert seams.tolist() == [edge.seam for edge in edit.edges]
    assert seams.sum() == 8
    assert marks.are_wires.sum() == 16
    assert not target.data.attributes["wirewarp_wire"].data  # In Edit Mode, only current_mesh() has the values.


def test_a_run_in_edit_mode_copies_the_mesh_once_to_read_it_and_once_to_check_it(addon, monkeypatch):
    target, settings = grid("Bump", round_bump), bpy.context.scene.wirewarp
    select_edges(target, on_line(0, 0.0))
    bpy.ops.mesh.mark_seam()
    copied = []

    def counting(mesh):
        copied.append(mesh.name)
        return bmesh.from_edit_mesh(mesh)

    monkeypatch.setattr(addon.blender.mesh, "bmesh", SimpleNamespace(from_edit_mesh=counting))
    reading = addon.flatten.read
    models = reading.read_models(bpy.context, [target], settings)
    assert models[0].issue is None and len(models[0].arrays.seam_edges) == 8
    assert copied == [target.data.name]
    reading.check_current(bpy.context, models, settings)
    assert copied == [target.data.name] * 2
    edit = bmesh.from_edit_mesh(target.data)
    edit.verts.ensure_lookup_table()
    edit.verts[0].co.z += 1
    with pytest.raises(addon.issues.ObjectError, match="changed during the run"):
        reading.check_current(bpy.context, models, settings)
    with addon.blender.mesh.current_mesh(target) as mesh:
        assert mesh.vertices[0].co.z == edit.verts[0].co.z


def test_shape_keys_outlive_reading_in_edit_mode(addon):
    """The copy for reading and the mesh have the same shape keys. These must stay when the copy is removed."""
    target = grid("Bump", round_bump)
    target.shape_key_add(name="Basis")
    target.shape_key_add(name="Taller").data[40].co.z += 1
    expected = target.data.shape_keys.key_blocks["Taller"].data[40].co.z + 0.5
    bpy.ops.object.mode_set(mode="EDIT")
    edit = bmesh.from_edit_mesh(target.data)
    edit.verts.ensure_lookup_table()
    for step in (1.0, -0.5):
        edit.verts[40].co.z += step
        with addon.blender.mesh.current_mesh(target) as mesh:
            assert mesh.vertices[40].co.z == edit.verts[40].co.z
    bpy.ops.object.mode_set(mode="OBJECT")
    assert target.data.shape_keys.key_blocks["Taller"].data[40].co.z == pytest.approx(expected)


def test_kept_normals_do_not_change_how_bent_quads_are_split(addon):
    """If Blender 3.4 has stored the normals of these quads, it splits a fifth of them along the other diagonal."""
    bent = np.random.default_rng(0).normal(scale=0.6, size=(200, 4, 3))
    corners = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)] + bent).reshape(-1, 3).tolist()
    quads = np.arange(len(corners)).reshape(-1, 4).tolist()

    def triangles(name, keeps_normals):
        source = make_object(name, corners, quads)
        if keeps_normals and hasattr(source.data, "calc_normals"):  # Later versions of Blender keep no normals.
            source.data.calc_normals()
            assert len(source.data.polygon_normals) == len(quads)
        marked = addon.state.marked_mesh.marked_mesh(source)
        return addon.state.read_model.object_to_arrays(source, marked, None).triangles

    assert np.array_equal(triangles("Fresh", False), triangles("Kept", True))
