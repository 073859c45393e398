# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a plush bear: body and head with darts, arms with paws, legs with soles, and ears in halves (Fig. 11)."""

from __future__ import annotations

import numpy as np

from .curves import chord_lengths, cubic_spline, even_parameters
from .fan import add_sector
from .limbs import Hole, add_cap, tube
from .shape import Shape, ShapeBuilder

# Radius and height of the body from its bottom to the neck, and of the head from the neck to its top, in meters.
BODY = np.array([
    [0.000, 0.000], [0.042, 0.005], [0.067, 0.028], [0.074, 0.058], [0.067, 0.092], [0.050, 0.118], [0.038, 0.130],
])  # fmt: skip
HEAD = np.array([
    [0.038, 0.130], [0.053, 0.139], [0.067, 0.161], [0.072, 0.187], [0.064, 0.216], [0.040, 0.237], [0.000, 0.244],
])  # fmt: skip
DEPTH = 0.94  # size from front to back divided by size from side to side
SNOUT = np.array([0.0, -0.072, 0.176])
SNOUT_RISE, SNOUT_SIZE = 0.017, 0.034
GORES, FAN_ROWS = 6, 8
COLUMNS = GORES * FAN_ROWS
FIRST_LONGITUDE = np.radians(150)  # longitude of column 0; the front is at 0 and the seam of the left arm at 90 degrees
FRONT, LEFT_LEG, LEFT_ARM, RIGHT_ARM, RIGHT_LEG = 28, 32, 40, 16, 24  # columns
LEFT_BACK, MIDDLE_BACK, RIGHT_BACK = 0, 4, 8
ARM_CENTER, ARM_AXIS, ARM_RADIUS = np.array([0.120, -0.020, 0.080]), np.array([0.90, -0.32, -0.28]), 0.020
LEG_CENTER, LEG_AXIS, LEG_RADIUS = np.array([0.066, -0.118, 0.027]), np.array([0.36, -0.93, 0.02]), 0.027
EAR_RADIUS, EAR_REACH, EAR_BULGE = 0.026, 0.020, 0.007
EAR_SPAN = np.radians(176)
TOLERANCE = 0.05


