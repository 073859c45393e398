# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the two pictures of docs/benchmarks.md: time against size, and distortion against length errors."""

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import flatteners
import matplotlib.pyplot as plt
from comparison import Comparison
from matplotlib.axes import Axes
from palette import FAINT_INK, INK
from peer_tables import growth
from save_picture import save

LEAST_ERROR = 1e-16  # relative; smaller errors are drawn as this error, because a logarithmic axis has no 0
MARKER_SIZE = 6  # points
SAME_ENERGY = 0.05  # relative; with a smaller difference of energy, markers would cover each other
COLORS = {"wirewarp": "#0072b2", "refined": "#d55e00", "libigl": "#009e73", "Blender": "#8a6fb0"}
MARKERS = {
    flatteners.WARPING: "o",
    flatteners.WARPED_ELASTIC: "s",
    flatteners.REFINED: "o",
    "refined, 8 rigid wires": "^",
    flatteners.REFINED_ELASTIC: "s",
    flatteners.ARAP: "o",
    flatteners.ARAP_CONVERGED: "D",
    flatteners.SLIM: "^",
    flatteners.SLIM_CONVERGED: "v",
    flatteners.ANGLE_BASED: "o",
    flatteners.CONFORMAL: "s",
    flatteners.MINIMUM_STRETCH: "^",
}


def style(name: str) -> dict:
    """Return the style of a method. Methods of the same program have the same color and different markers."""
    color = next(color for start, color in COLORS.items() if name.startswith(start))
    return {
        "color": color,
        "marker": MARKERS[name],
        "markersize": MARKER_SIZE,
        "markerfacecolor": "none",
        "markeredgewidth": 1.4,
    }


def plot_times(comparisons: Sequence[Comparison], path: Path) -> None:
    with picture(path, 4.8, "Method: exponent of growth") as axes:
        for name in MARKERS:
            sizes, seconds, exponent = growth(comparisons, name)
            if sizes:
                label = name if exponent is None else f"{name}: {exponent:.2f}"
                axes.plot(sizes, seconds, linewidth=1.2, label=label, **style(name))
        axes.set(xscale="log", yscale="log", xlabel="triangles", ylabel="seconds on one core")


def plot_lengths(comparison: Comparison, path: Path) -> None:
    with picture(path, 4.2, "Method") as axes:
        energies: list[float] = []
        for name in MARKERS:
            if outcome := comparison.outcomes.get(name):
                error = max(outcome.edge_error, LEAST_ERROR)
                # If energies are nearly the same, later markers are larger, so that all markers can be seen.
                around = sum(math.isclose(outcome.energy, energy, rel_tol=SAME_ENERGY) for energy in energies)
                energies.append(outcome.energy)
                look = style(name) | {"markersize": MARKER_SIZE * (1 + around / 2)}
                axes.plot(error, outcome.energy, linestyle="", label=name, **look)
        axes.set(xscale="log", xlabel="worst length error of an edge of outline or wires, relative", xlim=(1e-16, 1))
        axes.set_ylabel("distortion: ARAP energy over area")
        axes.set_ylim(bottom=0)
        axes.axvline(1e-9, color=INK, linewidth=0.8, linestyle=":")
        axes.text(1.5e-9, 0.97, "guaranteed: 1e-9", transform=axes.get_xaxis_transform(), va="top", color=FAINT_INK)


@contextmanager
def picture(path: Path, height: float, legend: str) -> Iterator[Axes]:
    """Yield axes with a grid, and beside them the legend with this title. height: inches."""
    figure, axes = plt.subplots(figsize=(8.4, height), layout="constrained")
    yield axes
    axes.grid(color=FAINT_INK, alpha=0.2, linewidth=0.6)
    axes.legend(title=legend, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, alignment="left")
    save(figure, path)
