# SPDX-License-Identifier: GPL-3.0-or-later
"""What is read from a mesh the fast way is what Blender says element by element."""

import bpy
import numpy as np
import pytest
from surfaces import grid, mark_seam, on_line, read, round_bump

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
def mesh(request):
    target = grid("Bump", round_bump, faces="ngons")
    mark_seam(target, on_line(0, 0.0))
    if request.param == "EDIT":
        bpy.ops.object.mode_set(mode="EDIT")
        target.update_from_editmode()
    elif request.param == "no faces":
        target.data.clear_geometry()
        target.data.from_pydata([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1), (1, 2)], [])
        target.data.edges[1].use_seam = True
    elif request.param == "nothing":
        target.data.clear_geometry()
    target.data.calc_loop_triangles()
    return target.data


@pytest.mark.parametrize("name", READERS)
def test_indices(addon, mesh, name):
    elements, field, columns = READERS[name]
    found = getattr(addon.blender.mesh, name)(mesh)
    expected = read(getattr(mesh, elements), field, np.int32, columns)
    assert found.dtype == np.int32
    assert np.array_equal(found, expected)


def test_seams(addon, mesh):
    assert np.array_equal(addon.blender.mesh.read_seams(mesh), [edge.use_seam for edge in mesh.edges])
