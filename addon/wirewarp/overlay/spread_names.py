# SPDX-License-Identifier: GPL-3.0-or-later
"""Names on the screen that do not cover each other. No Blender in here."""

from collections.abc import Sequence

import numpy as np

MARGIN = 0.3  # around each text, in its heights
STEPS = (0, 1, -1, 2, -2)  # lines of text that a name may stand higher or lower than it should


def spread(places: Sequence[tuple[float, float]], sizes: Sequence[tuple[float, float]]) -> list[float | None]:
    """How much higher each text is to stand, earlier ones before later ones; None where there is no room for it.

    places are the lower left corners, sizes the widths and heights.
    """
    lifts: list[float | None] = []
    taken = np.empty((0, 4))  # left, bottom, right, top
    for (left, bottom), (width, height) in zip(places, sizes, strict=True):
        for step in STEPS:
            lift, room = 1.6 * step * height, MARGIN * height
            box = np.array([left, bottom + lift, left + width, bottom + lift + height]) + [-room, -room, room, room]
            if not ((box[:2] < taken[:, 2:]) & (taken[:, :2] < box[2:])).all(axis=1).any():
                taken = np.vstack([taken, box])
                lifts.append(lift)
                break
        else:
            lifts.append(None)
    return lifts
