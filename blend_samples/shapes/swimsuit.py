# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a one-piece swimsuit on the torso: front and back of swim knit, which is stretched when worn."""

from __future__ import annotations

import numpy as np

from . import bodice, torso
from .curves import chord_lengths, cubic_spline
from .shape import Shape, ShapeBuilder

NECK_DEPTH = {1: 0.80, -1: 0.95}  # of front (1) and back (-1): depth of bodice.neckline()
# as bodice.ARMHOLE, with straps instead of shoulders
ARMHOLE = np.array(
    [
        [0.1700, -1.0], [0.1660, -0.97], [0.1480, -0.88], [0.1280, -0.70], [0.1170, -0.45], [0.1150, -0.2],
        [0.1160, 0.0], [0.1160, 0.2], [0.1170, 0.45], [0.1230, 0.70], [0.1430, 0.88], [0.1640, 0.97], [0.1700, 1.0],
    ]
)  # fmt: skip
# Leg opening of front (1) and back (-1) from the side seam to the crotch seam: longitude in degrees, and v.
LEG = {
    1: np.array([[90, 0.16], [66, 0.075], [45, -0.015], [27, -0.100], [16, -0.165], [12.5, torso.CROTCH_V]]),
    -1: np.array([[90, 0.16], [76, 0.05], [60, -0.045], [40, -0.120], [20, -0.175], [12.5, torso.CROTCH_V]]),
}
STRETCH = (0.15, 0.10)  # stretch of the fabric when worn, across and along the grain


def swimsuit(
    strap: int = 4, neck: int = 20, leg: int = 20, waist: int = 5, ribs: int = 10, side: int = 4, armhole: int = 14
) -> Shape:
    """Return the suit with rigid bust, waist and middle lines. The arguments are numbers of edges along sections."""
    builder = ShapeBuilder()
    columns, hem, bust = 2 * strap + neck, leg + waist, leg + waist + ribs
    grids = {}
    for half in (1, -1):
        body = torso.Half(half)
        rows = _lower_rows(body, leg, waist, ribs, columns)
        stub = np.linspace(rows[-1][-1], [np.pi / 2, torso.UNDERARM_V], side + 1)
        left = np.concatenate([stub[:-1], bodice.evenly(body, bodice.armhole(half, ARMHOLE), armhole)])
        upper = bodice.upper_edge(body, left[-1], NECK_DEPTH[half], strap, neck)
        block = bodice.upper_block(rows[-1], left, upper, body)
        points = body.points(*np.moveaxis(np.concatenate([rows[:-1], block]), -1, 0))
        grids[half] = builder.add_grid(points, flip=half < 0)
        for edge in (0, -1):
            builder.add_seam(grids[half][leg : bust + side + 1, edge])
        builder.add_seam(grids[half][-1, : strap + 1])
        builder.add_seam(grids[half][-1, columns - strap :])
        builder.add_wire(grids[half][:, columns // 2], "Center front" if half > 0 else "Center back")
    builder.add_seam(grids[1][0])
    for row, name in ((bust, "Bust line"), (hem, "Waist line")):
        builder.add_wire(np.concatenate([grids[1][row], grids[-1][row, -2::-1]]), name)
    return builder.build("Swimsuit", cloth="swim", stretch=STRETCH)


def _lower_rows(body: torso.Half, leg: int, waist: int, ribs: int, columns: int) -> np.ndarray:
    """Return longitudes and v (leg + waist + ribs + 1, columns + 1, 2) of level rows, from crotch to bust line."""
    opening = LEG[body.side] * [np.pi / 180, 1]
    curve = cubic_spline(chord_lengths(opening), opening)(np.linspace(1, 0, 1601))
    edge = bodice.evenly(body, curve, leg)
    levels = torso.v_at_height(torso.WAIST), torso.v_at_height(torso.BUST)
    above = np.concatenate([np.linspace(edge[-1, 1], levels[0], waist + 1)[1:], np.linspace(*levels, ribs + 1)[1:]])
    edge = np.concatenate([edge, np.column_stack([np.full_like(above, np.pi / 2), above])])
    return np.array([bodice.level_row(body, v, -phi, phi, columns) for phi, v in edge])
