# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws surfaces and lines in 3D views and UV editors, and names and the legend over them."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import bmesh
import bpy
import gpu
import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree

from ..state.memory import kept
from ..state.owners import model_of
from .batches import Layer, blending, draw_colored, draw_failed, draw_lines
from .screen import MAX_NAMES, NO_LINES, PlacedName, write_over
from .shown import Drawing, UvDrawing, drawings, highest_value, map_notes, shown_map, uv_drawings

# Layers are drawn closer to the eye by these shares of the distance, so that a surface does not hide its lines.
SURFACE_NEARER = 0.0005
NEARER = {Layer.RIMS: 0.002, Layer.LINES: 0.0025, Layer.CORES: 0.003}
# Two steps of a 24-bit depth buffer. Let n be the distance of the near plane. At distance d, the view distinguishes
# depths that differ by more than DEPTH_STEP * d * d / n.
DEPTH_STEP = 2 / 2**24
# A surface that is closer to a place than this share of the distance from the eye does not hide it. The share is larger
# than those in NEARER, so that a name is not hidden before its line.
HIDDEN_BY = 0.005
# In Edit Mode, names show through models with more faces, because reading all faces after each change would be slow.
EDITED_LIMIT = 20_000
MOST_APART = 8.0  # largest result of _apart; if it were larger, lines on the back of a cushion would be visible


def draw_space() -> None:
    """Handler for POST_VIEW, which draws surfaces and lines in the space of the view."""
    context = bpy.context
    shown = list(drawings(context))
    if not shown:
        return
    apart = _apart(context)
    with _hidden_by_what_is_in_front(), blending():
        for drawing in shown:
            with _placed(context, drawing, apart * SURFACE_NEARER):
                _draw_surfaces(drawing)
        unit = context.preferences.system.ui_scale
        for layer, nearer in NEARER.items():
            for drawing in shown:
                with _placed(context, drawing, apart * nearer):
                    draw_lines(drawing.target, "", drawing.lines, drawing.failures, unit, layer)


@contextmanager
def _hidden_by_what_is_in_front() -> Iterator[None]:
    """Let closer surfaces hide the drawings, and restore the GPU's state at the end."""
    before = gpu.state.depth_test_get()
    gpu.state.depth_test_set("LESS_EQUAL")
    try:
        yield
    finally:
        gpu.state.depth_test_set(before)


def _apart(context: bpy.types.Context) -> float:
    """Return the factor by which layers are drawn farther apart than usual.

    Models in centimeters or millimeters are far from the eye. There, layers at the usual distances from each other
    would get the same depth.
    """
    if not context.region_data.is_perspective:
        return 1.0
    step = DEPTH_STEP * context.region_data.view_distance / context.space_data.clip_start
    return min(max(1.0, step / SURFACE_NEARER), MOST_APART)


@contextmanager
def _placed(context: bpy.types.Context, drawing: Drawing, nearer: float) -> Iterator[None]:
    view = context.region_data
    if view.is_perspective:
        toward_eye = Matrix.Scale(1 - nearer, 4)
    else:
        toward_eye = Matrix.Translation((0, 0, nearer * view.view_distance))
    with gpu.matrix.push_pop():
        gpu.matrix.load_matrix(toward_eye @ view.view_matrix @ drawing.target.matrix_world)
        yield


def _draw_surfaces(drawing: Drawing) -> None:
    if drawing.surface is not None:
        draw_colored(drawing.target, "surface", drawing.surface)
    elif drawing.failures is not None and len(drawing.failures.triangles):
        draw_failed(drawing.target, "failed faces", drawing.failures.triangles)


def draw_screen() -> None:
    """Handler for POST_PIXEL, which draws names and the legend over the view."""
    context = bpy.context
    shown = list(drawings(context))
    if shown:
        names = (name for drawing in shown for name in _names_in_view(context, drawing))
        color_map = shown_map(context)
        notes, highest = (map_notes(shown, color_map), highest_value(shown, color_map)) if color_map else ([], None)
        write_over(context, shown, names, notes, color_map, highest, _lines_in_view(context, shown))


