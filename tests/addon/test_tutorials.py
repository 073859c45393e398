# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures in docs/tutorials/ are those of the models that the reader makes."""

from pathlib import Path

import bpy
from suggesting import SUGGEST, found
from test_export import export, pages

TUTORIALS = Path(__file__).parents[2] / "docs" / "tutorials"


def test_the_ring_of_the_plush_tutorial(addon, tmp_path):
    page = (TUTORIALS / "plush.md").read_text(encoding="utf-8")
    assert "Enter 0.1 m for *Major Radius* and 0.05 m\n   for *Minor Radius*" in page
    bpy.ops.mesh.primitive_torus_add(major_radius=0.1, minor_radius=0.05)
    ring, scene = bpy.context.object, bpy.context.scene
    scene.wirewarp.cloth, scene.wirewarp.allowance = "FLEECE", 5.0
    SUGGEST["SEAMS"]()
    suggestions = found(addon, ring)
    chosen = suggestions.cuts[suggestions.chosen]
    row = addon.solve.suggest.row_text("SEAMS", chosen, None, addon.blender.objects.length_text(scene))
    assert f"*{row}*" in page
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    bpy.ops.object.wirewarp_flatten(cloth="FLEECE")
    assert addon.state.reports.last_report(ring).tables.verdict.kind is addon.core.Kind.READY
    single, all_pieces = (
        pages(export(tmp_path, f"{pairs}.pdf", paper="A4", allowance=5.0, proof_sheet=True, pairs=pairs))
        for pairs in (True, False)
    )
    assert f"The ring takes {single} sheets of A4 instead of {all_pieces}." in page
