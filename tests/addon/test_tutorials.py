# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers of docs/tutorials/ get the figures that the tutorials name."""

from pathlib import Path

import bpy
import pytest
from flattening import report_after
from suggesting import suggested
from test_export import export, pages

pytestmark = pytest.mark.core

ROOT = Path(__file__).parents[2]
TUTORIALS = ROOT / "docs" / "tutorials"
SAMPLE = ROOT / "blend_samples" / "fitted_top.blend"


def test_the_ring_of_the_plush_tutorial(addon, tmp_path):
    page = (TUTORIALS / "plush.md").read_text(encoding="utf-8")
    assert "Enter 0.1 m for *Major Radius* and 0.05 m\n   for *Minor Radius*" in page
    bpy.ops.mesh.primitive_torus_add(major_radius=0.1, minor_radius=0.05)
    ring, scene = bpy.context.object, bpy.context.scene
    scene.wirewarp.cloth, scene.wirewarp.allowance = "FLEECE", 5.0
    suggestions, lengths = suggested(addon, ring, "SEAMS"), addon.blender.objects.length_text(scene)
    chosen = suggestions.cuts[suggestions.chosen]
    row = addon.solve.suggest.row_text("SEAMS", chosen, None, lengths)
    assert f"*{row}*" in page
    bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    assert report_after(addon, ring, cloth="FLEECE").tables.verdict.kind is addon.core.Kind.READY
    single, all_pieces = (
        pages(export(tmp_path, f"{pairs}.pdf", paper="A4", allowance=5.0, proof_sheet=True, pairs=pairs))
        for pairs in (True, False)
    )
    assert f"The ring takes {single} sheets of A4, including the map and the proof sheet." in page
    assert f"Without **Equal Pieces**, it would take {all_pieces}." in page
    scene.wirewarp.pairs = True
    flat = bpy.data.objects["Torus Flat"]
    copies = "Cut 2: Top Left and Top Right; Bottom Left and Bottom Right"
    assert addon.overlay.shown.shown_copies(bpy.context, ring, flat) == [copies]
    darts = suggested(addon, ring, "DARTS", piece=0)
    row = addon.solve.suggest.row_text("DARTS", darts.cuts[darts.chosen], None, lengths)
    assert f"*{row}* means one dart of" in page


def test_the_top_of_the_first_tutorial(addon, tmp_path):
    page = (TUTORIALS / "first-pattern.md").read_text(encoding="utf-8")
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLE))
    bpy.ops.object.wirewarp_flatten(cloth=bpy.context.scene.wirewarp.cloth)
    assert addon.state.reports.last_report(bpy.context.object).tables.verdict.kind is addon.core.Kind.READY
    few, all_pieces = (
        pages(export(tmp_path, f"{once}.pdf", paper="A4", pairs=once, on_fold=once)) for once in (True, False)
    )
    assert f"It takes {few} sheets of A4 instead of {all_pieces}." in page