def _lines_in_view(context: bpy.types.Context, shown: Sequence[Drawing]) -> np.ndarray:
    """Return the ends (k,2,2) of all lines in pixels of the region, except lines with an end outside the clip range."""
    found = []
    for drawing in shown:
        for ends in drawing.lines.places.values() if drawing.lines else ():
            matrix = np.array(drawing.target.matrix_world)
            found.append(ends @ matrix[:3, :3].T + matrix[:3, 3])
    if not found:
        return NO_LINES
    points, _, in_range = _projected(context, np.concatenate(found))
    return points.reshape(-1, 2, 2)[in_range.reshape(-1, 2).all(axis=1)]


def _names_in_view(context: bpy.types.Context, drawing: Drawing) -> Iterator[PlacedName]:
    """Yield the names whose points are visible, with their places in the region."""
    if not drawing.lines or not drawing.lines.names:
        return
    chosen = _chosen_piece(drawing.target)
    names = sorted(drawing.lines.names, key=lambda name: not name.is_selected and name.piece != chosen)[:MAX_NAMES]
    matrix, view = drawing.target.matrix_world, context.region_data
    linear = matrix.to_3x3()
    places = np.concatenate([name.places for name in names]) @ np.array(linear).T + np.array(matrix.translation)
    normals = np.concatenate([name.normals for name in names]) @ np.array(linear.inverted_safe())
    eye = np.array(view.view_matrix.inverted_safe())
    toward_eye = eye[:3, 3] - places if view.is_perspective else eye[:3, 2]
    points, seen = _in_region(context, places)
    seen &= (normals * toward_eye).sum(axis=1) >= 0
    if _may_hide_itself(context, drawing.target):
        seen[seen] = ~_are_behind(context, drawing.target, places[seen], toward_eye)
    counts = [len(name.places) for name in names]
    reach = np.repeat([name.reach for name in names], counts)[:, None] * matrix.median_scale
    reaches = np.linalg.norm(_in_region(context, places + eye[:3, 0] * reach)[0] - points, axis=1)
    whole = _room(context, drawing.target)
    parts = (np.split(each, np.cumsum(counts)[:-1]) for each in (points, seen, reaches))
    for name, own, own_seen, own_reaches in zip(names, *parts, strict=True):
        if not own_seen.any():
            continue
        reach = float(own_reaches[own_seen][0])
        room = min(name.room * reach / name.reach if name.reach else np.inf, whole)
        around = None
        if name.around is not None:
            around, _ = _in_region(context, name.around @ np.array(linear).T + np.array(matrix.translation))
        owner = drawing.target.name_full, name.piece
        is_selected = name.is_selected or name.piece == chosen
        yield PlacedName(name.texts, own[own_seen], reach, owner, room, around, is_selected)


def _room(context: bpy.types.Context, target: bpy.types.Object) -> float:
    """Return the side of a square with room for the object's texts, in pixels.

    The side is infinite if the object is partly outside of the region.
    """
    corners = np.array([target.matrix_world @ Vector(corner) for corner in target.bound_box])
    pixels, is_inside = _in_region(context, corners)
    sides = np.ptp(pixels, axis=0)
    # A strap, or a flat object seen edge-on, has almost no area, but there is room for texts beside it.
    return float(max(np.prod(sides) ** 0.5, sides.max() / 2)) if is_inside.all() else np.inf


def _may_hide_itself(context: bpy.types.Context, target: bpy.types.Object) -> bool:
    shading = context.space_data.shading
    is_solid = shading.type != "WIREFRAME" and not shading.show_xray
    return is_solid and model_of(target) is None


def _are_behind(
    context: bpy.types.Context, target: bpy.types.Object, places: np.ndarray, toward_eye: np.ndarray
) -> np.ndarray:
    """Return a mask (n,) of the places (n,3) on the surface that other parts of the model hide. toward_eye: direction
    to the eye in orthographic views."""
    is_met, inverse = _rays(context, target), target.matrix_world.inverted_safe()
    if context.region_data.is_perspective:
        eyes = np.tile(context.region_data.view_matrix.inverted_safe().translation, (len(places), 1))
    else:
        eyes = places + 2 * max(target.dimensions) * toward_eye
    linear, shift = np.array(inverse)[:3, :3], np.array(inverse)[:3, 3]
    begins, ends = eyes @ linear.T + shift, places @ linear.T + shift
    lengths = np.linalg.norm(ends - begins, axis=1)
    try:
        return np.array([
            length > 0 and is_met(begin, (end - begin) / length, (1 - HIDDEN_BY) * length)
            for begin, end, length in zip(begins.tolist(), ends, lengths.tolist(), strict=True)
        ], dtype=bool)  # fmt: skip
    except RuntimeError:  # after undo, Blender draws once before it has evaluated the object
        return np.zeros(len(places), dtype=bool)


