# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a sample whose pieces leave the model and become flat, as frames of a moving picture:

blender --background --factory-startup --addons wirewarp_addon --python blend_samples/moving_picture.py -- FOLDER
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
from pictures.palette import round_limit, stretch_colors  # noqa: E402
from pictures.sheet import draw_model, draw_pieces, view_matrix  # noqa: E402
from pictures.surfaces import read_flat, read_model  # noqa: E402

FILE, SAMPLE = "fitted_top.blend", "Fitted top"
VIEW = (-28, 8)  # degrees that it is turned to the left and tipped toward the viewer, as in the demo
WIDTH, HEIGHT = 7.2, 4.0  # inches of 100 pixels
MODEL_BOX, FLAT_BOX = Box(-3.5, -0.9, -1.8, 1.8), Box(-0.7, 3.5, -1.8, 1.8)
STILL, MOVING = 8, 30  # frames with the model alone, and with moving pieces
DELAY = 0.4  # of the time that all pieces move: how much later the last piece starts


def way(time: float) -> float:
    """Return how much of its way a piece has gone: slowly at first and at the end."""
    t = min(max(time, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def main() -> None:
    target = Path(sys.argv[sys.argv.index("--") + 1])
    target.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.open_mainfile(filepath=str(FOLDER / FILE))
    bpy.ops.object.wirewarp_flatten()
    body, pieces = read_model(bpy.data.objects[SAMPLE]), read_flat(bpy.data.objects[f"{SAMPLE} Flat"])
    matrix = view_matrix(*VIEW)
    turned = body.vertices @ matrix.T
    scale = min(MODEL_BOX.fit(turned), FLAT_BOX.fit(pieces.vertices))
    on_model = MODEL_BOX.center(turned, scale)
    flat = FLAT_BOX.center(pieces.vertices, scale) + [0, 0, 10]  # in front of the model
    stretch = cloth_stretch(pieces.vertices[:, :2], body.vertices[pieces.source_vertex], pieces.triangles)
    colors = stretch_colors(stretch, round_limit(stretch))
    number = np.zeros(len(flat), dtype=int)  # of the piece of each vertex
    number[pieces.triangles] = pieces.piece[:, None]
    last = max(number.max(), 1)
    for frame in range(STILL + MOVING + 1):
        sheet = Sheet(WIDTH, HEIGHT)
        draw_model(sheet, body, on_model + [0, 0, -10], body.normals @ matrix.T)
        if frame >= STILL:
            time = (frame - STILL) / MOVING * (1 + DELAY)
            gone = np.array([way(time - DELAY * each / last) for each in number])[:, None]
            draw_pieces(sheet, pieces, (1 - gone) * on_model[pieces.source_vertex] + gone * flat, colors)
        sheet.render(target / f"{frame:03d}.png")


if __name__ == "__main__":
    main()
