# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws on a sheet of paper in Blender, seen from above: x is right and y is up, in inches. Workbench renders it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from .palette import PAPER

FONT = Path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
PIXELS_PER_INCH = 100


@dataclass(frozen=True)
class Box:
    """A rectangle on a sheet, in inches."""

    left: float
    right: float
    bottom: float
    top: float

    def fit(self, points: np.ndarray) -> float:
        """Return the largest scale at which points (n, 3), seen from above, fit into the box."""
        width, height = np.ptp(points[:, :2], axis=0)
        return min((self.right - self.left) / width, (self.top - self.bottom) / height)

    def center(self, points: np.ndarray, scale: float) -> np.ndarray:
        """Return the scaled points in the middle of the box."""
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        return scale * (points - middle) + [(self.left + self.right) / 2, (self.bottom + self.top) / 2, 0]


class Sheet:
    """A scene of its own with a sheet of this width and height in inches. The origin is in the middle."""

    def __init__(self, width: float, height: float) -> None:
        self.scene = bpy.data.scenes.new("WireWarp sheet")
        self.width, self.height = width, height
        world = bpy.data.worlds.new("Paper")
        world.color = PAPER[:3]
        self.scene.world = world
        camera = bpy.data.cameras.new("From above")
        camera.type, camera.ortho_scale, camera.clip_end = "ORTHO", max(width, height), 100.0
        self.scene.camera = self._add(bpy.data.objects.new("From above", camera))
        self.scene.camera.location = (0, 0, 50)
        self._font = bpy.data.fonts.load(str(FONT)) if FONT.exists() else None

    def add_triangles(self, corners: np.ndarray, colors: np.ndarray) -> None:
        """Add triangles (m, 3, 3) with a color at each corner (m, 3, 4)."""
        mesh = bpy.data.meshes.new("Triangles")
        mesh.from_pydata(corners.reshape(-1, 3).tolist(), [], np.arange(3 * len(corners)).reshape(-1, 3).tolist())
        mesh.color_attributes.new("Color", "FLOAT_COLOR", "CORNER")
        mesh.color_attributes["Color"].data.foreach_set("color", colors.astype(np.float32).ravel())
        self._add(bpy.data.objects.new("Triangles", mesh))

    def add_lines(self, lines: list[np.ndarray], width: float, color: np.ndarray) -> None:
        """Add polylines (n, 3) as round tubes of this width."""
        curve = bpy.data.curves.new("Lines", "CURVE")
        curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", width / 2, 2
        curve.use_fill_caps = True
        for line in lines:
            spline = curve.splines.new("POLY")
            spline.points.add(len(line) - 1)
            spline.points.foreach_set("co", np.column_stack([line, np.ones(len(line))]).astype(np.float32).ravel())
        self._add(bpy.data.objects.new("Lines", curve), color)

    def add_rimmed_lines(self, lines: list[np.ndarray], width: float, color: np.ndarray, rim: np.ndarray) -> None:
        """Add lines in front of slightly wider lines, whose color shows on both sides as a rim."""
        self.add_lines(lines, 1.6 * width, rim)
        self.add_lines([line + [0, 0, 0.8 * width] for line in lines], width, color)

    def add_text(self, text: str, x: float, y: float, size: float, color: np.ndarray, align: str = "LEFT") -> None:
        """Add a line of text. y: height of the base line."""
        curve = bpy.data.curves.new("Text", "FONT")
        curve.body, curve.size, curve.align_x = text, size, align
        if self._font:
            curve.font = self._font
        self._add(bpy.data.objects.new("Text", curve), color).location = (x, y, 2.0)

    def render(self, path: Path) -> None:
        """Write a PNG and remove the scene."""
        settings = self.scene.render
        settings.engine = "BLENDER_WORKBENCH"
        settings.resolution_x, settings.resolution_y = (round(PIXELS_PER_INCH * s) for s in (self.width, self.height))
        settings.image_settings.file_format, settings.image_settings.color_mode = "PNG", "RGB"
        settings.image_settings.compression = 30
        settings.dither_intensity = 0.0
        settings.filepath = str(path)
        self.scene.display.render_aa = "16"
        self.scene.view_settings.view_transform = "Standard"
        shading = self.scene.display.shading
        shading.light, shading.color_type = "FLAT", "VERTEX"
        bpy.ops.render.render(write_still=True, scene=self.scene.name)
        bpy.data.scenes.remove(self.scene)

    def _add(self, thing: bpy.types.Object, color: np.ndarray | None = None) -> bpy.types.Object:
        if color is not None:
            thing.color = color
        self.scene.collection.objects.link(thing)
        return thing
