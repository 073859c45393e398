# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a model of two pieces, selects the sides of its seam, and measures its lines."""

import bmesh
import bpy
import numpy as np
from flattening import edge_vertices, flat_sources
from surfaces import bump, flat_of, grid, on_edges, on_line, read, select_only

SEAM, HEM = on_line(0, 0.0), on_line(1, -1.0)


def two_pieces():
    """Return a model with pieces to the left and right of a seam. A Blender unit is 100 mm."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    return grid("Bump", bump, seam=SEAM)


def join_split_and_flip(source):
    """Join another mesh, split edges and flip all faces. Marks survive these edits."""
    other = grid("Other", lambda x, y: (x + 3, y, 0))
    select_only(source, other)
    bpy.ops.object.join()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=2)
    bpy.ops.mesh.flip_normals()
    bpy.ops.object.mode_set(mode="OBJECT")


def ease(target, line, **settings):
    assert on_edges(target, bpy.ops.mesh.wirewarp_ease, line, **settings) == {"FINISHED"}


def lengths(source, line):
    """Return the lengths of a line on the model, on the left piece, and on the right piece."""
    flat = flat_of(source).data
    model = read(source.data.vertices, "co", np.float32, 3).astype(float)
    sources = flat_sources(source)
    pieces = np.empty(len(flat.vertices), dtype=int)
    faces = read(flat.attributes["source_face"].data, "value", np.int32)
    for polygon, face in zip(flat.polygons, faces, strict=True):
        pieces[list(polygon.vertices)] = source.data.polygons[face].center.x > 0
    flat_places = read(flat.vertices, "co", np.float32, 3).astype(float)
    found = [0.0, 0.0]
    for a, b in edge_vertices(flat):
        if line(model[sources[a]], model[sources[b]]):
            found[pieces[a]] += float(np.linalg.norm(flat_places[a] - flat_places[b]))
    spatial = [np.linalg.norm(model[a] - model[b]) for a, b in edge_vertices(source.data) if line(model[a], model[b])]
    return float(sum(spatial)), *found


def shares(source, line=SEAM):
    """Return by which fraction the left and the right side of a seam are longer than the line on the model."""
    spatial, left, right = lengths(source, line)
    return [left / spatial - 1, right / spatial - 1]


def select_side(source, side, line=SEAM):
    """Enter Edit Mode of the pieces. Select the left side (-1), the right side (1) or both sides (0) of a line."""
    flat = flat_of(source)
    model = read(source.data.vertices, "co", np.float32, 3)
    sources = flat_sources(source)
    faces = read(flat.data.attributes["source_face"].data, "value", np.int32)
    select_only(flat)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    edit = bmesh.from_edit_mesh(flat.data)
    for edge in edit.edges:
        on_side = source.data.polygons[faces[edge.link_faces[0].index]].center.x * side >= 0
        edge.select_set(bool(on_side and line(*(model[sources[vertex.index]] for vertex in edge.verts))))
    bmesh.update_edit_mesh(flat.data)


def widths_at_seam(addon, source):
    """Return the pattern's allowances on the left and the right side of the seam in millimeters. A fold has 0."""
    parts = addon.export.read.read_pattern(bpy.context.scene, source)
    pieces = {piece.name: piece for piece in made(addon, parts).pieces}
    sides = [line for name in ("Top Right", "Top Left") for line in pieces[name].of_role("sew", "fold")]
    return [line.width for line in sides if line.seam is not None]


def made(addon, parts, allowance=10.0):
    choices = {"allowance": allowance, "notch_spacing": 100.0, "darts": "close"}
    return addon.solve.steps.in_one_go(parts.making(choices))
