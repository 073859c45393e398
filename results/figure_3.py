# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on Fig. 3: is E(h) continuous? The core computes E and its exact derivative along each h."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from inputs import Inputs
from palette import percent
from save_picture import save
from shapes import Shape
from text import count, picture

LIMIT, STEPS = 0.15, 150
KINK = 0.2  # share of the range of the derivative; a larger change within a step counts as a kink
PIECES = {  # titles by name of the sample and index of the piece
    ("Fitted top", 0): "front of the fitted top",
    ("Wetsuit upper body", 0): "front of the wetsuit",
    ("Wetsuit collar", 0): "wetsuit collar",
    ("Quarter sphere", 0): "quarter sphere",
}
COLORS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00")
DASHES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1)))


@dataclass(frozen=True)
class Curve:
    name: str  # name of the wire
    variation: np.ndarray  # (k,) values of h
    error: np.ndarray  # (k,) values of E; nan if ψ(h) does not exist
    slope: np.ndarray  # (k,) derivative of E


def surface_text(shape: Shape) -> str:
    """Return the surface in the format that the program wirewarp_error_curves reads."""
    faces = shape.triangles()
    sizes = (len(shape.vertices), len(faces), len(shape.seams), len(shape.wires))
    rows = [sizes, *shape.vertices.tolist(), *faces.tolist(), *shape.seams.tolist()]
    rows += [(len(wire.vertices), *wire.vertices) for wire in shape.wires]
    return "\n".join(" ".join(repr(number) for number in row) for row in rows)


def error_curves(program: Path, shape: Shape, piece: int) -> list[Curve]:
    """Return a curve for each part of a wire in the piece."""
    command = [str(program), str(piece), str(LIMIT), str(STEPS)]
    answer = subprocess.run(command, input=surface_text(shape), capture_output=True, text=True, check=True).stdout
    table = np.array([line.split() for line in answer.splitlines()], dtype=float)
    curves = []
    for wire, part in np.unique(table[:, :2].astype(int), axis=0):
        rows = table[(table[:, 0] == wire) & (table[:, 1] == part)]
        curves.append(Curve(shape.wires[wire].name, *rows[:, 2:].T))
    return curves


def kinks(curves: dict[str, list[Curve]]) -> list[str]:
    """Return a phrase for each place at which a derivative jumps."""
    found = []
    for title, pieces in curves.items():
        for curve in pieces:
            jump = np.abs(np.diff(curve.slope)) / np.ptp(curve.slope[np.isfinite(curve.slope)])
            for k in np.flatnonzero(jump > KINK):
                at = (curve.variation[k] + curve.variation[k + 1]) / 2
                found.append(f"{title}, {curve.name}, at *h* = {percent(at)}")
    return found


def verdict(found: list[str]) -> str:
    if not found:
        return "No derivative jumps: in this range *E* is as smooth as the paper finds it on its patches."
    return f"""The derivative jumps in {count(len(found), "place", "places")}: {"; ".join(found)}. At these
values of *h*, *ψ(h)* switches to another minimum of Eq. (1). A wire that is too long must bend to one side, and *E* has
a kink or a step at the length at which the bending starts. *E* is therefore not twice differentiable everywhere,
although the paper concludes from its patches that it is. The search for the best lengths still works, because it
only accepts lengths with a lower *E*."""


def draw(curves: dict[str, list[Curve]], path: Path) -> None:
    figure, axes = plt.subplots(2, len(curves), figsize=(3.0 * len(curves), 5.2), sharex=True, squeeze=False)
    for column, (title, pieces) in enumerate(curves.items()):
        upper, lower = axes[:, column]
        for k, curve in enumerate(pieces):
            style = {"color": COLORS[k], "linestyle": DASHES[k], "linewidth": 1.8}
            upper.plot(100 * curve.variation, curve.error, label=curve.name, **style)
            lower.plot(100 * curve.variation, curve.slope, **style)
        upper.set_title(title[0].upper() + title[1:], fontsize=10)
        upper.set_ylim(bottom=0)
        upper.legend(fontsize=7.5, frameon=False)
        lower.axhline(0, color="#6b7078", linewidth=0.6)
        lower.set_xlabel("length variation $h$ of the wire, %")
        for panel in (upper, lower):
            panel.grid(color="#e4e2dd", linewidth=0.6)
    axes[0, 0].set_ylabel("$E(\\psi(h))$")
    axes[1, 0].set_ylabel("$\\partial E/\\partial h$")
    figure.tight_layout()
    save(figure, path)


def section(inputs: Inputs) -> str:
    curves = {
        title: error_curves(inputs.error_curves, inputs.shapes[name], piece) for (name, piece), title in PIECES.items()
    }
    path = inputs.pictures / "figure_3.png"
    draw(curves, path)
    missing = sum(int(np.isnan(curve.error).sum()) for pieces in curves.values() for curve in pieces)
    exists = "*ψ(h)* exists at all values" if missing == 0 else f"*ψ(h)* does not exist at {missing} values"
    return f"""## Fig. 3: continuity of the shape error

{picture("E(h) and its derivative along h of each wire, for four pieces", path)}

The figure shows *E* of Eq. (4) over the area of the piece, and its derivative from the adjoint solve of the core, at
{STEPS + 1} values
of *h* within ±{100 * LIMIT:.0f}% along each wire, with the lengths of the other wires fixed. The program in
`native/bench/error_curves` computes both; {exists}. The paper shows a patch of a chest, a knee and a collar, and only
curves of *E*.
{verdict(kinks(curves))}
"""
