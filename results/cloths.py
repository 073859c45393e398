# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on fabrics: how far threads stretch in pieces flattened for a fabric, and without a fabric."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
import wirewarp
from inputs import Inputs
from maps import THREAD_STRAIN, thread_strain
from measures import percentile_99, piece_areas, summarize
from methods import flatten
from palette import plain_percent
from shapes import Shape
from sheet import Column, draw_sheet
from text import degrees, picture, table

STRAINED = 1e-3  # samples with less strain unfold without stretch, so the table leaves them out
CHOICES: dict[str, dict[str, str]] = {
    "No fabric": {},
    "Woven": {"cloth": "woven"},
    "Woven, best direction": {"cloth": "woven", "orientation": "best"},
    "Jersey": {"cloth": "jersey"},
}
DRAWN = {  # rotation and tilt of the model in degrees, preferred width over height of a flattening
    "Fitted top": ((-28, 8), 1.4),
    "Hat": ((-30, 24), 1.0),
}
WORN = ("Fitted top", "Hat", "Wetsuit upper body", "Jeans")  # samples whose fit on a body is simulated


@dataclass(frozen=True)
class Strained:
    """A sample cut from a fabric. Strains and shear are 99th percentiles by area on the model."""

    result: wirewarp.FlattenResult
    weft: float  # absolute strain of threads across the grain, as a fraction
    warp: float  # absolute strain of threads along the grain, as a fraction
    thread: float  # strain of the more strained thread of each triangle, as a fraction
    shear: float  # radians: deviation of the threads from a right angle
    energy: float  # ARAP energy over area, Eq. (4); for a fabric, another energy is minimized
    seconds: float  # processor time of the flattening


def of_all(values: list[np.ndarray]) -> np.ndarray:
    return np.abs(np.concatenate(values))


def cut_from(shape: Shape, options: dict[str, str]) -> Strained:
    begin = time.process_time()
    result = flatten(shape, **options)
    return strained(shape, result, time.process_time() - begin)


def strained(shape: Shape, result: wirewarp.FlattenResult, seconds: float) -> Strained:
    areas = np.concatenate([piece_areas(shape.vertices, piece) for piece in result.pieces])
    metrics = [piece.metrics for piece in result.pieces]
    return Strained(
        result=result,
        weft=percentile_99(of_all([m.face_weft_strain for m in metrics]), areas),
        warp=percentile_99(of_all([m.face_warp_strain for m in metrics]), areas),
        thread=percentile_99(of_all([thread_strain(piece) for piece in result.pieces]), areas),
        shear=percentile_99(of_all([m.face_shear_angle for m in metrics]), areas),
        energy=summarize(shape.vertices, result).energy,
        seconds=seconds,
    )


def strains(found: Strained) -> str:
    return f"{plain_percent(found.weft)} / {plain_percent(found.warp)} / {degrees(found.shear)}"


def draw(inputs: Inputs, name: str, found: dict[str, Strained]) -> str:
    view, aspect = DRAWN[name]
    columns = [Column(choice, inputs.shapes[name], found[choice].result) for choice in CHOICES]
    path = inputs.pictures / f"cloth_{name.lower().replace(' ', '_')}.png"
    draw_sheet(path, columns, [THREAD_STRAIN], view, aspect)
    return picture(f"{name}: model, and how far the threads of each fabric are strained", path)


def range_of(values: list[float]) -> str:
    return f"{min(values):.2f} to {max(values):.2f}"


