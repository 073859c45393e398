# SPDX-License-Identifier: GPL-3.0-or-later
"""Places the grain arrow of a piece."""

from collections.abc import Sequence

import numpy as np

from .geometry import Rays, innermost_point
from .model import Line

GRAIN = 0.7  # length of the grain arrow, as a share of the piece's extent along the grain at this place


def grain_line(
    outlines: Sequence[np.ndarray],
    lines_inside: Sequence[np.ndarray],
    along: np.ndarray,
    limits: Sequence[np.ndarray] = (),
) -> Line:
    """Return the grain line at the place with the most room inside closed outlines (k,2) and between lines (k,2).

    The grain line may cross lines_inside, but not the open limits. along (2,): unit vector.
    """
    center, _ = innermost_point(outlines, [*lines_inside, *limits])
    rays = Rays(outlines, limits)
    up, down = (GRAIN * rays.length(center, sign * along) for sign in (1, -1))
    return Line("grain", center + np.array([-down * along, up * along]))
