# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a carnival mask: a piece with two holes. Wires connect the holes with each other and with the outline."""

from __future__ import annotations

import numpy as np

from .curves import chord_lengths, cubic_spline, even_parameters
from .shape import Shape, ShapeBuilder

# Outline of one half (x >= 0) in the plane, from the arch over the nose around cheek and temple to the brow, in meters.
OUTLINE = np.array(
    [
        [0.000, -0.017], [0.008, -0.021], [0.016, -0.034], [0.030, -0.042], [0.052, -0.037], [0.072, -0.021],
        [0.087, 0.004], [0.094, 0.026], [0.084, 0.034], [0.062, 0.033], [0.036, 0.033], [0.014, 0.026], [0.0, 0.022],
    ]
)  # fmt: skip
TEMPLE_KNOT = 7  # row of OUTLINE at the temple
BRIDGE = np.array([0.0, -0.0035])
EYE_CENTER = np.array([0.039, 0.0])
EYE_AXES = np.array([0.021, 0.011])
EYE_SLANT = np.radians(9)
FACE_RADIUS = 0.085
NOSE_RISE = 0.012


def mask(around: int = 72, rings: int = 9) -> Shape:
    """Return the mask, bent around a face. around: number of points around each eye."""
    builder = ShapeBuilder()
    below, above = around // 10, around // 12  # columns that end on the middle line below and above the bridge
    rays, temple = _half(around, rings, below, above)
    left, right = (builder.add_grid(_bend(rays * [side, 1]), flip=side > 0) for side in (1, -1))
    builder.add_wire(np.concatenate([left[-1, below::-1], left[-1, -2 : -2 - above : -1]]), "Middle")
    builder.add_wire(np.concatenate([left[:, 0], right[-2::-1, 0]]), "Nose bridge")
    builder.add_wire(left[:, temple], "Left temple")
    builder.add_wire(right[:, temple], "Right temple")
    return builder.build("Carnival mask", cloth="leather")


def _half(around: int, rings: int, below: int, above: int) -> tuple[np.ndarray, int]:
    """Return points (rings + 1, around + 1, 2) from the eye to the outline, and the column that ends at the temple.

    The outer ends of the columns run from the bridge of the nose down the middle line, along the outline, and back to
    the bridge.
    """
    # continued beyond the middle, so that the curve is smooth there
    mirrored = np.concatenate([OUTLINE[2:0:-1] * [-1, 1], OUTLINE, OUTLINE[-2:-4:-1] * [-1, 1]])
    knots = chord_lengths(mirrored)
    outline = cubic_spline(knots, mirrored)
    begin, tip, end = knots[2], knots[2 + TEMPLE_KNOT], knots[-3]
    length = around - below - above
    before = round(length * (tip - begin) / (end - begin))
    stretches = ((begin, tip, before), (tip, end, length - before))
    lower_edge, brow = (outline(even_parameters(outline, *stretch)) for stretch in stretches)
    curve = np.concatenate([lower_edge, brow[1:]])
    curve[[0, -1], 0] = 0.0
    lower, upper = (np.linspace(BRIDGE, end, n + 1) for end, n in ((OUTLINE[0], below), (OUTLINE[-1], above)))
    outer = np.concatenate([lower[:-1], curve, upper[::-1][1:]])
    outer[[0, -1]] = BRIDGE
    angle = np.unwrap(np.arctan2(*(outer - EYE_CENTER).T[::-1])) - EYE_SLANT
    eye = EYE_AXES * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    turn = np.array([[np.cos(EYE_SLANT), np.sin(EYE_SLANT)], [-np.sin(EYE_SLANT), np.cos(EYE_SLANT)]])
    inner = EYE_CENTER + eye @ turn
    share = np.linspace(0, 1, rings + 1)[:, None, None]
    return inner + (outer - inner) * share, below + before


def _bend(plane: np.ndarray) -> np.ndarray:
    """Return the planar points (..., 2), wrapped around a face that faces -y, with a rise for the nose."""
    x, z = plane[..., 0], plane[..., 1]
    nose = NOSE_RISE * np.exp(-((x / 0.016) ** 2)) / (1 + np.exp((z - 0.004) / 0.008))
    radius = FACE_RADIUS - 0.5 * z**2 / 0.12 + nose
    return np.stack([radius * np.sin(x / FACE_RADIUS), -radius * np.cos(x / FACE_RADIUS), z], axis=-1)
