# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the cover of an armchair: seat, arms and back with a round top edge, and arm fronts (Fig. 11)."""

from __future__ import annotations

import numpy as np

from .curves import coons_patch
from .shape import Shape, ShapeBuilder

# All lengths are in meters. In the plan, the wall of arms and back runs around the seat from the left arm's front to
# the right arm's front.
HALF_SEAT, FRONT, BACK, CORNER = 0.27, -0.36, 0.25, 0.10  # inner face: |x|, y of front and back, corner radius
THICKNESS = 0.15  # thickness of the wall
BOTTOM, SEAT, ARM, TOP = 0.06, 0.40, 0.60, 0.88  # heights of hem, seat seam, arms and back
# The wall rises from the arm to the back between these lengths from the arm's front.
RISE_BEGIN, RISE_END = 0.32, 0.90
# backward lean divided by the squared height above LEAN_BEGIN, 1/m; height at which the back begins to lean
RECLINE, LEAN_BEGIN = 0.26, 0.25
BACK_PUFF, FRONT_PUFF, SEAT_PUFF, NOSE = 0.035, 0.012, 0.055, 0.045  # bulge of the panels, the seat and its front edge
TOLERANCE = 0.05


def armchair_cover(
    arm: int = 13, corner: int = 5, back: int = 10, outside: int = 16, roll: int = 8, inside: int = 8, across: int = 4
) -> Shape:
    """Return the cover with a rigid line around its outside, and elastic lines along and across.

    The arguments are numbers of edges. arm, corner, back: along the wall, with half a corner; outside, roll, inside: up
    the wall, over its top and down; across: across an arm's front. The other edges of the roll are at the sides of this
    front.
    """
    builder = ShapeBuilder()
    wall = builder.add_grid(_wall(arm, corner, back, outside, roll, inside))
    last, apron, depth = wall.shape[1] - 1, outside - inside, arm + corner
    seat = builder.add_grid(_seat(builder.points(wall[-1]), depth, apron))
    builder.relax(_near_the_nose, 20)
    for column in (0, depth, last - depth, last):
        builder.add_seam(wall[:, column])
    for chain in (wall[outside], wall[-1], seat[: apron + 1, 0], seat[: apron + 1, -1]):
        builder.add_seam(chain)

    builder.add_wire(wall[outside // 2], "Outside line")
    builder.add_wire(wall[outside + roll // 2], "Top line", TOLERANCE)
    builder.add_wire(wall[outside + roll + inside // 2], "Inside line", TOLERANCE)
    over_back = wall[-2::-1, last // 2]
    builder.add_wire(np.concatenate([seat[:, seat.shape[1] // 2], over_back]), "Line, front to back", TOLERANCE)
    middle = arm // 2
    from_side_to_side = [wall[:, middle], seat[apron + middle, -2::-1], wall[-2::-1, last - middle]]
    builder.add_wire(np.concatenate(from_side_to_side), "Line, side to side", TOLERANCE)
    border = builder.points(np.concatenate([seat[: apron + 1, -1], wall[-2::-1, 0]]))
    panel = _arm_front(border, across)
    for mirror, name in ((1, "Left"), (-1, "Right")):
        grid = builder.add_grid(panel * [mirror, 1, 1], flip=mirror < 0)
        builder.add_wire(grid[:, across // 2], f"{name} arm front", TOLERANCE)
    return builder.build("Armchair cover", cloth="jersey")


def _wall(arm: int, corner: int, back: int, outside: int, roll: int, inside: int) -> np.ndarray:
    """Return the points (rows + 1, columns + 1, 3) of the wall.

    Rows run from the hem up the outside, over the top and down the inside to the seat. Columns run from the left arm's
    front around the back to the right arm's front.
    """
    angle = np.linspace(0, np.pi / 2, 2 * corner + 1)[1:-1, None]
    turn = np.concatenate([np.cos(angle), np.sin(angle)], axis=1)
    center = np.array([HALF_SEAT - CORNER, BACK - CORNER])
    side = np.linspace([HALF_SEAT, FRONT], [HALF_SEAT, BACK - CORNER], arm + 1)
    rear = np.linspace([HALF_SEAT - CORNER, BACK], [0, BACK], back // 2 + 1)
    plan = np.concatenate([side, center + CORNER * turn, rear])
    normal = np.concatenate([np.tile([1.0, 0.0], (len(side), 1)), turn, np.tile([0.0, 1.0], (len(rear), 1))])
    middle = plan + THICKNESS / 2 * normal
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(middle, axis=0), axis=1))])
    rise = np.clip((length - RISE_BEGIN) / (RISE_END - RISE_BEGIN), 0, 1)
    rise = rise**2 * (3 - 2 * rise)  # 0 along the arms, 1 along the back

    radius = THICKNESS / 2
    shoulder = ARM + (TOP - ARM) * rise - radius
    up = np.linspace(0, 1, outside + 1)[:, None]  # rows up to 0.5 are level
    phi, puff = np.linspace(0, np.pi, roll + 1)[1:-1, None], np.linspace(0, 1, inside + 1)[:, None]
    offset = np.concatenate([
        np.full((outside + 1, len(plan)), THICKNESS),
        np.broadcast_to(radius * (1 + np.cos(phi)), (roll - 1, len(plan))),
        -BACK_PUFF * rise * np.sin(np.pi * puff) ** 2,
    ])  # fmt: skip
    z = np.concatenate([
        BOTTOM + (ARM - radius - BOTTOM) * up + (shoulder - ARM + radius) * np.maximum(2 * up - 1, 0),
        shoulder + radius * np.sin(phi),
        shoulder + (SEAT - shoulder) * puff,
    ])  # fmt: skip
    lean = RECLINE * rise * np.maximum(z - LEAN_BEGIN, 0) ** 2
    points = np.concatenate([plan + offset[..., None] * normal, z[..., None]], axis=-1)
    points[..., 1] += lean
    points[:, -1, 0] = 0.0
    return np.concatenate([points, points[:, -2::-1] * [-1, 1, 1]], axis=1)


def _seat(inner: np.ndarray, depth: int, apron: int) -> np.ndarray:
    """Return the points (apron + depth + 1, c, 3) of front and seat.

    Rows run from the hem up the front and then back over the seat. Columns run from right to left. inner: edge of the
    wall around the seat, from the left arm's front to the right arm's front; depth: number of edges along each arm.
    """
    right, rear, left = inner[-1 : -depth - 2 : -1], inner[-depth - 1 : depth - 1 : -1], inner[: depth + 1]
    front = np.linspace(right[0], left[0], len(rear))
    flat = coons_patch(front, rear, left=right, right=left)
    below = front * [1, 1, 0] + np.linspace(BOTTOM, SEAT, apron + 1)[:-1, None, None] * [0, 0, 1]
    points = np.concatenate([below, flat])
    across = 1 - np.linspace(-1, 1, len(rear)) ** 4
    up, along = np.linspace(0, 1, apron + 1)[:-1, None], np.linspace(0, 1, depth + 1)[:, None]
    points[..., 1] -= NOSE * across * np.concatenate([up**3, (1 - along) ** 4])
    points[apron:, :, 2] += SEAT_PUFF * across * (1 - along**4) * (0.6 + 0.4 * np.sin(np.pi * along))
    return points


def _near_the_nose(points: np.ndarray) -> np.ndarray:
    """Return the share of relaxation of each point, 0 to 1. It rounds the seat's front edge between the arms."""
    x, y, z = points.T
    between, front, high = (HALF_SEAT - np.abs(x)) / 0.08, (FRONT + 0.16 - y) / 0.1, (z - 0.2) / 0.1
    return 0.6 * np.clip(between, 0, 1) * np.clip(front, 0, 1) * np.clip(high, 0, 1)


def _arm_front(border: np.ndarray, across: int) -> np.ndarray:
    """Return the points (r, across + 1, 3) of the left arm's front.

    border: from the hem up the inside of the arm, over its top and down the outside.
    """
    sides = (len(border) - 1 - across) // 2
    left, top, right = border[: sides + 1], border[sides : sides + across + 1], border[: -sides - 2 : -1]
    points = coons_patch(np.linspace(border[0], border[-1], across + 1), top, left, right)
    s, t = np.linspace(0, np.pi, across + 1), np.linspace(0, np.pi, sides + 1)[:, None]
    points[..., 1] -= FRONT_PUFF * np.sin(s) * np.sin(t)
    return points
