# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages drawn over flat pieces are the pages of the PDF."""

import re
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from drawing import SVG, Drawing
from everything import AnyLayout, draw_panels, sidebar
from flattening import flat_places, flattened
from surfaces import flat_of, grid, on_edges, on_line, select_edges, select_only
from test_export import pages as pages_in
from two_sided import two_pieces
from view_context import view_context


@pytest.fixture
def source(at_once):
    """Return a flattened model of two pieces of about 230 by 115 mm. Drawings are updated immediately."""
    target = two_pieces()
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    bpy.context.scene.wirewarp.show_pages = True
    return target


def preview(addon, source, **settings):
    for name, value in settings.items():
        setattr(bpy.context.scene.wirewarp, name, value)
    return addon.overlay.shown.shown_pages(view_context(), source, flat_of(source))


def frames(pages):
    """Return the lowest and the highest corner of each page (p,2,2) in millimeters."""
    corners = 100 * pages.places["page"].reshape(-1, 8, 3)[..., :2]
    return np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1)


@pytest.mark.parametrize(
    ("paper", "beside", "arrangement"),
    [("A4", 1, "IN_ROWS"), ("36IN", 0, "AS_LAID_OUT"), ("PROJECTOR", 0, "IN_ROWS")],
)
def test_the_preview_has_as_many_pages_as_the_file(addon, source, tmp_path, paper, beside, arrangement):
    """beside: number of pages with the map, which only the file has."""
    pages = preview(addon, source, paper=paper, arrangement=arrangement)
    path = tmp_path / "a.pdf"
    bpy.ops.object.wirewarp_export(filepath=str(path), paper=paper, arrangement=arrangement)
    assert len(frames(pages)) == len(pages.names) == pages_in(path) - beside
    sizes = np.ptp(frames(pages), axis=1)
    printed = re.findall(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+) ?\]", path.read_bytes())
    assert sizes + (20 if beside else 0) == pytest.approx(np.array(printed[beside:], dtype=float) * 25.4 / 72, abs=0.01)
    assert pages.is_good and pages.sentence.startswith(f"{len(pages.names)} ")


@pytest.mark.parametrize("arrangement", ["IN_ROWS", "AS_LAID_OUT"])
def test_copies_are_drawn_once_in_file_and_preview(addon, at_once, tmp_path, arrangement):
    """A flat square of 200 mm is cut into two equal, symmetric pieces. Only half of one piece is drawn, with a fold."""
    bpy.context.scene.unit_settings.scale_length = 0.1
    source = grid("Flat", lambda x, y: (x, y, 0.0), seam=on_line(0, 0.0))
    bpy.ops.object.wirewarp_flatten(spacing=50.0)
    pages = preview(addon, source, arrangement=arrangement, pairs=True, on_fold=True)
    path = tmp_path / "a.pdf"
    bpy.ops.object.wirewarp_export(filepath=str(path), arrangement=arrangement, pairs=True, on_fold=True)
    assert len(frames(pages)) == pages_in(path) - 1  # The preview has no page with the map.
    if arrangement == "IN_ROWS":  # 100 by 100 or 50 by 200 mm, with an allowance of 10 mm on all sides but the fold
        size = sorted(100 * np.ptp(pages.places["cut"][:, :2], axis=0))
        assert size in (pytest.approx([110, 120], abs=0.01), pytest.approx([60, 220], abs=0.01))
    names = [piece.name for piece in source.wirewarp_pieces]
    said = addon.overlay.shown.shown_copies(view_context(), source, flat_of(source))
    assert said == [f"Cut 2: {names[0]} and {names[1]}", f"On the fold: {names[0]}"]
    source.wirewarp_active_piece = 0
    assert f"Cut 2, with {names[1]}. Can be cut on the fold" in draw_panels(addon)
    bpy.ops.object.wirewarp_export(filepath=str(tmp_path / "a.svg"), pairs=True, on_fold=True)
    assert [path.get("data-role") for path in Drawing(tmp_path / "a.svg").root.iter(f"{SVG}path")].count("cut") == 1


def test_the_list_of_pieces_does_not_change_what_is_drawn_once(addon):
    source = flattened("Flat", lambda x, y: (x, y, 0.0), seam=on_line(0, 0.0))
    bpy.context.scene.wirewarp.pairs, bpy.context.scene.wirewarp.on_fold = True, False
    one, other = (piece.name for piece in source.wirewarp_pieces)
    given = view_context(), source, flat_of(source)
    for _ in range(2):
        assert addon.overlay.shown.piece_copies(*given, one) == f"Cut 2, with {other}. Can be cut on the fold"
        assert addon.overlay.shown.shown_copies(*given) == [f"Cut 2: {one} and {other}"]


def test_the_panel_says_that_no_pieces_are_equal(addon):
    source = flattened("Uneven", lambda x, y: (x * (1.2 + 0.2 * x + 0.1 * y), y * (1.3 + 0.1 * x + 0.3 * y), 0.0))
    settings = bpy.context.scene.wirewarp
    for settings.pairs, settings.on_fold, said in (
        (True, False, ["No two pieces have the same shape."]),
        (False, True, ["No piece is symmetric."]),
        (True, True, ["No two pieces have the same shape.", "No piece is symmetric."]),
    ):
        assert addon.overlay.shown.shown_copies(view_context(), source, flat_of(source)) == said
        assert " ".join(said) in draw_panels(addon)


