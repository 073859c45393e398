# SPDX-License-Identifier: GPL-3.0-or-later
"""An export searches for a marker and stores it with the model. The view draws the stored marker."""

import re
from functools import partial

import bpy
import numpy as np
import pytest
import test_export
from drawing import Drawing
from surfaces import flat_of, read
from two_sided import two_pieces
from view_context import view_context

CLOTH = {"arrangement": "MARKER", "cloth_width": 400.0, "gap": 4.0, "grain": "BOTH_WAYS"}


@pytest.fixture
def source(at_once):
    """Return a flattened model of two pieces of about 230 by 115 mm. Drawings are updated immediately."""
    target = two_pieces()
    bpy.ops.object.wirewarp_flatten()
    return target


export = partial(test_export.export, seconds=0, **CLOTH)


def outlines(path):
    return [outline * (1, -1) for outline in Drawing(path).outlines()]


def test_pieces_are_on_the_fabric_and_its_length_is_reported(source, tmp_path, capfd):
    found = outlines(export(tmp_path))
    said = capfd.readouterr().out
    assert re.search(r"2 pieces on [\d.]+ m?m of fabric 400 mm wide, \d+% of it used", said)
    assert len(found) == 2 and np.ptp(np.concatenate(found), axis=0)[0] <= 400.0
    first, second = found
    assert np.linalg.norm(first[:, None] - second, axis=2).min() > 4.0 - 0.01


def test_the_marker_is_kept_for_other_formats_until_the_pieces_change(source, tmp_path, addon):
    export(tmp_path)
    kept = source["wirewarp_marker"]
    export(tmp_path, "a.pdf")
    assert source["wirewarp_marker"] == kept
    marker = addon.export.read.kept_marker(kept).marker
    parts = addon.export.read.read_pattern(bpy.context.scene, source)
    choices = addon.export.export.ExportChoices(
        {"allowance": 10.0, "notch_spacing": 100.0, "darts": "close"}, frozenset(), cloth=parts.kept.cloth
    )
    assert addon.export.export.made_pattern(parts, choices).marker is not marker
    assert addon.export.export.made_pattern(parts, choices).marker == marker
    export(tmp_path, allowance=20.0)
    assert source["wirewarp_marker"] != kept


def test_foreign_marker_data_is_ignored(source, tmp_path, addon):
    for stored in ("", "{}", "x" * 64 + "{}", 7):
        source["wirewarp_marker"] = stored
        assert addon.export.read.kept_marker(source.get("wirewarp_marker", "")) is None
    export(tmp_path)


def test_the_preview_draws_the_stored_marker(source, tmp_path, addon):
    settings = bpy.context.scene.wirewarp
    for name, value in CLOTH.items():
        setattr(settings, name, value)

    def preview():
        return addon.overlay.shown.shown_pages(view_context(), source, flat_of(source))

    assert preview().sentence.startswith("No marker of these pieces on this fabric yet")
    cut = outlines(export(tmp_path))
    pages = preview()
    assert "of fabric 400 mm wide" in pages.sentence
    drawn = 100 * pages.places["cut"][:, :2]
    assert np.ptp(drawn, axis=0) == pytest.approx(np.ptp(np.concatenate(cut), axis=0), abs=0.01)
    assert drawn[:, 1].max() < 100 * read(flat_of(source).data.vertices, "co", np.float32, 3)[:, 1].min()
    settings.cloth_width = 500.0
    assert not preview().places


@pytest.mark.parametrize("has_search", [False, True])
def test_the_progress_of_an_export_grows_through_every_stage_of_the_library(addon, has_search):
    stages = sorted(addon.core.pattern.STAGES, key=addon.core.pattern.STAGES.get)
    if has_search:
        stages.insert(stages.index("writing"), "nesting")
    shares = [addon.export.export._share(stage, done, has_search) for stage in stages for done in (0.0, 0.5, 1.0)]
    assert shares == sorted(shares) and (shares[0], shares[-1]) == pytest.approx((0.0, 1.0), abs=1e-9)
