# SPDX-License-Identifier: GPL-3.0-or-later
"""Names on the screen that do not cover each other. No Blender in here."""

from collections.abc import Sequence

import numpy as np

MARGIN = 0.3  # around each text, in its heights
ABOVE, BELOW = 0.5, -1.5  # its lower edge from the point where it stands, in its heights

Corner = tuple[float, float]


def spread(points: Sequence[np.ndarray], sizes: Sequence[tuple[float, float]]) -> list[Corner | None]:
    """The lower left corner of each text, earlier ones before later ones; None where there is no room for it.

    points: for each text those (c,2) above or below the middle of which it may stand, the best first; sizes: the
    widths and heights.
    """
    corners: list[Corner | None] = []
    taken = np.empty((0, 4))  # left, bottom, right, top
    for own, (width, height) in zip(points, sizes, strict=True):
        room = MARGIN * height
        left, bottom = own[:, 0].repeat(2) - width / 2, (own[:, 1:] + [ABOVE * height, BELOW * height]).ravel()
        boxes = np.column_stack([left - room, bottom - room, left + width + room, bottom + height + room])
        overlap = (boxes[:, None, :2] < taken[:, 2:]) & (taken[:, :2] < boxes[:, None, 2:])
        free = np.flatnonzero(~np.any(np.all(overlap, axis=2), axis=1))
        if len(free):
            taken = np.vstack([taken, boxes[free[0]]])
            corners.append((float(left[free[0]]), float(bottom[free[0]])))
        else:
            corners.append(None)
    return corners