def test_the_list_of_pieces_makes_no_pattern_until_names_or_marked_allowances_change(addon, at_once, monkeypatch):
    made, cut_lines = [], addon.overlay.shown.cut_lines
    monkeypatch.setattr(addon.overlay.shown, "cut_lines", lambda *a, **b: (made.append(b), cut_lines(*a, **b))[1])
    source = flattened("Flat", lambda x, y: (x, y, 0.0), seam=on_line(0, 0.0))
    one, other = (piece.name for piece in source.wirewarp_pieces)
    given = view_context(), source, flat_of(source)

    def sentence(name=one):
        bpy.context.view_layer.update()
        return addon.overlay.shown.piece_copies(*given, name)

    assert sentence() == f"Cut 2, with {other}. Can be cut on the fold" and len(made) == 1
    bpy.context.scene.wirewarp.allowance = 25.0
    for vertex in flat_of(source).data.vertices:
        vertex.co.x += 1.0
    flat_of(source).data.update()
    assert sentence(other) and len(made) == 1
    source.wirewarp_pieces[1].name = "Lining"
    assert sentence() == "Cut 2, with Lining. Can be cut on the fold" and len(made) == 2
    on_edges(source, bpy.ops.mesh.wirewarp_allowance, on_line(0, 1.0), kind="WIDTH", width=30.0)
    assert sentence() == "Can be cut on the fold" and len(made) == 3


def test_equal_pieces_are_named_below_the_export_button(addon, source):
    """Above the button, these names would move it away from the mouse."""
    bpy.context.scene.wirewarp.pairs = True
    select_only(source)
    drawn = []
    panel = SimpleNamespace(layout=AnyLayout(drawn, drawn))
    bpy.types.VIEW3D_PT_wirewarp_export.draw(panel, sidebar())
    named = [index for index, text in enumerate(drawn) if text.startswith("Cut ")]
    assert named and drawn.index("object.wirewarp_export") < min(named)


def test_pages_are_over_the_pieces_or_below_them_with_the_printed_lines(addon, source):
    flat = 100 * flat_places(source)

    def on_page(places, pages):
        low, high = frames(pages).transpose(1, 0, 2)
        return np.all((places[:, None] > low) & (places[:, None] < high), axis=2).any(axis=1).all()

    pages = preview(addon, source, arrangement="AS_LAID_OUT", paper="A4")
    sizes = np.sort(np.ptp(frames(pages), axis=1))
    assert sizes == pytest.approx(np.tile([190.0, 277.0], (len(sizes), 1)), abs=1e-3)  # A4 without the margins
    assert on_page(flat, pages) and "cut" not in pages.places
    pages = preview(addon, source, arrangement="IN_ROWS")
    assert frames(pages)[:, 1, 1].max() < flat[:, 1].min()
    assert on_page(100 * pages.places["cut"][:, :2], pages)


def test_pages_follow_allowances_and_the_unit(addon, source):
    def height():
        return np.ptp(frames(preview(addon, source, paper="PROJECTOR", arrangement="AS_LAID_OUT"))[0], axis=0)[1]

    before = height()
    assert np.ptp(frames(preview(addon, source, allowance=30.0))[0], axis=0)[1] == pytest.approx(before + 40, abs=2)
    select_edges(source, on_line(1, -1.0), on_line(1, 1.0), on_line(0, 1.0), on_line(0, -1.0))
    bpy.ops.mesh.wirewarp_allowance(kind="HEM", hem=10.0)
    assert height() == pytest.approx(before + 20, abs=2)  # Now only the seam has an allowance of 30 mm.
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.scene.unit_settings.scale_length = 0.2
    bpy.context.view_layer.update()
    assert len(preview(addon, source, paper="A4").names) > 2


def test_pieces_that_do_not_fit_are_reported(addon, source):
    pages = preview(addon, source, paper="ROLL", roll_width=200.0)
    assert not pages.is_good and "too large for a roll of 200 mm" in pages.sentence
    assert not pages.places


@pytest.mark.skipif(bpy.app.version >= (5, 0, 0), reason="Blender 5 hides the data behind properties")
def test_choices_of_another_version_are_the_default(addon, source):
    for name in ("paper", "arrangement", "grain", "darts"):
        bpy.context.scene["wirewarp"][name] = 77
    assert preview(addon, source).sentence.endswith("A4. Drawn below the pieces")


def test_the_panel_and_the_view_show_the_pages(addon, source):
    select_only(flat_of(source))
    drawn = addon.overlay.shown.drawings(view_context())
    shown = {drawing.target.name: drawing for drawing in drawn}
    assert "page" in shown["Bump Flat"].lines.places and "page" not in shown["Bump"].lines.places
    assert {"A1"} <= {text for name in shown["Bump Flat"].lines.names for text in name.texts}
    bpy.context.scene.wirewarp.show_lines = False
    (pieces,) = (each for each in addon.overlay.shown.drawings(view_context()) if each.target.name == "Bump Flat")
    assert set(pieces.lines.places) == {"page", "cut"}
    bpy.context.scene.wirewarp.show_pages = False
    assert list(addon.overlay.shown.drawings(view_context())) == []
