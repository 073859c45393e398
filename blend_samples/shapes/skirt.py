# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a skirt gathered to its waistband: the upper edges of front and back are twice as long as the band."""

from __future__ import annotations

import numpy as np

from .curves import cubic_spline
from .shape import Shape, ShapeBuilder

#                   z     half width, half depth
PROFILE = np.array([
    [0.000, 0.255, 0.215],  # the hem, twice as long as the waist
    [0.200, 0.248, 0.207],
    [0.350, 0.229, 0.188],
    [0.450, 0.196, 0.156],
    [0.500, 0.154, 0.114],
    [0.520, 0.132, 0.094],  # the waist
])  # fmt: skip
BAND = 0.035  # meters: height of the waistband
GATHERS = 1.0  # ease of the upper edge, which is twice as long as the waistband
FAIRNESS = 0.2  # with less, the gathered edge would be wavy, because it is too long for the fabric below it


def gathered_skirt(panel: int = 40, length: int = 20, band: int = 3) -> Shape:
    """Return two panels and a band, which is open at the back.

    panel, length, band: numbers of edges across a panel, down a panel and up the band.
    """
    builder = ShapeBuilder()
    waist = PROFILE[-1, 0]
    heights = np.linspace(0, waist, length + 1)
    skirt = builder.add_grid(_rings(heights, cubic_spline(PROFILE[:, 0], PROFILE[:, 1:])(heights), 2 * panel))
    heights = np.linspace(waist, waist + BAND, band + 1)
    waistband = builder.add_grid(_rings(heights, np.repeat(PROFILE[-1:, 1:], band + 1, axis=0), 2 * panel))
    back, side, front = panel // 2, panel, panel + panel // 2
    for column in (0, side):
        builder.add_seam(skirt[:, column])
    builder.add_seam(skirt[-1])
    builder.add_seam(waistband[:, back])
    builder.add_ease(skirt[-1, ::-1], GATHERS)
    builder.add_wire(skirt[:, front], "Center front")
    builder.add_wire(skirt[:, back], "Center back")
    return builder.build("Gathered skirt", cloth="jersey", fairness=FAIRNESS)


def _rings(heights: np.ndarray, radii: np.ndarray, edges: int) -> np.ndarray:
    """Return points (r, edges + 1, 3) of closed ellipses with radii (r, 2) at heights (r,).

    Each ellipse begins at the left and runs over the back.
    """
    turn = np.linspace(0, 2 * np.pi, edges + 1)
    x, y = radii[:, :1] * np.cos(turn), radii[:, 1:] * np.sin(turn)
    points = np.stack([x, y, np.broadcast_to(heights[:, None], x.shape)], axis=-1)
    points[:, -1] = points[:, 0]
    return points
