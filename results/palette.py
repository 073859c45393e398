# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors and number texts that all pictures share; people with any color vision can distinguish them."""

from __future__ import annotations

import matplotlib
from matplotlib.colors import LinearSegmentedColormap

INK, FAINT_INK = "#22262e", "#6b7078"
CLOTH = "#ece8df"
TURNED_OVER = "#d6006e"
RIGID, ELASTIC = "#22262e", "#e08a00"

STEPS = 20  # colors of a scale: few enough to read a value off, and for pictures of 256 colors
# Shorter over unchanged to longer, dark in the middle: for lines on light cloth.
LENGTH_MAP = LinearSegmentedColormap.from_list("length", ["#1f9bff", "#1c5f9e", INK, "#b0480a", "#ff8a1f"], STEPS + 1)
RATIO_MAP = matplotlib.colormaps["YlGnBu"].resampled(STEPS)
ENERGY_MAP = matplotlib.colormaps["YlOrRd"].resampled(STEPS)


def use_style() -> None:
    matplotlib.use("Agg")
    matplotlib.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 9, "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": INK,
        "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False,
        "savefig.dpi": 125, "path.simplify": False, "path.snap": False,
    })  # fmt: skip


def percent(share: float, digits: int = 1) -> str:
    """Signed, such as +2.0% or −0.3%; plain 0 where it rounds to nothing."""
    text = f"{100 * share:+.{digits}f}%".replace("-", "−")
    return text if any(c in "123456789" for c in text) else "0%"


def plain_percent(share: float, digits: int = 1) -> str:
    """Without a sign; what is exact but for rounding is 0."""
    return "0%" if abs(share) < 1e-8 else f"{100 * abs(share):.{digits}f}%"
