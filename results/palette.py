# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines colors and number formats of all pictures. People with any color vision can distinguish the colors."""

from __future__ import annotations

import matplotlib
from matplotlib.colors import LinearSegmentedColormap

INK, FAINT_INK = "#22262e", "#6b7078"
CLOTH = "#ece8df"
TURNED_OVER = "#d6006e"
RIGID, ELASTIC = "#22262e", "#e08a00"

STEPS = 20  # number of colors of a scale: few, so that values can be read, and so that a picture needs only 256 colors
# Colors of lines on a light surface: blue if shorter, dark if unchanged, orange if longer.
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
    """Return a percentage with its sign, such as +2.0% or −0.3%, or "0%" if it rounds to zero."""
    text = f"{100 * share:+.{digits}f}%".replace("-", "−")
    return text if any(c in "123456789" for c in text) else "0%"


def plain_percent(share: float, digits: int = 1) -> str:
    """Return a percentage without a sign. Rounding errors are shown as 0, and other small values as "<0.1%"."""
    if abs(share) < 1e-8:
        return "0%"
    return f"{100 * abs(share):.{digits}f}%" if 100 * abs(share) >= 0.5 * 10**-digits else f"<{10**-digits:.{digits}f}%"
