# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section with all samples flattened by all methods: a table for each measure."""

from __future__ import annotations

from collections.abc import Callable

from inputs import Inputs
from measures import Summary, rigid_wires, summarize, worst
from methods import METHODS
from palette import plain_percent
from text import degrees, millimeters, table


def worst_line(found: Summary) -> str:
    return plain_percent(worst([*found.outline, *rigid_wires(found)]).change, 2)


def worst_wire(found: Summary) -> str:
    wires = rigid_wires(found)
    if not wires:
        return "–"
    wire = max(wires, key=lambda line: line.difference)
    if wire.difference < 1e-9:
        return "0"
    return f"{millimeters(wire.difference)} of {1000 * wire.length_3d:.0f} ({wire.name})"


def angles(found: Summary) -> str:
    return f"{degrees(found.angle_rms)} / {degrees(found.angle_max)}"


def energy(found: Summary) -> str:
    return "0" if found.energy < 1e-9 else f"{found.energy:.5f}"


def seams(found: Summary) -> str:
    return "–" if found.seam_mismatch is None else millimeters(found.seam_mismatch)


TABLES: dict[str, Callable[[Summary], str]] = {
    "**Distortion *E*:** the ARAP energy of Eq. (4) over the area.": energy,
    "**Length:** the largest relative change of a section of outline or a rigid wire.": worst_line,
    "**Length of rigid wires, mm:** the largest error.": worst_wire,
    "**Seams, mm:** the largest difference between two sides of a seam.": seams,
    "**Angles:** difference between the angles of wires and outline in the plane and the same angles on the surface: "
    "rms of the worst piece, and largest.": angles,
}


def faults(found: dict[str, dict[str, Summary]]) -> str:
    """Return a table of the samples with flipped or overlapping triangles, or a sentence if there are none."""
    rows = [
        [name, *(f"{s.flipped} / {s.overlapping}" for s in row.values())]
        for name, row in found.items()
        if any(s.flipped or s.overlapping for s in row.values())
    ]
    if not rows:
        return "**Flipped triangles:** none by any method on any sample, and no piece overlaps itself."
    return f"""**Flipped triangles / overlapping triangles:** none on samples that are not listed.

{table(["", *METHODS], rows)}"""


def section(inputs: Inputs) -> str:
    found = {
        name: {method: summarize(shape.vertices, result) for method, result in inputs.by_all_methods(name).items()}
        for name, shape in inputs.shapes.items()
    }
    tables = [
        f"{title}\n\n{table(['', *METHODS], [[name, *(text(row[m]) for m in METHODS)] for name, row in found.items()])}"
        for title, text in TABLES.items()
    ]
    only_rigid = [name for name, shape in inputs.shapes.items() if all(wire.tolerance == 0 for wire in shape.wires)]
    return f"""## All samples

Blender's unwraps have default options, and each island is scaled to its area on the model. ARAP is computed by libigl,
from Blender's angle-based unwrap. WireWarp has default options except for the method. Wires have the tolerances of the
samples, ±5% for elastic wires. These samples have only rigid wires, so WireWarping and WireWarping++ give the same
pieces: {", ".join(only_rigid)}. Errors below a nanometer, and relative errors below 10⁻⁸, are shown as 0.

{chr(10).join(t + chr(10) for t in [*tables, faults(found)])}"""
