# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a fitted top on the torso: front, back and two short sleeves."""

from __future__ import annotations

import numpy as np

from . import bodice, torso
from .curves import chord_lengths, hermite_curves
from .shape import Shape, ShapeBuilder

NECK_DEPTH = {1: 0.40, -1: 0.12}  # of front (1) and back (-1): depth of bodice.neckline()
CUFF_CENTER = np.array([0.285, 0.005, 0.385])
CUFF_RADII = np.array([0.058, 0.064])  # meters: from the underarm to the shoulder side, and from front to back
ARM = np.array([0.76, 0.0, -0.65]) / np.hypot(0.76, 0.65)  # direction of the left arm
CAP_FULLNESS = 0.16  # meters: distance from the armhole over which the sleeve is straight before it bends to the arm


def fitted_top(
    shoulder: int = 8, neck: int = 16, hem: int = 11, ribs: int = 10, side: int = 4, armhole: int = 14, sleeve: int = 12
) -> Shape:
    """Return the top with rigid bust, waist, upper-arm and middle lines.

    The arguments are numbers of edges along the sections.
    """
    builder = ShapeBuilder()
    bust, underarm, columns = hem + ribs, hem + ribs + side, 2 * shoulder + neck
    grids, armholes = {}, {}
    for half in (1, -1):
        rows = _lower_rows(half, hem, ribs, columns)
        block = _upper_block(half, rows[-1], shoulder, neck, side, armhole)
        points = torso.Half(half).points(*np.moveaxis(np.concatenate([rows[:-1], block]), -1, 0))
        grids[half] = builder.add_grid(points, flip=half < 0)
        armholes[half] = points[underarm:, -1]  # of the left arm
        for edge in (0, -1):
            builder.add_seam(grids[half][:, edge])
        builder.add_seam(grids[half][-1, : shoulder + 1])
        builder.add_seam(grids[half][-1, columns - shoulder :])
        builder.add_wire(grids[half][:, columns // 2], "Center front" if half > 0 else "Center back")
    for row, name in ((bust, "Bust line"), (hem, "Waist line")):
        builder.add_wire(np.concatenate([grids[1][row], grids[-1][row, -2::-1]]), name)

    loop = np.concatenate([armholes[1], armholes[-1][-2::-1]])  # from the underarm up the front and down the back
    for arm, name in ((1, "Left"), (-1, "Right")):
        grid = builder.add_grid(_sleeve(loop, sleeve) * [arm, 1, 1], flip=arm > 0)
        builder.add_seam(grid[:, 0])
        builder.add_group(grid, f"{name} sleeve")
        builder.add_wire(grid[::-1, armhole], f"{name} sleeve middle")
        builder.add_wire(grid[sleeve // 2], f"{name} upper-arm line")
    return builder.build("Fitted top", cloth="jersey")


def _lower_rows(half: int, hem: int, ribs: int, columns: int) -> np.ndarray:
    """Return longitudes and v (hem + ribs + 1, columns + 1, 2) of level rows from the hip to the bust line."""
    heights = np.concatenate([np.linspace(0, torso.WAIST, hem + 1), np.linspace(torso.WAIST, torso.BUST, ribs + 1)[1:]])
    levels = [torso.v_at_height(z) for z in heights]
    return np.array([bodice.level_row(torso.Half(half), v, -np.pi / 2, np.pi / 2, columns) for v in levels])


def _upper_block(half: int, bust: np.ndarray, shoulder: int, neck: int, side: int, armhole: int) -> np.ndarray:
    """Return longitudes and v of the rows from the bust line up to shoulders and neckline, between the armholes."""
    body = torso.Half(half)
    stub = np.linspace(bust[-1], [np.pi / 2, torso.UNDERARM_V], side + 1)
    left = np.concatenate([stub[:-1], bodice.evenly(body, bodice.armhole(half), armhole)])
    return bodice.upper_block(bust, left, bodice.upper_edge(body, left[-1], NECK_DEPTH[half], shoulder, neck), body)


def _sleeve(armhole: np.ndarray, rows: int) -> np.ndarray:
    """Return points (rows + 1, c, 3) of the left sleeve from the armhole to the cuff.

    armhole (c, 3): a closed loop from the underarm.
    """
    half = len(armhole) // 2
    angle = np.concatenate(
        [np.pi * chord_lengths(armhole[: half + 1]), np.pi * (1 + chord_lengths(armhole[half:])[1:])]
    )
    across = np.array([-ARM[2], 0.0, ARM[0]])  # from the underarm to the shoulder
    ring = -np.cos(angle)[:, None] * across * CUFF_RADII[0] - np.sin(angle)[:, None] * [0, CUFF_RADII[1], 0]
    leave, arrive = CAP_FULLNESS * np.array([0.9, 0.0, -0.43]), CAP_FULLNESS * ARM
    return hermite_curves(armhole, leave, CUFF_CENTER + ring, arrive, rows)
