# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws surfaces and lines among the objects of a 3D view."""

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
import gpu
from gpu_extras.batch import batch_for_shader
from mathutils import Matrix

from .cache import Same, kept_drawing
from .line_styles import RIM, RIM_ALPHA, STYLES
from .shown import Drawing, drawings

# How much nearer to the eye, of its distance, what lies on a surface is drawn, so that it is not half hidden in it.
SURFACE_NEARER, RIM_NEARER, LINE_NEARER = 0.0005, 0.002, 0.0025
FAILED_ALPHA = 0.6
LINES, TRIANGLES, COLORED = "POLYLINE_UNIFORM_COLOR", "UNIFORM_COLOR", "SMOOTH_COLOR"


def draw_space() -> None:
    """The handler for POST_VIEW."""
    context = bpy.context
    shown = list(drawings(context))
    if not shown:
        return
    with _state():
        for drawing in shown:
            with _placed(context, drawing, SURFACE_NEARER):
                _draw_surfaces(drawing)
        unit = context.preferences.system.ui_scale
        for nearer, is_rim in ((RIM_NEARER, True), (LINE_NEARER, False)):
            for drawing in shown:
                with _placed(context, drawing, nearer):
                    _draw_lines(drawing, unit, is_rim)


@contextmanager
def _state() -> Iterator[None]:
    """Hidden by what is in front; leaves the state as it was."""
    depth_test, blend = gpu.state.depth_test_get(), gpu.state.blend_get()
    gpu.state.depth_test_set("LESS_EQUAL")
    gpu.state.blend_set("ALPHA")
    try:
        yield
    finally:
        gpu.state.depth_test_set(depth_test)
        gpu.state.blend_set(blend)


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
        surface = drawing.surface
        batch = _batch(drawing, "surface", surface, COLORED, "TRIS", pos=surface.places, color=surface.colors)
        batch.draw(gpu.shader.from_builtin(COLORED))
    elif drawing.failures is not None and len(drawing.failures.triangles):
        shader = gpu.shader.from_builtin(TRIANGLES)
        places = drawing.failures.triangles
        batch = _batch(drawing, "failed faces", places, TRIANGLES, "TRIS", pos=places)
        shader.uniform_float("color", (*STYLES["failed"].color, FAILED_ALPHA))
        batch.draw(shader)


def _draw_lines(drawing: Drawing, unit: float, is_rim: bool) -> None:
    shader = gpu.shader.from_builtin(LINES)
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    places = dict(drawing.lines.places) if drawing.lines else {}
    if drawing.failures is not None:
        places |= drawing.failures.lines
    for kind, style in STYLES.items():
        if kind not in places:
            continue
        batch = _batch(drawing, kind, places[kind], LINES, "LINES", pos=places[kind])
        shader.uniform_float("lineWidth", (style.width + (RIM if is_rim else 0)) * unit)
        shader.uniform_float("color", (*style.rim, RIM_ALPHA) if is_rim else (*style.color, 1.0))
        batch.draw(shader)


def _batch(
    drawing: Drawing, what: str, made_of: object, shader: str, primitive: str, **content: object
) -> gpu.types.GPUBatch:
    return kept_drawing(
        drawing.target,
        f"batch of {what}",
        (Same(made_of),),
        lambda: batch_for_shader(gpu.shader.from_builtin(shader), primitive, content),
    )
