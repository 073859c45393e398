# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the lines to mark on the fitted top, seen from above and from below:

blender --background --factory-startup --python docs/guide/draw_lines.py -- FILE.png
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

SAMPLES = Path(__file__).resolve().parents[2] / "blend_samples"
sys.path.insert(0, str(SAMPLES))

from pictures.drawing import Box, Sheet  # noqa: E402 (the folder must be on the path first)
from pictures.measure import chains  # noqa: E402
from pictures.palette import FAINT_INK, linear  # noqa: E402
from pictures.sheet import LINE_WIDTH, draw_model, view_matrix  # noqa: E402
from pictures.surfaces import Model, read_model  # noqa: E402

WIDTH, HEIGHT = 9.4, 4.6  # inches of 100 pixels
COLORS = {
    "side line": linear("#0048e8"),
    "shoulder seam": linear("#c03a00"),
    "armhole": linear("#7b1fa2"),
    "inside of the sleeve": linear("#00695c"),
}
LABEL = 0.19  # inches: height of the letters
# A view has a title, a box, the rotation to the left and the tilt toward the viewer in degrees, and labels. A label has
# the name of a line, and the share of the line's length at which the leader ends. Its last item is the offset of the
# text from this point, in inches. A label with an offset to the right is for the line on the right half of the model.
VIEWS = (
    (
        "From the front and above",
        Box(-4.4, -1.3, -1.75, 1.95),
        (-32, 24),
        (("shoulder seam", 0.5, (0.75, 0.5)), ("armhole", 0.45, (1.35, 0.45))),
    ),
    (
        "From the front and below",
        Box(0.7, 3.5, -1.75, 1.95),
        (-34, -38),
        (("inside of the sleeve", 0.6, (-0.5, -0.9)), ("side line", 0.4, (1.0, -0.2))),
    ),
)


def kind_of(line: np.ndarray) -> str:
    """Return the name in COLORS of a line. line (n, 3): its vertices, in meters from the middle of the hem."""
    if line[:, 2].min() < 0.01:
        return "side line"
    if line[:, 2].min() > 0.54:
        return "shoulder seam"
    return "inside of the sleeve" if np.abs(line[:, 0]).max() > 0.2 else "armhole"


def draw_view(sheet: Sheet, body: Model, title: str, box: Box, view: tuple[float, float], labels: tuple) -> None:
    matrix = view_matrix(*view)
    turned = body.vertices @ matrix.T
    points = box.center(turned, box.fit(turned)) + [0, 0, -10]
    bare = replace(body, seams=body.seams[:0], wires=body.wires[:0], tolerances=body.tolerances[:0])
    draw_model(sheet, bare, points, body.normals @ matrix.T)
    lines = chains(body.seams)
    for kind, color in COLORS.items():
        own = [points[line] for line in lines if kind_of(body.vertices[line]) == kind]
        sheet.add_lines(own, 1.5 * LINE_WIDTH, color)
    for kind, share, (right, up) in labels:
        placed = [body.vertices[line] for line in lines]
        on_side = [k for k, own in enumerate(placed) if kind_of(own) == kind and right * own[:, 0].sum() > 0]
        # An armhole has two lines. Its label is for the line on the front.
        line = points[lines[min(on_side, key=lambda k: placed[k][:, 1].mean())]]
        at = line[round(share * (len(line) - 1))] * [1, 1, 0] + [0, 0, 1]
        end = at + [right, up, 0]
        sheet.add_lines([np.array([at, end])], 0.4 * LINE_WIDTH, COLORS[kind])
        beside = 0.08 if right > 0 else -0.08
        align = "LEFT" if right > 0 else "RIGHT"
        sheet.add_text(kind, end[0] + beside, end[1] - 0.35 * LABEL, LABEL, COLORS[kind], align)
    sheet.add_text(title, (box.left + box.right) / 2, -2.15, LABEL, FAINT_INK, "CENTER")


def main() -> None:
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / "fitted_top.blend"))
    body = read_model(bpy.context.view_layer.objects.active)
    sheet = Sheet(WIDTH, HEIGHT)
    for view in VIEWS:
        draw_view(sheet, body, *view)
    sheet.render(Path(sys.argv[sys.argv.index("--") + 1]))


main()
