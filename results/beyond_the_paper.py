# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on the refined method, which keeps the same lengths as WireWarping++ with less distortion."""

from __future__ import annotations

import math

import fairness
import subdivision
from inputs import Inputs
from maps import ARAP_ENERGY
from measures import Summary, summarize
from methods import KEEPING_LENGTHS
from sheet import Column, draw_sheet
from text import count, degrees, picture, table

DRAWN = {  # rotation and tilt of the model in degrees, preferred width over height of a flattening
    "Fitted top": ((-28, 8), 1.4),
    "Quarter sphere": ((-62, 10), 1.0),
    "Wetsuit collar": ((-24, 18), 1.0),
    "Wetsuit upper body": ((-28, 8), 1.4),
    "Jeans": ((-28, 8), 1.0),
    "Armchair cover": ((-34, 26), 1.4),
}
NOISE = 1e-9  # shapes with less energy count as undistorted
SEEN = math.radians(0.05)  # smallest difference of angles that the table shows
HEADER = ["", "*E*: WireWarping++", "Refined", "ratio", "angles, rms / largest: WireWarping++", "Refined"]
HEADER += ["flipped: WireWarping++", "Refined", "factorizations"]


def row(name: str, before: Summary, after: Summary) -> list[str]:
    is_flat = before.energy < NOISE
    return [
        name,
        "0" if is_flat else f"{before.energy:.5f}",
        "0" if is_flat else f"{after.energy:.5f}",
        "–" if is_flat else f"{before.energy / after.energy:.2f}",
        *(f"{degrees(s.angle_rms)} / {degrees(s.angle_max)}" for s in (before, after)),
        *(str(s.flipped) for s in (before, after)),
        str(after.factorizations),
    ]


def draw(inputs: Inputs, name: str) -> str:
    """Draw the flattenings of a sample. Return the link to the picture.

    If all wires are rigid, WireWarping++ is left out, because its pieces are those of WireWarping.
    """
    shape, results = inputs.shapes[name], inputs.by_all_methods(name)
    titles = {method: method for method in KEEPING_LENGTHS}
    if all(wire.tolerance == 0 for wire in shape.wires):
        titles = {"WireWarping": "WireWarping, WireWarping++", "Refined": "Refined"}
    columns = [Column(title, shape, results[method]) for method, title in titles.items()]
    path = inputs.pictures / f"refined_{name.lower().replace(' ', '_')}.png"
    draw_sheet(path, columns, [ARAP_ENERGY], *DRAWN[name])
    return picture(f"{name}: model, and the ARAP energy of its pieces by method", path)


def angle_sentence(found: dict[str, tuple[Summary, Summary]]) -> str:
    growth = {name: after.angle_rms - before.angle_rms for name, (before, after) in found.items()}
    larger = [name for name, by in growth.items() if by > SEEN]
    most = max(growth, key=growth.get)
    before, after = found[most]
    peak = max(found, key=lambda name: found[name][1].angle_max - found[name][0].angle_max)
    peak_before, peak_after = found[peak]
    return (
        "On the other hand, the angles deviate more from the angles on the surface. The rms deviation is larger on "
        f"{len(larger)} of the {len(found)} samples, most on {most}, {degrees(after.angle_rms)} instead of "
        f"{degrees(before.angle_rms)}. "
        f"The largest single deviation grows most on {peak}, from {degrees(peak_before.angle_max)} to "
        f"{degrees(peak_after.angle_max)}."
    )


def section(inputs: Inputs) -> str:
    found = {}
    for name, shape in inputs.shapes.items():
        results = inputs.by_all_methods(name)
        found[name] = tuple(summarize(shape.vertices, results[method]) for method in ("WireWarping++", "Refined"))
    times = {name: b.energy / a.energy for name, (b, a) in found.items() if b.energy > NOISE}
    least, most = min(times, key=times.get), max(times, key=times.get)
    edge = math.ceil(math.log10(max(after.worst_edge for _, after in found.values())))
    flipped = sum(after.flipped + after.overlapping for _, after in found.values())
    return f"""## Beyond the paper

WireWarping first finds the angles of wires and outline that are closest to the angles on the surface. The shape
follows from these angles. The refined method, WireWarp's default, finds the least distorted shape with the same exact
lengths, and uses the angles only to keep lines smooth (`native/README.md`).
With the same tolerances, *E* of WireWarping++ is {times[least]:.1f} times ({least}) to
{times[most]:.1f} times ({most}) the *E* of the refined method. With the refined method, too, every edge of outlines and
wires has its target length, with a relative error below 1e{edge}, and
{count(flipped, "triangle is", "triangles are")} flipped or overlapping.
{angle_sentence(found)}

{table(HEADER, [row(name, *both) for name, both in found.items()])}

The last column has the number of factorizations of Newton systems, for the piece with the most. [All
samples](#all-samples) has the other measures and methods, including Blender's and ARAP. Each picture has one scale for
length and one for color.

{chr(10).join(draw(inputs, name) for name in DRAWN)}

{fairness.subsection(inputs)}
{subdivision.subsection()}"""
