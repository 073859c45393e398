# SPDX-License-Identifier: GPL-3.0-or-later
"""Searches for cuts, and checks models on which cuts were marked."""

import bpy
import numpy as np
import pytest
from flattening import report_after
from surfaces import read

SIMPLIFY = bpy.ops.object.wirewarp_simplify_seams
SUGGEST = {"DARTS": bpy.ops.object.wirewarp_suggest_darts, "SEAMS": bpy.ops.object.wirewarp_suggest_seams}


def found(addon, source):
    return addon.state.suggestions.current_suggestions(source)


def suggested(addon, source, kind, lines=None, **search):
    """Search for cuts, and return the suggestions. lines: "SMOOTH" or "EDGES", or None for the present setting."""
    if lines:
        bpy.context.scene.wirewarp.dart_lines = lines
    assert SUGGEST[kind](**search) == {"FINISHED"}
    return found(addon, source)


def choose_smooth(addon, source, kind):
    """Suggest cuts, and choose and return the first cut that crosses faces."""
    cuts = suggested(addon, source, kind).cuts
    index = next(index for index, cut in enumerate(cuts) if not cut.edges)
    bpy.ops.object.wirewarp_choose_suggestion(index=index)
    return cuts[index]


def cancel_at(addon, run, share):
    """Cancel a search when its progress has reached `share`. Return its result and all reported shares."""
    shares = [next(run)]
    while shares[-1] < share:
        shares.append(next(run))
    try:
        shares.append(run.throw(addon.solve.steps.CanceledError()))
        while True:
            shares.append(next(run))
    except StopIteration as end:
        return end.value, shares


def bent_ring(around=20, across=8):
    """Return a closed model of quads, without symmetry, for which several smooth sets of seams are found."""
    bpy.ops.mesh.primitive_torus_add(major_segments=around, minor_segments=across, major_radius=1, minor_radius=0.5)
    source = bpy.context.object
    x, y, z = read(source.data.vertices, "co", np.float32, 3).astype(float).T
    places = np.column_stack([x, 0.8 * y, 1.4 * z]) * (1 + 0.2 * x + 0.1 * y)[:, None]
    source.data.vertices.foreach_set("co", places.astype(np.float32).ravel())
    source.data.update()
    return source


def pairs(edges):
    return {(min(edge), max(edge)) for edge in np.asarray(edges).tolist()}


def needed(addon, source):
    """Flatten the model, and return the maximum stretch of its worst piece."""
    return max(piece.needed for piece in report_after(addon, source).pieces)


def are_mirrored(source, edges):
    """Return whether the mirror image of the edges across x = 0 is the same set of edges."""
    middles = read(source.data.vertices, "co", np.float32, 3)[np.array(edges)].mean(axis=1).round(4)
    return {tuple(middle) for middle in middles.tolist()} == {(-x, y, z) for x, y, z in middles.tolist()}


def places(source):
    return read(source.data.vertices, "co", np.float32, 3).astype(float)


def add_layers(source):
    """Add a UV map, a vertex group, materials and shape keys for check_layers().

    UV map, materials and shape keys depend on the place of each element. The group has the weight 0.5 everywhere.
    """
    mesh = source.data
    corners = places(source)[read(mesh.loops, "vertex_index", np.int32)]
    mesh.uv_layers.new(name="Mine").data.foreach_set("uv", corners[:, :2].astype(np.float32).ravel())
    source.vertex_groups.new(name="All").add(range(len(mesh.vertices)), 0.5, "REPLACE")
    for name in "Red", "Blue":
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", [face.center.x > 0 for face in mesh.polygons])
    source.shape_key_add(name="Basis")
    twice = source.shape_key_add(name="Twice")
    twice.value = 0.0  # Blender 5 creates keys with the value 1
    twice.data.foreach_set("co", (2 * places(source)).astype(np.float32).ravel())


def check_layers(source):
    """Check that vertices and faces, including new ones, have the values of add_layers() for their places."""
    mesh = source.data
    now = places(source)[read(mesh.loops, "vertex_index", np.int32)]
    assert read(mesh.uv_layers["Mine"].data, "uv", np.float32, 2) == pytest.approx(now[:, :2], abs=1e-6)
    assert all(source.vertex_groups["All"].weight(vertex.index) == 0.5 for vertex in mesh.vertices)
    assert [face.material_index for face in mesh.polygons] == [face.center.x > 0 for face in mesh.polygons]
    twice = read(mesh.shape_keys.key_blocks["Twice"].data, "co", np.float32, 3)
    assert twice == pytest.approx(2 * places(source), abs=1e-6)
