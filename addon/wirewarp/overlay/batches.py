# SPDX-License-Identifier: GPL-3.0-or-later
"""Sends arrays to the GPU when they change, and draws them with the current matrix of the GPU."""

from collections.abc import Iterator
from contextlib import contextmanager
from enum import Enum, auto

import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..state.drawings import Same, kept_drawing
from .failures import Failures
from .gather import ColoredTriangles
from .lines import CORES, RIM, RIM_ALPHA, STYLES
from .objects import Lines

FAILED_ALPHA = 0.6  # opacity of failed areas, through which the shading of the surface is visible
LINES, TRIANGLES, COLORED = "POLYLINE_UNIFORM_COLOR", "UNIFORM_COLOR", "SMOOTH_COLOR"


class Layer(Enum):
    """Layers of lines, from the lowest to the highest. Wider lines are below narrower lines."""

    RIMS = auto()
    LINES = auto()
    CORES = auto()


def draw_lines(
    owner: bpy.types.Object, space: str, lines: Lines | None, failed: Failures | None, unit: float, layer: Layer
) -> None:
    """Draw one layer of the lines. space: prefix of the names of kept batches; unit: pixels of the screen per pixel at
    interface scale 1."""
    is_rim = layer == Layer.RIMS
    shader = gpu.shader.from_builtin(LINES)
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    places = (lines.places if lines else {}) | (failed.lines if failed else {})
    dashes = lines.dashes if lines else {}
    for kind, style in STYLES.items():
        if (kind in CORES) != (layer == Layer.CORES):
            continue
        shader.uniform_float("color", (*style.rim, RIM_ALPHA) if is_rim else (*style.color, 1.0))
        # Dashes are drawn before the thin line. The thin line has the same depth, so only spots of it are visible on
        # dashes.
        for what, arrays, width in ((f"{kind} dashes", dashes, style.width), (kind, places, style.line_width)):
            if kind in arrays:
                batch = _batch(owner, f"{space} {what}", arrays[kind], LINES, "LINES", pos=arrays[kind])
                shader.uniform_float("lineWidth", (width + (RIM if is_rim else 0)) * unit)
                batch.draw(shader)


def draw_failed(owner: bpy.types.Object, what: str, triangles: np.ndarray) -> None:
    """Draw the triangles of failed faces. triangles (3m,3): their corners; what: name of the kept batch."""
    shader = gpu.shader.from_builtin(TRIANGLES)
    shader.uniform_float("color", (*STYLES["failed"].color, FAILED_ALPHA))
    _batch(owner, what, triangles, TRIANGLES, "TRIS", pos=triangles).draw(shader)


def draw_colored(owner: bpy.types.Object, what: str, surface: ColoredTriangles) -> None:
    batch = _batch(owner, what, surface, COLORED, "TRIS", pos=surface.places, color=surface.colors)
    batch.draw(gpu.shader.from_builtin(COLORED))


def _batch(
    owner: bpy.types.Object, what: str, made_of: object, shader: str, primitive: str, **content: object
) -> gpu.types.GPUBatch:
    return kept_drawing(
        owner,
        f"batch of {what}",
        (Same(made_of),),
        lambda: batch_for_shader(gpu.shader.from_builtin(shader), primitive, content),
    )


@contextmanager
def blending() -> Iterator[None]:
    """Draw with transparency, and restore the GPU's state at the end."""
    before = gpu.state.blend_get()
    gpu.state.blend_set("ALPHA")
    try:
        yield
    finally:
        gpu.state.blend_set(before)
