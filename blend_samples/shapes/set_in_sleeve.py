# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the left half of a jacket's bodice with a set-in sleeve, whose head is eased into the armhole."""

from __future__ import annotations

import numpy as np

from . import bodice, torso
from .curves import chord_lengths, hermite_curves
from .shape import Shape, ShapeBuilder

NECK_DEPTH = {1: 0.30, -1: 0.08}  # of front (1) and back (-1): depth of bodice.neckline()
# Centers of elbow and cuff, and their radii from the underarm to the shoulder side and from front to back, in meters.
ELBOW, CUFF = np.array([0.308, 0.004, 0.225]), np.array([0.404, -0.026, -0.005])
ELBOW_RADII, CUFF_RADII = np.array([0.062, 0.066]), np.array([0.048, 0.052])
UPPER_ARM, FOREARM = np.array([0.44, 0.02, -0.898]), np.array([0.36, -0.14, -0.922])  # directions
LEAVE = np.array([0.92, 0.0, -0.39])  # direction of the sleeve at the armhole
ELBOW_SPEED = 0.24  # meters: velocity of the curves at the elbow, about the distance from the elbow to the armhole
CAP_FULLNESS = 0.22  # meters: distance from the armhole over which the sleeve is straight before it bends to the arm
EASE = 0.09  # ease of the sleeve head between its notches; the part under the arm has no ease
NOTCH = 0.36  # position of the notches, as a share of the way from the underarm to the shoulder
TOLERANCE = 0.05


def set_in_sleeve(
    shoulder: int = 3, neck: int = 16, ribs: int = 12, side: int = 4, armhole: int = 16, upper: int = 16, fore: int = 14
) -> Shape:
    """Return front, back and sleeve with an elastic line down each of them, and rigid bust and upper-arm lines.

    The arguments are numbers of edges along the sections; neck includes both halves.
    """
    builder = ShapeBuilder()
    grids, armholes = {}, {}
    for half in (1, -1):
        body = torso.Half(half)
        both = body.points(*np.moveaxis(_panel(body, shoulder, neck, ribs, side, armhole), -1, 0))
        grids[half] = builder.add_grid(both[:, shoulder + neck // 2 :], flip=half < 0)
        armholes[half] = both[ribs + side :, -1]
        builder.add_seam(grids[half][:, -1])
        builder.add_seam(grids[half][-1, neck // 2 :])
        builder.add_wire(grids[half][:, neck // 3], "Front line" if half > 0 else "Back line", TOLERANCE)
    builder.add_wire(np.concatenate([grids[1][ribs], grids[-1][ribs, -2::-1]]), "Bust line")

    loop = np.concatenate([armholes[1], armholes[-1][-2::-1]])  # from the underarm up the front and down the back
    sleeve = builder.add_grid(_sleeve(loop, upper, fore), flip=True)
    builder.add_seam(sleeve[:, 0])
    builder.add_wire(sleeve[::-1, armhole], "Sleeve middle", TOLERANCE)
    builder.add_wire(sleeve[upper // 2], "Upper-arm line")
    notch = round(NOTCH * armhole)
    builder.add_ease(sleeve[0, notch : len(loop) - notch][::-1], EASE)
    return builder.build("Set-in sleeve", cloth="jersey")


def _panel(body: torso.Half, shoulder: int, neck: int, ribs: int, side: int, armhole: int) -> np.ndarray:
    """Return longitudes and v (r, c, 2) of the whole front or back, from the waist to the shoulders."""
    columns = 2 * shoulder + neck
    levels = np.linspace(torso.v_at_height(torso.WAIST), torso.v_at_height(torso.BUST), ribs + 1)
    rows = np.array([bodice.level_row(body, v, -np.pi / 2, np.pi / 2, columns) for v in levels])
    stub = np.linspace(rows[-1, -1], [np.pi / 2, torso.UNDERARM_V], side + 1)
    left = np.concatenate([stub[:-1], bodice.evenly(body, bodice.armhole(body.side), armhole)])
    upper = bodice.upper_edge(body, left[-1], NECK_DEPTH[body.side], shoulder, neck)
    return np.concatenate([rows[:-1], bodice.upper_block(rows[-1], left, upper, body, straight=True)])


def _sleeve(armhole: np.ndarray, upper: int, fore: int) -> np.ndarray:
    """Return points (upper + fore + 1, c, 3) of the sleeve from the armhole over the elbow to the cuff.

    armhole (c, 3): a closed loop from the underarm.
    """
    half = len(armhole) // 2
    around = np.concatenate([chord_lengths(armhole[: half + 1]), 1 + chord_lengths(armhole[half:])[1:]])
    elbow = _ring(ELBOW, UPPER_ARM + FOREARM, ELBOW_RADII, np.pi * around)
    cuff = _ring(CUFF, FOREARM, CUFF_RADII, np.pi * around)
    bend = ELBOW_SPEED * (UPPER_ARM + FOREARM) / 2
    above = hermite_curves(armhole, CAP_FULLNESS * LEAVE, elbow, bend, upper)
    below = hermite_curves(elbow, bend * fore / upper, cuff, bend * fore / upper, fore)
    return np.concatenate([above, below[1:]])


def _ring(center: np.ndarray, axis: np.ndarray, radii: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """Return points (n, 3) of an ellipse across the arm. Angle 0 is under the arm, and pi/2 is in front."""
    axis = axis / np.linalg.norm(axis)
    across = np.cross(axis, [0, 1, 0])  # from the underarm to the shoulder
    front = np.cross(axis, across)
    ring = -np.cos(angle)[:, None] * across * radii[0] + np.sin(angle)[:, None] * front * radii[1]
    return center + ring
