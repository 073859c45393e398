# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the section on Fig. 6: jeans by methods that do not keep lengths, and by methods that do."""

from __future__ import annotations

from inputs import Inputs
from maps import ARAP_ENERGY, ASPECT_RATIO, LENGTHS
from measures import Summary, rigid_wires, summarize, worst
from methods import KEEPING_LENGTHS
from palette import plain_percent
from sheet import Column, draw_sheet
from text import change, differ, millimeters, picture, table

DRAWN = ("Blender angle-based", "ARAP", *KEEPING_LENGTHS)
SHEETS = {"lengths": LENGTHS, "aspect_ratio": ASPECT_RATIO, "energy": ARAP_ENERGY}


def row(title: str, found: Summary) -> list[str]:
    rigid = rigid_wires(found)
    return [
        title,
        f"{found.energy:.5f}",
        f"{found.max_face_energy:.3g}",
        f"{found.mean_aspect_ratio:.4f}",
        f"{found.max_aspect_ratio:.2f}",
        plain_percent(worst(found.outline).change, 2),
        plain_percent(worst(rigid).change, 2),
        plain_percent(max(found.changes, key=abs), 2),
        millimeters(found.seam_mismatch),
        str(found.flipped),
    ]


HEADER = ["", "*E*, mean *E_A*", "max *E_A*", "mean *E_r*", "max *E_r*"]
HEADER += ["worst outline", "worst rigid wire", "most changed elastic wire", "seam sides differ, mm", "flipped"]


def section(inputs: Inputs) -> str:
    shape = inputs.shapes["Jeans"]
    results = inputs.by_all_methods(shape.name)
    columns = [Column(name, shape, results[name]) for name in DRAWN]
    pictures = []
    for name, quantity in SHEETS.items():
        path = inputs.pictures / f"figure_6_{name}.png"
        draw_sheet(path, columns, [quantity], view=(-28, 8))
        pictures.append(picture(f"Jeans by five methods: {name.replace('_', ' ')}", path))

    found = {name: summarize(shape.vertices, result) for name, result in results.items()}
    rigid, elastic, refined = (found[name] for name in KEEPING_LENGTHS)
    peers = {name: s for name, s in found.items() if name not in KEEPING_LENGTHS}
    worst_peer = max(peers, key=lambda name: peers[name].seam_mismatch)
    best_peer = min(peers, key=lambda name: peers[name].seam_mismatch)
    return f"""## Fig. 6: jeans

{chr(10).join(pictures)}

{table(HEADER, [row(name, s) for name, s in found.items()])}

For outlines and rigid wires, the table has the largest relative change of a whole wire or a section of outline between
junctions. For elastic wires, it has the largest relative change of a part inside a piece. WireWarping++ and Refined may
change a part by up to ±5%. For the other methods, every change is an error. ARAP has the least *E* by definition. If a
method does not keep lengths, however, pieces do not fit together and wires change their lengths: two sides of a seam
differ by {millimeters(peers[best_peer].seam_mismatch)} mm ({best_peer}) to
{millimeters(peers[worst_peer].seam_mismatch)} mm ({worst_peer}). With WireWarping, WireWarping++ and Refined, the two
sides {differ(max(found[name].seam_mismatch for name in KEEPING_LENGTHS))}. From WireWarping to WireWarping++, *E*
{change(rigid.energy, elastic.energy)}, the largest *E_r* {change(rigid.max_aspect_ratio, elastic.max_aspect_ratio)} and
the largest *E_A* {change(rigid.max_face_energy, elastic.max_face_energy)}. The refined method is not in the paper. From
WireWarping++ to Refined, with the same tolerances, *E* {change(elastic.energy, refined.energy)}. The paper uses ABF++,
with islands scaled by their longest edge. This page uses Blender's angle-based unwrap, with each island scaled to its
area on the model. The jeans are our own model, which is simpler than the paper's. Flipped triangles are counted and
drawn. The paper does not mention them.
"""
