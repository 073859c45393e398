# SPDX-License-Identifier: GPL-3.0-or-later
"""Sewing edges join the copies of a vertex of the model, and the shape key folds the pieces onto the model."""

import bpy
import numpy as np
import pytest
from flattening import edge_vertices, fails, flatten_fails
from surfaces import bump, flat_of, grid, mark, mark_seam, on_line, read, select_only
from two_sided import ease

pytestmark = pytest.mark.api

SEAM = on_line(0, 0.0)


def sewing_of(source):
    assert bpy.ops.object.wirewarp_sewing() == {"FINISHED"}
    return bpy.data.objects[f"{source.name} Sewing"]


@pytest.fixture
def source():
    """Return a flattened model of two pieces. The right piece has a dart."""
    target = grid("Bump", bump, seam=SEAM)
    mark_seam(target, lambda a, b: on_line(1, 0.0)(a, b) and a.x + b.x > 0 and max(a.x, b.x) < 0.8)
    mark(target, on_line(1, 0.5))
    ease(target, on_line(1, 0.5), sides="ALL", ease_percent=2.0)
    ease(target, SEAM, sides="ONE", ease_percent=3.0)
    target.rotation_euler, target.location, target.scale = (0.3, 0.2, 0.1), (1, 2, 3), (2, 2, 2)
    bpy.context.view_layer.update()
    select_only(target)
    bpy.ops.object.wirewarp_flatten()
    return target


def loose_edges(target):
    edges = edge_vertices(target.data)
    of_faces = {tuple(sorted(key)) for polygon in target.data.polygons for key in polygon.edge_keys}
    return np.array([edge for edge in edges.tolist() if tuple(sorted(edge)) not in of_faces])


def evaluated(target):
    return target.evaluated_get(bpy.context.evaluated_depsgraph_get())


def test_sewing_edges_join_equal_vertices_and_a_shape_key_folds_the_pieces(source):
    numbers = read(flat_of(source).data.attributes["source_vertex"].data, "value", np.int32)
    target = sewing_of(source)
    joined = loose_edges(target)
    assert np.array_equal(numbers[joined[:, 0]], numbers[joined[:, 1]])
    copies = np.bincount(numbers)
    assert set(numbers[joined[:, 0]].tolist()) == set(np.flatnonzero(copies > 1).tolist())
    # At the opening of the dart, three vertices are joined by three edges instead of two.
    assert len(joined) == (copies[copies > 1] - 1).sum() + 1
    assert len(edge_vertices(target.data)) == len(edge_vertices(flat_of(source).data)) + len(joined)
    target.data.shape_keys.key_blocks["On the Model"].value = 1.0
    bpy.context.view_layer.update()
    worn = np.array([target.matrix_world @ vertex.co for vertex in evaluated(target).data.vertices])
    places = np.array([source.matrix_world @ vertex.co for vertex in source.data.vertices])
    assert worn == pytest.approx(places[numbers], abs=1e-5)


def test_a_cloth_simulation_sews_the_pieces_together(source):
    target = sewing_of(source)
    modifier = target.modifiers.new("Cloth", "CLOTH")
    modifier.settings.use_sewing_springs = True
    modifier.settings.effector_weights.gravity = 0.0
    joined = loose_edges(target)

    def gaps():
        places = read(evaluated(target).data.vertices, "co", np.float32, 3)
        return np.linalg.norm(places[joined[:, 0]] - places[joined[:, 1]], axis=1)

    before = gaps()
    for frame in range(1, 41):
        bpy.context.scene.frame_set(frame)
    assert gaps().max() < 0.05 * before.mean()


def test_the_copy_is_not_a_flat_object_and_has_no_marks(source, addon):
    target = sewing_of(source)
    assert target.users_collection == flat_of(source).users_collection
    names = [attribute.name for attribute in target.data.attributes]
    assert [name for name in names if "wirewarp" in name or name.startswith("source")] == []
    assert not addon.overlay.shown.concerns_us(target)
    source.name = "Bump" * 100  # Blender shortens this name.
    select_only(source)
    bpy.ops.object.wirewarp_sewing()
    assert bpy.context.active_object.name.endswith(" Sewing")


def test_sewing_edges_are_refused_without_pieces():
    source = grid("Bump", bump)
    fails(bpy.ops.object.wirewarp_sewing, '"Bump" has no flat pieces')
    assert "Bump Sewing" not in bpy.data.objects and source.name == "Bump"


def hide_collection(flat):
    bpy.context.view_layer.layer_collection.children[flat.users_collection[0].name].exclude = True


def move_to_another_scene(flat):
    for collection in flat.users_collection:
        collection.objects.unlink(flat)
    bpy.data.scenes.new("Other").collection.objects.link(flat)


@pytest.mark.parametrize("put_away", [hide_collection, move_to_another_scene])
def test_the_copy_is_visible_although_the_pieces_are_hidden(source, put_away):
    select_only(source)
    put_away(flat_of(source))
    target = sewing_of(source)
    assert bpy.context.view_layer.objects.active == target and target.visible_get()


def test_seams_of_a_piece_without_a_layout_are_ignored():
    """With one seam, a torus is a tube, which has no flat shape."""
    source = grid("Bump", bump)
    bpy.ops.mesh.primitive_torus_add(location=(4, 0, 0), major_segments=12, minor_segments=8)
    select_only(source, bpy.context.object)
    bpy.ops.object.join()
    mark_seam(source, SEAM)
    mark_seam(source, lambda a, b: on_line(1, 0.0)(a, b) and min(a.x, b.x) > 4)
    flatten_fails("mark a seam")
    assert len(loose_edges(sewing_of(source))) == 9  # along the seam of the two good pieces
