# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes arrays of the data that the overlay shows for an object, from the displayed mesh or from the UV map."""

from contextlib import AbstractContextManager
from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..blender.mesh import (
    corner_edges,
    corner_vertices,
    current_mesh,
    edge_vertices,
    evaluated_mesh,
    faces_at_edges,
    faces_of_corners,
    next_loops,
    read,
    read_hidden_edges,
    read_seams,
    read_selected_edges,
    read_uv,
    triangle_corners,
    triangle_faces,
    triangle_vertices,
    vertex_places,
)
from ..names import PIECE, PIECE_INDEX, SEAM, SOURCE_VERTEX, UV_LAYER
from ..solve.maps import NO_LAYOUT
from ..state.allowances import SIDE_EASES, corner_widths
from ..state.marked_mesh import read_ids, read_marks
from .lines import LineEdges, SideEases


@dataclass(frozen=True)
class Triangles:
    positions: np.ndarray  # (n,3) float32, places of the vertices
    vertices: np.ndarray  # (m,3) int32, vertices of each triangle
    corners: np.ndarray  # (m,3) int32, corners of the mesh at the corners of each triangle
    polygons: np.ndarray  # (m,) int32, face that contains each triangle


@dataclass(frozen=True)
class ColoredTriangles:
    places: np.ndarray  # (3m,3) float32
    colors: np.ndarray  # (3m,4) float32, sRGB, as on the screen
    highest: float | None  # the largest value of the map, which may be beyond the color scale; None if unknown


def colored(triangles: Triangles, corner_colors: np.ndarray, highest: float | None) -> ColoredTriangles:
    """Return the triangles with the colors of their corners. corner_colors (l,4): linear RGBA; highest: see
    ColoredTriangles."""
    colors = screen_colors(corner_colors)[triangles.corners.ravel()]
    return ColoredTriangles(triangles.positions[triangles.vertices.ravel()], np.ascontiguousarray(colors), highest)


def on_model(flat_colors: np.ndarray, source_corner: np.ndarray, count: int) -> np.ndarray:
    """Return the colors (count,4) at the model's corners. flat_colors (k,4): colors at the corners of the flat pieces;
    source_corner (k,): the corner of the model for each corner of the pieces."""
    colors = np.tile(NO_LAYOUT, (count, 1))
    # Corners that the user has added to the flat pieces belong to no corner of the model.
    inside = (source_corner >= 0) & (source_corner < count)
    colors[source_corner[inside]] = flat_colors[inside]
    return colors


def screen_colors(linear: np.ndarray) -> np.ndarray:
    """Return linear RGBA colors (k,4) as float32 sRGB."""
    rgb = np.clip(linear[:, :3], 0, 1)
    shown = np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * rgb ** np.float32(1 / 2.4) - 0.055)
    return np.column_stack([shown, linear[:, 3]]).astype(np.float32)


def gather_lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> LineEdges:
    """Return the edges of seams, outlines and wires. Raises ObjectError if attributes of another add-on or the user
    have our names."""
    is_edited = target.data.is_editmode  # in Edit Mode, the selection is drawn, and hidden edges are not
    with shown_mesh(target, depsgraph) as mesh:
        marks, seams = read_marks(mesh), read_seams(mesh)
        outlines = faces_at_edges(mesh) == 1
        is_shown = ~read_hidden_edges(mesh) if is_edited else True
        rows = np.flatnonzero((seams | outlines | marks.are_wires) & is_shown)
        vertices = edge_vertices(mesh)[rows]
        source, pieces = vertices, np.zeros(len(mesh.edges), dtype=np.int32)
        allowances = np.zeros(len(mesh.edges), dtype=bool)
        if has_attributes(mesh, SOURCE_VERTEX, PIECE_INDEX):
            source = find_values(mesh, SOURCE_VERTEX)[vertices]
            pieces[corner_edges(mesh)] = find_values(mesh, PIECE_INDEX)[faces_of_corners(mesh)]
        else:  # not on flat pieces, because their cutting lines show the allowances
            allowances[corner_edges(mesh)[corner_widths(mesh) != 0]] = True
        return LineEdges(
            ends=vertex_places(mesh)[vertices],
            normals=read(mesh.vertices, "normal", np.float32, 3)[vertices[:, 0]],
            vertices=source,
            pieces=pieces[rows],
            seams=seams[rows],
            seam_ids=read_ids(mesh, SEAM)[rows],
            outlines=outlines[rows],
            allowances=(allowances & (seams | outlines))[rows],
            marks=marks.take(rows),
            selected=read_selected_edges(mesh)[rows] if is_edited else np.zeros(len(rows), dtype=bool),
        )


