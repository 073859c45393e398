# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts lines into the mesh: suggested lines, and smooth lines that replace seams along edges.

The surface does not change. New elements get the marks, maps and attributes of the elements that they divide.
"""

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from itertools import pairwise

import bmesh
import bpy
import numpy as np
from mathutils import Vector

from ..blender.mesh import as_bmesh, edge_vertices, faces_at_edges, read_seams, read_selected_edges
from ..blender.objects import check_local
from ..blender.selection import in_object_mode, select_edges_in_edit_mode
from ..core import FlattenError, Issue, SurfacePath, Wire, counted, straighten_path
from ..issues import ObjectError, object_error
from ..marks.ease import clear_seams, edges_with_marks, mark_seams
from ..names import MARKS
from ..solve.arrays import MeshArrays
from ..solve.chains import are_among, split_into_chains
from ..solve.cut_faces import DividedTriangle, Division, Pairs, divide
from ..solve.flatten import issue_of_error
from ..solve.suggest import NoSeam, painted_at_edges
from ..state.marked_mesh import marked_mesh
from ..state.owners import check_not_edited
from ..state.read_model import apply_modifiers, object_to_arrays
from ..state.suggestions import read_no_seam
from ..ui.editing import OnModel, reporting_refusals


def take_lines(source: bpy.types.Object, paths: Sequence[SurfacePath], with_modifiers: bool) -> int:
    """Cut the lines into the mesh as seams. Return the number of new seams.

    with_modifiers: whether the lines are on the mesh with modifiers, which are then applied
    Raises ObjectError, with nothing changed, if the lines cannot be cut.
    """
    depsgraph = bpy.context.evaluated_depsgraph_get() if with_modifiers else None
    division = _divided(object_to_arrays(source, marked_mesh(source), depsgraph), paths)
    if with_modifiers:
        apply_modifiers(source)
    return mark_seams(source.data, cut_lines(source.data, division))


def take_away(source: bpy.types.Object, seams: Pairs, with_modifiers: bool) -> int:
    """Clear these seams and return their number. Raises ObjectError, with nothing changed, if modifiers cannot be
    applied.

    with_modifiers: whether the seams are on the mesh with modifiers, which are then applied.
    """
    if with_modifiers:
        apply_modifiers(source)
    clear_seams(source.data, seams)
    return len(seams)


def _divided(arrays: MeshArrays, paths: Sequence[SurfacePath]) -> Division:
    """Return the division of the faces by the lines. Raises ObjectError if the lines cannot be cut."""
    try:
        return divide(arrays, paths)
    except FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error


def cut_lines(mesh: bpy.types.Mesh, division: Division) -> Pairs:
    """Divide the faces of a mesh. Vertices keep their indices. Returns the edges of the lines as vertex pairs."""
    if not division.polygons:
        return division.lines
    with _edited(mesh) as edited:
        vertices, faces = dict(enumerate(edited.verts)), list(edited.faces)
        filled = []  # faces of one triangle each, with the division of this triangle
        for polygon, divided in division.polygons.items():
            parts = [faces[polygon]]
            _split_along(edited, parts, divided.diagonals, vertices)
            part_of = {frozenset(part.verts): part for part in parts}
            for each in divided.triangles:
                filled.append((part_of[frozenset(vertices[v] for v in each.corners)], each))
        for line in division.edges:
            _split_edge(edited, line, vertices)
        for part, triangle in filled:
            if len(triangle.parts) > 1:
                _replace(edited, part, triangle, vertices)
        edited.verts.index_update()
        return [(vertices[a].index, vertices[b].index) for a, b in division.lines]


@contextmanager
def unchanged_on_error(mesh: bpy.types.Mesh) -> Iterator[None]:
    """Restore the mesh if an error occurs, so that either all lines are cut or none."""
    with as_bmesh(mesh) as before:
        try:
            yield
        except Exception:
            before.to_mesh(mesh)
            mesh.update()
            raise


@contextmanager
def _edited(mesh: bpy.types.Mesh) -> Iterator[bmesh.types.BMesh]:
    """Yield a bmesh of the mesh, and write it back at the end unless an error occurs."""
    with as_bmesh(mesh) as edited:
        yield edited
        edited.to_mesh(mesh)
    mesh.update()


def _split_along(
    edited: bmesh.types.BMesh,
    parts: list[bmesh.types.BMFace],
    pairs: Pairs,
    vertices: dict[int, bmesh.types.BMVert],
) -> None:
    """Split a face along new edges, which do not cross. parts: list that contains the face, and to which its new parts
    are added; pairs: vertices of the new edges."""
    for a, b in pairs:
        first, second = vertices[a], vertices[b]
        face = next(each for each in parts if {first, second} <= set(each.verts))
        new, corner = bmesh.utils.face_split(face, first, second)
        parts.append(new)
        for loop in corner.edge.link_loops:  # set to 0, because Blender has copied values of other edges
            for side in _side_layers(edited):
                loop[side] = 0.0


def _replace(
    edited: bmesh.types.BMesh,
    face: bmesh.types.BMFace,
    triangle: DividedTriangle,
    vertices: dict[int, bmesh.types.BMVert],
) -> None:
    """Replace a face with the parts of its triangle. Corners keep their attributes, and points inside get interpolated
    attributes."""
    corners = [vertices[corner] for corner in triangle.corners]
    sides, values = set(face.edges), {loop.vert: loop for loop in face.loops}
    aside: list[bmesh.types.BMVert] = []
    for index, weights in triangle.inside.items():
        place = sum((weight * corner.co for weight, corner in zip(weights, corners, strict=True)), Vector())
        loop = _interpolated(face, place)
        vertices[index] = edited.verts.new(place, loop.vert)
        values[vertices[index]] = loop
        aside += dict.fromkeys(vertex for part in loop.vert.link_faces for vertex in part.verts)
    following = [loop.vert for loop in face.loops if loop.vert in corners]
    is_reversed = following.index(corners[1]) != (following.index(corners[0]) + 1) % 3  # for a negative scale
    for part in triangle.parts:
        new = edited.faces.new([vertices[v] for v in (part[::-1] if is_reversed else part)], face)
        for loop in new.loops:
            loop.copy_from(values[loop.vert])
        for loop in new.loops:  # a second pass, because copy_from makes earlier Python objects of corners invalid
            if loop.edge not in sides:
                for side in _side_layers(edited):
                    loop[side] = 0.0
    edited.faces.remove(face)
    for vertex in aside:
        edited.verts.remove(vertex)


def _interpolated(face: bmesh.types.BMFace, place: Vector) -> bmesh.types.BMLoop:
    """Return a corner with the attributes of a face at a place inside. The corner belongs to a temporary copy of the
    face.

    BMLoop.copy_from_face_interp would be simpler, but fails in Blender 3.4.
    """
    copied = face.copy()
    corners = set(copied.verts)
    bmesh.utils.face_split(copied, copied.verts[0], copied.verts[1], coords=[place])
    return next(loop for loop in copied.loops if loop.vert not in corners)


def _split_edge(
    edited: bmesh.types.BMesh, line: list[tuple[int, float]], vertices: dict[int, bmesh.types.BMVert]
) -> None:
    """Add the vertices along an edge. line: as in Division.edges."""
    (first, start), (last, _) = line[0], line[-1]
    for index, share in line[1:-1]:
        edge = edited.edges.get((vertices[first], vertices[last]))
        _, vertex = bmesh.utils.edge_split(edge, vertices[first], (share - start) / (1 - start))
        for loop in vertex.link_loops:  # the second part of the edge begins here, and gets the marks of the first
            for side in _side_layers(edited):
                loop[side] = loop.link_loop_prev[side]
        vertices[index], first, start = vertex, index, share


def _side_layers(edited: bmesh.types.BMesh) -> list[bmesh.types.BMLayerItem]:
    """Return the layers with marks of one side, which are stored on corners."""
    layers = edited.loops.layers.float
    return [layers[mark.name] for mark in MARKS if mark.domain == "CORNER" and mark.name in layers]


def cut_smooth_lines(source: bpy.types.Object, edges: Pairs) -> Pairs:
    """Replace each line of these seam edges with a smooth seam: see _smooth_line(). Returns the edges of the new seams.

    Vertices keep their indices. Raises ObjectError, perhaps after changes: see unchanged_on_error
    """
    mesh, seams = source.data, []
    places = object_to_arrays(source, marked_mesh(source), None).vertices
    paths = [chain.vertices for chain in split_into_chains(np.array(edges), places)]
    for path in paths:
        _check_ends(source, path)
    for index, path in enumerate(paths):
        clear_seams(mesh, list(pairwise(path)))  # before the cut, because the line cuts some of these edges in two
        arrays = object_to_arrays(source, marked_mesh(source), None)
        kept = [pair for other in paths[index + 1 :] for pair in pairwise(other)]
        line = _smooth_line(arrays, path, kept, read_no_seam(source))
        cut = cut_lines(mesh, _divided(arrays, [line]))
        mark_seams(mesh, cut)
        seams += cut
    return seams


def _check_ends(source: bpy.types.Object, path: list[int]) -> None:
    """Raises ObjectError if the path of vertices meets itself."""
    again = [vertex for index, vertex in enumerate(path) if vertex in path[:index]]
    if again:
        sentence = (
            f'A line of "{source.name}" meets itself at vertex {again[0]}. Select only a part of it, and smooth each '
            "part separately."
        )
        raise ObjectError(Issue("line_meets_itself", sentence, vertices=again))


def _smooth_line(arrays: MeshArrays, path: list[int], kept: Pairs, no_seam: NoSeam) -> SurfacePath:
    """Return a smooth line beside this path, with the same ends. The path follows edges that are not seams.

    kept: edges that the line crosses at the same places as the path
    no_seam: the line enters only painted faces that the path enters
    Raises ObjectError if the library finds no line.
    """
    painted = (painted_at_edges(arrays, no_seam) > 0) | no_seam.vertices[arrays.edges].all(axis=1)
    painted &= ~are_among(arrays.edges, list(pairwise(path)))
    seams = np.concatenate([arrays.seams, np.array(kept, dtype=np.int32).reshape(-1, 2), arrays.edges[painted]])
    try:
        wires = [Wire(wire.chain.vertices, wire.chain.tolerance) for wire in arrays.wires]
        ends, t = straighten_path(arrays.vertices, arrays.triangles, path, seams=seams, wires=wires)
    except FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error
    return _on_triangles(ends, t, arrays)


def _on_triangles(ends: np.ndarray, t: np.ndarray, arrays: MeshArrays) -> SurfacePath:
    """Return the points ends[:, 0] + t (ends[:, 1] - ends[:, 0]), each as a point in a triangle."""
    near = np.flatnonzero(np.isin(arrays.triangles, ends).any(axis=1))
    faces, coordinates = [], []
    for (first, second), share in zip(ends.tolist(), t.tolist(), strict=True):
        triangles = arrays.triangles[near]
        row = np.flatnonzero((triangles == first).any(axis=1) & (triangles == second).any(axis=1))[0]
        faces.append(int(near[row]))
        coordinates.append((1 - share) * (triangles[row] == first) + share * (triangles[row] == second))
    return SurfacePath(faces, coordinates)


class MESH_OT_wirewarp_smooth_seam(OnModel, bpy.types.Operator):
    """Replace the selected seam, which follows edges, with the shortest line beside it, cut into the faces"""

    bl_idname = "mesh.wirewarp_smooth_seam"
    bl_label = "Smooth Seam"
    bl_options = {"REGISTER", "UNDO"}
    on_model = "smooth the seam"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        targets = list(context.objects_in_mode_unique_data)
        with in_object_mode(context):
            for target in targets:
                check_local(target, target.data)
                check_not_edited(target)
            selected = {target: edges for target in targets if (edges := _selected_seams(target))}
            with ExitStack() as restored:
                for target in selected:
                    restored.enter_context(unchanged_on_error(target.data))
                smooth = {target: cut_smooth_lines(target, edges) for target, edges in selected.items()}
        if not smooth:
            raise object_error("nothing", "Nothing to smooth: select edges of a seam first.")
        for target in targets:
            select_edges_in_edit_mode(target.data, smooth.get(target, []))
        before, after = (sum(map(len, each.values())) for each in (selected, smooth))
        self.report({"INFO"}, f"The smooth line has {counted(after, 'edge')} instead of {before}")
        return {"FINISHED"}


def _selected_seams(target: bpy.types.Object) -> Pairs:
    """Return the selected seam edges between two faces. Raises ObjectError if smoothing would lose marks."""
    mesh = target.data
    rows = read_selected_edges(mesh) & read_seams(mesh) & (faces_at_edges(mesh) == 2)
    pairs = edge_vertices(mesh)
    marked = pairs[rows & edges_with_marks(mesh)]
    if len(marked):
        sentence = (
            f'{counted(len(marked), "selected edge")} of "{target.name}" would lose a mark: a wire, an ease or an '
            "allowance. Clear this mark first, and mark it on the smooth line again."
        )
        raise ObjectError(Issue("marks_lost", sentence, edges=[tuple(pair) for pair in marked.tolist()]))
    return [tuple(pair) for pair in pairs[np.flatnonzero(rows)].tolist()]