def toy(body_rows: int = 15, head_rows: int = 14, limb_rows: int = 9, ear_rows: int = 6) -> Shape:
    """Return the bear with elastic lines around belly, head, arms and legs and down the middle of the front."""
    builder = ShapeBuilder()
    legs = [Hole(1, column, 4, 2) for column in (LEFT_LEG, RIGHT_LEG)]
    arms = [Hole(body_rows - 7, column, 4, 2) for column in (LEFT_ARM, RIGHT_ARM)]
    ears = [Hole(head_rows - 7, column, 6, 1) for column in (LEFT_ARM, RIGHT_ARM)]
    belly, back = range(5, body_rows - 7), range(1, 5)
    face, nape = range(head_rows - 6, head_rows - 2), range(head_rows - 2, head_rows)
    body = _add_trunk(builder, "body", BODY, body_rows, [*legs, *arms], belly, back, pole_first=True)
    head = _add_trunk(builder, "head", HEAD, head_rows, ears, face, nape, pole_first=False)
    for chain in (body[-1], body[:, MIDDLE_BACK], head[:, MIDDLE_BACK], head[: head_rows - 5, FRONT]):
        builder.add_seam(chain)
    builder.add_wire(body[body_rows // 2], "Belly line", TOLERANCE)
    builder.add_wire(head[4], "Head line", TOLERANCE)
    builder.add_wire(body[:, FRONT], "Middle of the belly", TOLERANCE)
    left_arm = tube(builder.points(arms[0].loop(body)), ARM_CENTER, ARM_AXIS, ARM_RADIUS, 0.035, limb_rows)
    left_leg = tube(builder.points(legs[0].loop(body)), LEG_CENTER, LEG_AXIS, LEG_RADIUS, 0.05, limb_rows)
    for mirror, side in ((1, "Left"), (-1, "Right")):
        for points, radius, name, end in ((left_arm, ARM_RADIUS, "arm", "paw"), (left_leg, LEG_RADIUS, "leg", "sole")):
            grid = builder.add_grid(points * [mirror, 1, 1], flip=mirror < 0)
            cap = add_cap(builder, points[-1] * [mirror, 1, 1], 0.25 * radius, flip=mirror < 0)
            builder.add_group(grid, f"{side} {name}")
            builder.add_group(cap, f"{side} {end}")
            for chain in (grid[0], grid[-1], grid[:, 0]):
                builder.add_seam(chain)
            builder.add_wire(grid[limb_rows // 2], f"{side} {name} line", TOLERANCE)
        _add_ear(builder, builder.points(ears[0].loop(head)), ear_rows, mirror, f"{side} ear")
    return builder.build("Toy", cloth="minky", allowance=5.0)


def _add_trunk(
    builder: ShapeBuilder,
    name: str,
    outline: np.ndarray,
    rows: int,
    holes: list[Hole],
    front: range,
    back: range,
    pole_first: bool,
) -> np.ndarray:
    """Add the body or the head. Return the grid (rows + 1, COLUMNS + 1) between the fan around the pole and the neck.

    front, back: rows in which two seams are left out, so that three gores are joined. The rest of these seams are
    darts. pole_first: true for the body, whose grid begins at its pole.
    """
    if not pole_first:
        outline = outline[::-1]
    profile = cubic_spline(chord_lengths(outline), outline)
    share = FAN_ROWS / (FAN_ROWS + rows * 1.12)  # share of the profile's length that the fan covers
    fan_at = even_parameters(profile, 0.0, share, FAN_ROWS)
    grid_at = even_parameters(profile, share, 1.0, rows)
    fans = []
    for gore in range(GORES):
        begin, end = FIRST_LONGITUDE + 2 * np.pi / GORES * np.array([gore, gore + 1])
        fan = add_sector(
            builder, lambda row, at: _around(profile(fan_at[row]), at), begin, end, FAN_ROWS, flip=pole_first
        )
        builder.add_seam(np.array([row[0] for row in fan]))
        fans += fan
    longitudes = FIRST_LONGITUDE + np.linspace(0, 2 * np.pi, COLUMNS + 1)
    points = np.array([_around(profile(at), longitudes) for at in (grid_at if pole_first else grid_at[::-1])])
    missing = np.zeros((rows, COLUMNS), dtype=bool)
    for hole in holes:
        hole.cut(missing)
    grid = builder.add_grid(points, holes=missing)
    builder.add_group(np.concatenate([*fans, *grid]), name)
    joined = dict.fromkeys((LEFT_LEG, RIGHT_LEG), front) | dict.fromkeys((LEFT_BACK, RIGHT_BACK), back)
    for column in range(0, COLUMNS, FAN_ROWS):
        without_seam = {row for hole in holes if hole.column == column for row in range(hole.row, hole.row + hole.rows)}
        for row in sorted({*range(rows)} - without_seam - {*joined.get(column, ())}):
            builder.add_seam(grid[row : row + 2, column])
    return grid


def _around(profile_point: np.ndarray, longitudes: np.ndarray) -> np.ndarray:
    """Return points (n, 3) at these longitudes (n,) and the height of the profile point, with the snout."""
    radius, height = profile_point
    x, y = radius * np.sin(longitudes), -radius * DEPTH * np.cos(longitudes)
    points = np.stack([x, y, np.full_like(x, height)], axis=-1)
    distance = np.linalg.norm((points - SNOUT) * [1, 1, 1.15], axis=1)
    return points + SNOUT_RISE * np.exp(-((distance / SNOUT_SIZE) ** 3))[:, None] * [0, -1, -0.15]


def _add_ear(builder: ShapeBuilder, left_loop: np.ndarray, rows: int, mirror: int, name: str) -> None:
    """Add two halves of an ear between the hole's border and a round edge, along which they are sewn together."""
    half = len(left_loop) // 2
    bottom, top = left_loop[0], left_loop[half]
    along = (top - bottom) / np.linalg.norm(top - bottom)
    out = np.array([along[2], 0.0, -along[0]])
    across = np.linspace(-1, 1, half + 1)[:, None]
    angle = across * EAR_SPAN / 2
    rim = (bottom + top) / 2 + EAR_REACH * out + EAR_RADIUS * (np.sin(angle) * along + np.cos(angle) * out)
    t = np.linspace(0, 1, rows + 1)[:, None, None]
    halves = []
    for front, base in ((1, left_loop[half:][::-1]), (-1, left_loop[: half + 1])):
        bulge = EAR_BULGE * front * np.sin(np.pi * t) * np.cos(across * np.pi / 2) * [0, -1.0, 0]
        points = ((1 - t) * base + t * rim + bulge) * [mirror, 1, 1]
        grid = builder.add_grid(points, flip=front * mirror > 0)
        for chain in (grid[0], grid[-1], grid[:, 0], grid[:, -1]):
            builder.add_seam(chain)
        halves.append(grid)
    builder.add_group(np.concatenate(halves), name)
