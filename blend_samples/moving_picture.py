# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws samples with their flat pieces and without texts, and for one of them the frames of a moving picture:

blender --background --factory-startup --addons wirewarp_addon --python blend_samples/moving_picture.py -- FOLDER

FOLDER/frames gets the frames of the fitted top, whose pieces leave the model, FOLDER/stills the other samples.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from pictures.drawing import Box, Sheet  # noqa: E402 (the folder must be on the path first)
from pictures.measure import cloth_stretch  # noqa: E402
from pictures.palette import INK, round_limit, stretch_colors  # noqa: E402
from pictures.sheet import draw_model, draw_pieces, view_matrix  # noqa: E402
from pictures.surfaces import read_flat, read_model  # noqa: E402
from pictures.views import VIEWS  # noqa: E402

MOVED, STILLS = "fitted_top", ("toy", "armchair_cover", "carnival_mask", "wetsuit_upper_body")
WIDTH, HEIGHT = 7.2, 4.2  # inches of 100 pixels
MODEL_BOX, FLAT_BOX = Box(-3.5, -0.9, -1.7, 1.9), Box(-0.7, 3.5, -1.7, 1.9)
STILL, MOVING = 8, 30  # frames with the model alone, and with moving pieces
DELAY = 0.4  # start of the last piece, as a share of the time of all movement


def way(time: float) -> float:
    """Return the share of its path that a piece has covered: slow at the start and at the end."""
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

    def draw(self, path: Path, time: float | None) -> None:
        """Draw a frame. time: None for the model alone, otherwise from 0, all pieces on the model, to 1, all flat."""
        sheet = Sheet(WIDTH, HEIGHT)
        draw_model(sheet, self.body, self.on_model + [0, 0, -10], self.body.normals @ self.matrix.T)
        if time is not None:
            starts = DELAY * self.number / max(self.number.max(), 1)
            gone = np.array([way(each) for each in time * (1 + DELAY) - starts])[:, None]
            draw_pieces(
                sheet,
                self.pieces,
                (1 - gone) * self.on_model[self.pieces.source_vertex] + gone * self.flat,
                self.colors,
            )
            if time == 1:
                sheet.add_text("orange: fabric stretched    blue: fabric compressed", 3.5, -1.98, 0.15, INK, "RIGHT")
        sheet.render(path)


def main() -> None:
    target = Path(sys.argv[sys.argv.index("--") + 1])
    frames, stills = target / "frames", target / "stills"
    for folder in (frames, stills):
        folder.mkdir(parents=True, exist_ok=True)
    for name in STILLS:
        Sample(name).draw(stills / f"{name}.png", 1.0)
    moved = Sample(MOVED)
    for frame in range(STILL + MOVING + 1):
        moved.draw(frames / f"{frame:03d}.png", (frame - STILL) / MOVING if frame >= STILL else None)


if __name__ == "__main__":
    main()
