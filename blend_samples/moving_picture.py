# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws samples with their flat pieces and without names, and the frames of a moving picture of the fitted top:

blender --background --factory-startup --addons wirewarp_addon --python blend_samples/moving_picture.py -- FOLDER

The frames are written to FOLDER/frames. They show how lines are marked, how Flatten is pressed, and how the pieces
leave the model. Pictures of other samples are written to FOLDER/stills.
"""

from __future__ import annotations

import itertools
import sys
from pathlib import Path

import bpy
import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from pictures.drawing import Box, Sheet  # noqa: E402 (the folder must be on the path first)
from pictures.measure import cloth_stretch  # noqa: E402
from pictures.palette import FAINT_INK, INK, PAPER, RIGID, round_limit, stretch_colors  # noqa: E402
from pictures.sheet import draw_model, draw_pieces, view_matrix  # noqa: E402
from pictures.surfaces import read_flat, read_model  # noqa: E402
from pictures.views import VIEWS  # noqa: E402

MOVED, STILLS = "fitted_top", ("toy", "armchair_cover", "carnival_mask", "wetsuit_upper_body")
WIDTH, HEIGHT = 7.2, 4.2  # inches of 100 pixels
MODEL_BOX, FLAT_BOX = Box(-3.5, -0.9, -1.7, 1.9), Box(-0.7, 3.5, -1.7, 1.9)
MARKING, PRESSING, MOVING = 26, 12, 30  # frames of marking, of pressing Flatten, and with moving pieces
DELAY = 0.4  # time at which the last piece begins to move, as a share of the time that a piece moves


def way(time: float) -> float:
    """Return the share of its path that a piece has covered at a time from 0 to 1. It starts and stops slowly."""
    t = min(max(time, 0.0), 1.0)
    return t * t * (3 - 2 * t)


class Sample:
    """A sample and its pieces, flattened and placed on a sheet."""

    def __init__(self, name: str) -> None:
        bpy.ops.wm.open_mainfile(filepath=str(FOLDER / f"{name}.blend"))
        bpy.ops.object.wirewarp_flatten(cloth=bpy.context.scene.wirewarp.cloth)
        model = bpy.context.view_layer.objects.active
        self.body, self.pieces = read_model(model), read_flat(bpy.data.objects[f"{model.name} Flat"])
        self.matrix = view_matrix(*VIEWS[name])
        turned = self.body.vertices @ self.matrix.T
        scale = min(MODEL_BOX.fit(turned), FLAT_BOX.fit(self.pieces.vertices))
        self.on_model = MODEL_BOX.center(turned, scale)
        self.flat = FLAT_BOX.center(self.pieces.vertices, scale) + [0, 0, 10]  # in front of the model
        worn = self.body.vertices[self.pieces.source_vertex]
        stretch = cloth_stretch(self.pieces.vertices[:, :2], worn, self.pieces.triangles)
        self.colors = stretch_colors(stretch, round_limit(stretch))
        self.number = np.zeros(len(self.flat), dtype=int)  # number of the piece of each vertex
        self.number[self.pieces.triangles] = self.pieces.piece[:, None]

    def draw(self, path: Path, time: float) -> None:
        """Draw a picture. time: 0 if all pieces are on the model, 1 if all are flat, and between if they move."""
        sheet = self._sheet_with_model(1.0)
        starts = DELAY * self.number / max(self.number.max(), 1)
        gone = np.array([way(each) for each in time * (1 + DELAY) - starts])[:, None]
        points = (1 - gone) * self.on_model[self.pieces.source_vertex] + gone * self.flat
        draw_pieces(sheet, self.pieces, points, self.colors)
        if time == 1:
            sheet.add_text("orange: fabric stretched    blue: fabric compressed", 3.5, -1.98, 0.15, INK, "RIGHT")
        else:
            draw_button(sheet, is_pressed=True)
        sheet.render(path)

    def draw_marking(self, path: Path, marked: float) -> None:
        """Draw a frame with this share of each seam and wire."""
        sheet = self._sheet_with_model(marked)
        sheet.add_text("Mark seams (black) and lines that keep their length (blue)", -3.5, -1.96, 0.19, INK)
        sheet.render(path)

    def draw_pressing(self, path: Path, is_pressed: bool) -> None:
        sheet = self._sheet_with_model(1.0)
        draw_button(sheet, is_pressed)
        sheet.render(path)

    def _sheet_with_model(self, marked: float) -> Sheet:
        sheet = Sheet(WIDTH, HEIGHT)
        draw_model(sheet, self.body, self.on_model + [0, 0, -10], self.body.normals @ self.matrix.T, marked)
        return sheet


def draw_button(sheet: Sheet, is_pressed: bool) -> None:
    """Draw the button Flatten at the lower left, with the pointer on it."""
    left, right, bottom, top = -3.5, -2.1, -2.04, -1.7
    corners = np.array([(left, bottom, 1), (right, bottom, 1), (right, top, 1), (left, top, 1)])
    color = RIGID if is_pressed else FAINT_INK
    sheet.add_triangles(corners[[[0, 1, 2], [0, 2, 3]]], np.tile(color, (2, 3, 1)))
    sheet.add_text("Flatten", (left + right) / 2, bottom + 0.11, 0.2, PAPER, "CENTER")
    pointer = np.array([(0, 0, 3), (0.16, -0.17, 3), (0, -0.24, 3)]) + [right - 0.2, bottom + 0.2, 0]
    sheet.add_triangles(pointer[None], np.tile(INK, (1, 3, 1)))


def main() -> None:
    target = Path(sys.argv[sys.argv.index("--") + 1])
    frames, stills = target / "frames", target / "stills"
    for folder in (frames, stills):
        folder.mkdir(parents=True, exist_ok=True)
    for name in STILLS:
        Sample(name).draw(stills / f"{name}.png", 1.0)
    moved = Sample(MOVED)
    names = (frames / f"{number:03d}.png" for number in itertools.count())
    for frame in range(MARKING):
        moved.draw_marking(next(names), min(frame / (MARKING - 6), 1.0))  # the last frames show the marked model
    for frame in range(PRESSING):
        moved.draw_pressing(next(names), frame >= PRESSING / 2)
    for frame in range(MOVING + 1):
        moved.draw(next(names), frame / MOVING)


if __name__ == "__main__":
    main()