def _rays(
    context: bpy.types.Context, target: bpy.types.Object
) -> Callable[[Sequence[float], Sequence[float], float], bool]:
    """Return a function that tests whether a ray from a point in a direction meets the surface within a distance."""
    if target.mode == "EDIT":  # the evaluated surface is still the surface before Edit Mode
        tree = kept(target.data, "faces to hide names", _edited_faces)
        return lambda begin, along, most: tree.ray_cast(Vector(begin), Vector(along), most)[0] is not None
    surface = target.evaluated_get(context.view_layer.depsgraph)
    return lambda begin, along, most: surface.ray_cast(begin, along, distance=most)[0]


def _edited_faces(mesh: bpy.types.Mesh) -> BVHTree:
    """Return a tree of the faces of a mesh in Edit Mode. It is empty if there are too many faces, or if some are
    hidden."""
    edit = bmesh.from_edit_mesh(mesh)
    if len(edit.faces) > EDITED_LIMIT or any(face.hide for face in edit.faces):
        return BVHTree.FromPolygons([], [])
    return BVHTree.FromBMesh(edit)


def _chosen_piece(target: bpy.types.Object) -> int | None:
    """Return the index of the flat piece chosen in the list; None for models. All names of the chosen piece are
    drawn."""
    model = model_of(target)
    return model.wirewarp_active_piece if model else None


def _in_region(context: bpy.types.Context, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the pixels (n,2) of places (n,3) in the world, and a mask of the places in the region and its clip
    range."""
    points, size, in_range = _projected(context, places)
    return points, in_range & np.all((points >= 0) & (points <= size), axis=1)


def _projected(context: bpy.types.Context, places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the pixels (n,2) of places (n,3) in the world, the region's size (2,), and a mask of the places in the
    clip range."""
    size = np.array([context.region.width, context.region.height])
    projected = np.column_stack([places, np.ones(len(places))]) @ np.array(context.region_data.perspective_matrix).T
    in_front = projected[:, 3] > 0
    depth = np.where(in_front, projected[:, 3], 1.0)
    points = (1 + projected[:, :2] / depth[:, None]) / 2 * size
    return points, size, in_front & (np.abs(projected[:, 2]) <= depth)  # Blender clips nearer and farther points


def draw_map() -> None:
    """Handler for POST_VIEW in UV editors, which draws lines in the coordinates of the map."""
    context = bpy.context
    shown = list(uv_drawings(context))
    if not shown:
        return
    unit = context.preferences.system.ui_scale
    with blending():
        for drawing in shown:
            if drawing.failures is not None and len(drawing.failures.triangles):
                draw_failed(drawing.target, "uv failed faces", drawing.failures.triangles)
        for layer in Layer:
            for drawing in shown:
                draw_lines(drawing.target, "uv", drawing.lines, drawing.failures, unit, layer)


def draw_map_names() -> None:
    """Handler for POST_PIXEL in UV editors, which draws names and the legend over the map."""
    context = bpy.context
    shown = list(uv_drawings(context))
    if shown:
        write_over(context, shown, (name for drawing in shown for name in _names_in_region(context, drawing)))


def _names_in_region(context: bpy.types.Context, drawing: UvDrawing) -> Iterator[PlacedName]:
    """Yield the names in the region of the UV editor, with their places in pixels."""
    region, to_region = context.region, context.region.view2d.view_to_region
    origin = np.array(to_region(0, 0, clip=False))
    # The scale is measured over 1000 units, because view_to_region rounds to whole pixels.
    pixels = (np.array(to_region(1000, 1000, clip=False)) - origin) / 1000
    for name in drawing.lines.names:
        points = origin + name.places[:, :2] * pixels
        seen = np.all((points >= 0) & (points <= (region.width, region.height)), axis=1)
        if seen.any():
            room = name.room * pixels[0]
            owner = drawing.target.name_full, name.piece
            yield PlacedName(name.texts, points[seen], name.reach * pixels[0], owner, room, None, name.is_selected)