def shown_mesh(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> AbstractContextManager[bpy.types.Mesh]:
    """Return a context that yields the displayed mesh: with modifiers and shape keys, or in Edit Mode the edited mesh,
    even if it is edited through another object."""
    is_modified = not target.data.is_editmode and (target.modifiers or target.data.shape_keys)
    return evaluated_mesh(target, depsgraph) if is_modified else current_mesh(target)


def gather_side_eases(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> SideEases | None:
    """Return the eases of single sides; None if the mesh has none."""
    with shown_mesh(target, depsgraph) as mesh:
        ratios = SIDE_EASES.read(mesh)
        corners = np.flatnonzero(ratios)
        if not len(corners):
            return None
        places, faces = vertex_places(mesh), faces_of_corners(mesh)[corners]
        vertices = corner_vertices(mesh)[np.column_stack([corners, next_loops(mesh)[corners]])]
        ends, normals = places[vertices], read(mesh.polygons, "normal", np.float32, 3)[faces]
        inward = np.cross(normals, ends[:, 1] - ends[:, 0])
        is_flat = has_attributes(mesh, PIECE_INDEX)
        return SideEases(
            vertices=vertices,
            ends=ends,
            inward=inward / np.maximum(np.linalg.norm(inward, axis=1), np.finfo(np.float32).tiny)[:, None],
            normals=normals,
            ratios=ratios[corners],
            pieces=find_values(mesh, PIECE_INDEX)[faces] if is_flat else np.zeros(len(faces), dtype=np.int32),
            size=float(np.ptp(places, axis=0).max()),
        )


def gather_triangles(mesh: bpy.types.Mesh) -> Triangles:
    """Return the triangles of a mesh, which must not be in Edit Mode: see current_mesh."""
    mesh.calc_loop_triangles()
    return Triangles(
        positions=vertex_places(mesh),
        vertices=triangle_vertices(mesh),
        corners=triangle_corners(mesh),
        polygons=triangle_faces(mesh),
    )


def shows_our_map(mesh: bpy.types.Mesh) -> bool:
    """Return whether the UV editor shows the map that Flatten writes."""
    return mesh.uv_layers.active is not None and mesh.uv_layers.active.name == UV_LAYER


def gather_uv_lines(target: bpy.types.Object) -> LineEdges:
    """Return the edges of seams, outlines and wires in the map, once for each of their faces. Raises ObjectError like
    gather_lines."""
    with current_mesh(target) as mesh:
        marks, seams, outlines = read_marks(mesh), read_seams(mesh), faces_at_edges(mesh) == 1
        edge_of_loop, following, places = corner_edges(mesh), next_loops(mesh), uv_places(mesh)
        faces = faces_of_corners(mesh)
        is_shown = ~read(mesh.polygons, "hide", bool)[faces] if target.data.is_editmode else True
        loops = np.flatnonzero((seams | outlines | marks.are_wires)[edge_of_loop] & is_shown)
        rows = edge_of_loop[loops]
        corners = np.column_stack([loops, following[loops]])
        return LineEdges(
            ends=places[corners],
            normals=np.tile(np.array([0, 0, 1], dtype=np.float32), (len(loops), 1)),
            vertices=corner_vertices(mesh)[corners],
            pieces=read_ids(mesh, PIECE)[faces[loops]],
            seams=seams[rows],
            seam_ids=read_ids(mesh, SEAM)[rows],
            outlines=outlines[rows],
            allowances=np.zeros(len(rows), dtype=bool),
            marks=marks.take(rows),
            selected=np.zeros(len(rows), dtype=bool),  # not drawn, because the UV editor draws its own selection
        )


def uv_places(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the place (l,3) float32 of each corner in the map, for a mesh in Object Mode."""
    places = np.zeros((len(mesh.loops), 3), dtype=np.float32)
    places[:, :2] = read_uv(mesh.uv_layers[UV_LAYER])
    return places