def worn_subsection(inputs: Inputs) -> str:
    """Return the subsection on the results of wear_in_newton.py."""
    rows = [
        [
            f"{name}, {choice[0].lower()}{choice[1:]}",
            f"{1000 * worn['gap']:.1f}",
            f"{1000 * worn['slide']:.1f}",
            plain_percent(worn["strain"]),
            plain_percent(worn["wire"]),
        ]
        for name, choices in inputs.worn.items()
        for choice, worn in choices.items()
    ]
    change = {
        measure: [choices["Woven"][measure] / choices["No fabric"][measure] for choices in inputs.worn.values()]
        for measure in ("gap", "slide", "strain")
    }
    return f"""### Simulated fit

A smaller energy of the flat pieces does not guarantee a better garment. We therefore simulated the fit with NVIDIA
Newton's SolverStyle3D, a physics engine that shares no code with WireWarp (`results/wear_in_newton.py`). It sews the
pieces of each row, as woven fabric with the stiffness ratios of the preset, and puts them on their model, without
gravity and friction.

{table(["pieces flattened for", "gap, rms mm", "slide, rms mm", "strain", "worst wire"], rows)}

All measures are those of the worn garment at rest. *Gap* is the distance of the fabric from the model. *Slide* is the
distance of each point from its place on the model. *Strain* is the 99th percentile of the strain of the more strained
thread. *Worst wire* is the largest change of a wire's length.
Pieces flattened for woven fabric have {range_of(change["gap"])} times the gap of pieces flattened without a fabric,
{range_of(change["slide"])} times the slide and {range_of(change["strain"])} times the strain. On the body, fabric
slides until its threads carry little load, whether or not a fabric was chosen. The shape between exact outlines
therefore affects the fit less than the outlines do.
"""


def section(inputs: Inputs) -> str:
    every = {
        name: {choice: cut_from(shape, options) for choice, options in CHOICES.items()}
        for name, shape in inputs.shapes.items()
    }
    found = {name: row for name, row in every.items() if row["No fabric"].thread > STRAINED}
    share = {choice: [row[choice].thread / row["No fabric"].thread for row in found.values()] for choice in CHOICES}
    energy = [row["Woven"].energy / row["No fabric"].energy for row in found.values()]
    seconds = {choice: sum(row[choice].seconds for row in every.values()) for choice in CHOICES}
    times = "; ".join(
        f"{seconds[choice] / seconds['No fabric']:.1f} times as long for {choice[0].lower()}{choice[1:]}"
        for choice in CHOICES
        if choice != "No fabric"
    )
    woven, best = range_of(share["Woven"]), range_of(share["Woven, best direction"])
    lower = sum(row["Jersey"].warp < row["No fabric"].warp for row in found.values())
    unfolded = [name for name in every if name not in found]
    rows = [[name, *(strains(row[choice]) for choice in CHOICES)] for name, row in found.items()]
    return f"""## Fabrics

The table shows the strain of each fabric: the strain of the threads across (weft) and along the grain (warp), and the
deviation of the threads from a right angle. In all columns, the lengths of outlines, seams and wires are the same and
exact. Only the shapes of the pieces differ. Each number is the 99th percentile by area: 1% of the area has a larger
value.

{table(["across / along / shear", *CHOICES], rows)}

{chr(10).join(draw(inputs, name, found[name]) for name in DRAWN)}

Woven fabric has stiff threads and shears easily. In pieces flattened for woven fabric, the more strained of the two
threads has {woven} times the strain without a fabric (99th percentiles). In the direction of least energy, it has
{best} times this strain. Shear and the ARAP energy, which weighs all directions equally, become larger: *E* is
{range_of(energy)} times as large. Jersey stretches more across than along the grain. Its strain along the grain is
lower than without a fabric on {lower} of the {len(found)} samples. Some samples unfold without strain in every fabric:
{", ".join(unfolded)}. Compared with runs without a fabric, flattening all samples takes {times}.

**What to choose.** Choose the preset of your material, even if the material is equally stiff in all directions. The
report then shows the strain of this material, and warns you if the material cannot stretch that far. If no preset suits
your material, choose no fabric. If the fabric has no nap or print, and if the pieces may have any direction on it,
choose the best direction. Otherwise choose a grain line for each piece, as a tailor does.

{worn_subsection(inputs)}"""
