# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws surfaces and lines among the objects of a 3D view."""

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
import gpu
from mathutils import Matrix

from .batches import Layer, draw_colored, draw_failed, draw_lines
from .blending import blending
from .shown import Drawing, drawings

# How much nearer to the eye, of its distance, what lies on a surface is drawn, so that it is not half hidden in it.
SURFACE_NEARER = 0.0005
NEARER = {Layer.RIMS: 0.002, Layer.LINES: 0.0025, Layer.CORES: 0.003}


def draw_space() -> None:
    """The handler for POST_VIEW."""
    context = bpy.context
    shown = list(drawings(context))
    if not shown:
        return
    with _hidden_by_what_is_in_front(), blending():
        for drawing in shown:
            with _placed(context, drawing, SURFACE_NEARER):
                _draw_surfaces(drawing)
        unit = context.preferences.system.ui_scale
        for layer, nearer in NEARER.items():
            for drawing in shown:
                with _placed(context, drawing, nearer):
                    draw_lines(drawing.target, "", drawing.lines, drawing.failures, unit, layer)


@contextmanager
def _hidden_by_what_is_in_front() -> Iterator[None]:
    """Leaves the state as it was."""
    before = gpu.state.depth_test_get()
    gpu.state.depth_test_set("LESS_EQUAL")
    try:
        yield
    finally:
        gpu.state.depth_test_set(before)


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
