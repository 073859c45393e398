# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on samples with other lengths than the model: negative ease, an eased sleeve head, gathers."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from cloths import Strained, strained, strains
from inputs import Inputs
from maps import THREAD_STRAIN
from measures import summarize
from methods import flatten, flatten_as_made
from palette import percent, plain_percent
from shapes import Shape
from sheet import Column, draw_sheet
from text import change, degrees, differ, picture, table

CLOTHS = ("", "woven", "jersey", "swim")
KNITS = ("jersey", "swim")  # fabrics that are stretched when worn
SWIMSUIT, SLEEVE, SKIRT = "Swimsuit", "Set-in sleeve", "Gathered skirt"
DRAWN = {SWIMSUIT: (-28, 8), SLEEVE: (-24, 8), SKIRT: (-28, 14)}  # rotation and tilt of the model in degrees


@dataclass(frozen=True)
class Cut:
    """A line of a sample; lengths in meters."""

    name: str
    worn: float  # length on the model
    cut: float  # length on the flat piece


def stretched_lines(found: Strained) -> list[Cut]:
    """Return the wires of a sample whose fabric is stretched when worn, and the total of its seams."""
    wires = [Cut(wire.name.lower(), wire.length_3d, wire.length_2d) for wire in found.result.wires]
    seams = found.result.seams
    return [*wires, Cut("seams, each side", sum(s.length_3d for s in seams), sum(s.length_2d[0] for s in seams))]


def eased_line(name: str, found: Strained) -> Cut:
    """Return the total of all eased seams of a sample: the longer sides as cut, the shorter sides as worn."""
    seams = [seam for seam in found.result.seams if any(seam.eases)]
    return Cut(name, sum(min(seam.length_2d) for seam in seams), sum(max(seam.length_2d) for seam in seams))


def eased(found: Strained) -> float:
    """Return the total amount of ease in meters."""
    line = eased_line("", found)
    return line.cut - line.worn


def made_in(shape: Shape, cloth: str, stretch: tuple[float, float] = (0, 0)) -> Strained:
    begin = time.process_time()
    result = flatten_as_made(shape, cloth, stretch)
    return strained(shape, result, time.process_time() - begin)


def cloth_energy(found: Strained) -> float:
    """Return the minimized energy over the area, which is *E* without a fabric."""
    areas = [piece.metrics.area_3d for piece in found.result.pieces]
    energies = [piece.metrics.cloth_energy for piece in found.result.pieces]
    return found.energy if np.isnan(energies).all() else float(np.average(energies, weights=areas))


def row(name: str, found: Strained) -> list[str]:
    return [name, strains(found), f"{cloth_energy(found):.5f}", f"{found.energy:.5f}", f"{found.seconds:.2f}"]


def length_row(line: Cut) -> list[str]:
    sign = "−" if line.cut < line.worn else "+"
    lengths = [f"{1000 * meters:.1f}" for meters in (line.worn, line.cut, abs(line.cut - line.worn))]
    return [line.name, *lengths[:2], sign + lengths[2], percent(line.cut / line.worn - 1)]


def draw(inputs: Inputs, name: str, as_made: Strained) -> str:
    shape = inputs.shapes[name]
    columns = [Column("Lengths of the model", shape, flatten(shape)), Column("As made", shape, as_made.result)]
    path = inputs.pictures / f"made_{name.lower().replace(' ', '_').replace('-', '_')}.png"
    draw_sheet(path, columns, [THREAD_STRAIN], DRAWN[name], 1.2)
    return picture(f"{name}: model, its pieces with the model's lengths, and as made", path)


def in_each_cloth(shape: Shape) -> dict[str, Strained]:
    """Return the results in each fabric, by description. If the sample has a stretch, knits are stretched, too."""
    found = {cloth or "no fabric": made_in(shape, cloth) for cloth in CLOTHS}
    if any(shape.stretch):
        across, along = (f"{100 * share:.0f}%" for share in shape.stretch)
        found |= {f"{cloth} stretched {across} / {along}": made_in(shape, cloth, shape.stretch) for cloth in KNITS}
    return {f"{shape.name}, {choice}": each for choice, each in found.items()}


def section(inputs: Inputs) -> str:
    shapes = {name: inputs.shapes[name] for name in DRAWN}
    # Only the swimsuit is flattened for its fabric. The other samples show the effect of eases alone.
    fabrics = {name: shape.cloth if any(shape.stretch) else "" for name, shape in shapes.items()}
    as_made = {name: made_in(shape, fabrics[name], shape.stretch) for name, shape in shapes.items()}
    lines = [
        *(Cut(f"{SWIMSUIT}, {line.name}", line.worn, line.cut) for line in stretched_lines(as_made[SWIMSUIT])),
        eased_line(f"{SLEEVE}: head, in an armhole of", as_made[SLEEVE]),
        eased_line(f"{SKIRT}: top edge, on a band of", as_made[SKIRT]),
    ]
    across, along = shapes[SWIMSUIT].stretch
    rows = [row(name, found) for shape in shapes.values() for name, found in in_each_cloth(shape).items()]
    unwoven, woven = (made_in(shapes[SKIRT], cloth) for cloth in ("", "woven"))
    plain_sleeve = summarize(shapes[SLEEVE].vertices, flatten(shapes[SLEEVE])).energy
    mismatch = max(seam.mismatch for each in as_made.values() for seam in each.result.seams)
    return f"""## Ease, gathers and stretch

Three samples are cut longer or shorter than they are on the model. The swimsuit is swim knit, stretched
{100 * across:.0f}% across and {100 * along:.0f}% along when worn. The head of the set-in sleeve is eased into the
armhole, between its notches. The skirt is gathered to its waistband; its fairness is
{shapes[SKIRT].fairness}. In all other sections of this page, these samples have the lengths of the model.

{table(["mm", "worn", "cut", "difference", "share"], [length_row(line) for line in lines])}

Lines across the swim knit are cut to 1/{1 + across:.2f} of their length, and lines along it to 1/{1 + along:.2f}. For
other lines, the factor depends on their direction, and for a seam, it is the mean of its two sides. All eased edges
become longer by the same share. Except for the ease, the two sides of a seam {differ(mismatch)}.

{chr(10).join(draw(inputs, name, as_made[name]) for name in DRAWN)}

The table shows the strain of each fabric (99th percentiles by area), the minimized energy, *E*, and processor time.
All rows of a sample have the same exact lengths, except the rows that are cut for stretched fabric. In these rows, the
strain is relative to the fabric as cut.

{table(["", "across / along / shear", "minimized energy", "*E*", "s"], rows)}

**What to choose.** For a close-fitting knit, use negative ease: enter how far the fabric is stretched when worn, in
both directions. Then choose a fabric that allows the total stretch in the report: for the swimsuit,
{plain_percent(as_made[SWIMSUIT].weft, 0)} across and {plain_percent(as_made[SWIMSUIT].warp, 0)} along. If one piece
must be fuller than the other, as at a sleeve head or an elbow, use ease on one side. With
an ease of {1000 * eased(as_made[SLEEVE]):.0f} mm, *E* of the sleeve and its bodice
{change(plain_sleeve, as_made[SLEEVE].energy)}. For gathers, choose no fabric, and use an ease of 50% to 150% and a
larger fairness, so that the long edge stays smooth. The strain at this edge becomes folds, because
fabric hardly resists folding. With a woven fabric, the pieces would shear instead:
by {degrees(woven.shear)}, compared with {degrees(unwoven.shear)} without a fabric.
"""
