# SPDX-License-Identifier: GPL-3.0-or-later
"""Tolerances as the panel writes them. No Blender in here."""

import math


def tolerance_text(tolerance: float) -> str:
    """A rigid, an elastic or a free (super-elastic) wire: "rigid", "±3%", "free"."""
    if tolerance == 0:
        return "rigid"
    return "free" if math.isinf(tolerance) else f"±{100 * tolerance:.3g}%"
