# SPDX-License-Identifier: GPL-3.0-or-later
"""Names in any script are drawn with fonts. The tests make a font in which each letter is a box of its own width."""

import numpy as np
import pypdfium2
import pytest
from bidi import get_display
from hypothesis import given
from hypothesis import strategies as st
from patterns import dark, longest_run, rectangle
from wirewarp.pattern import Pattern, add_font_folder
from wirewarp.pattern.formats.dxf_tags import escaped_text
from wirewarp.pattern.label import glyphs
from wirewarp.pattern.label.bidi import in_visual_order, levels

builder = pytest.importorskip("fontTools.fontBuilder")
pens = pytest.importorskip("fontTools.pens.ttGlyphPen")

# widths of letters, in thousandths of the font size
LETTERS = {"ж": 600, "袖": 1000, "م": 400, "ن": 300, " ": 250, "٢": 200, "٣": 350, "(": 150, ")": 450}
NO_OUTLINE = "👗"  # a letter without an outline, like emojis, which are pictures


@pytest.fixture
def folder(tmp_path, no_fonts):
    """Return a folder whose folder "fonts" has the only fonts: a valid font, a damaged file, and a broken link."""
    (tmp_path / "fonts").mkdir()
    write_font(tmp_path / "fonts" / "boxes.ttf", LETTERS | {NO_OUTLINE: 0})
    (tmp_path / "fonts" / "broken.ttf").write_bytes(b"no font")
    (tmp_path / "fonts" / "gone.ttf").symlink_to(tmp_path / "nowhere.ttf")
    add_font_folder(tmp_path / "fonts")
    return tmp_path


def write_font(path, widths):
    names = {letter: f"u{ord(letter):04X}" for letter in widths}
    font = builder.FontBuilder(1000, isTTF=True)
    font.setupGlyphOrder([".notdef", *names.values()])
    font.setupCharacterMap({ord(letter): name for letter, name in names.items()})
    shapes = {".notdef": pens.TTGlyphPen(None).glyph()}
    for letter, width in widths.items():
        pen = pens.TTGlyphPen(None)
        if width and letter != " ":
            corners = [(0, 0), (0, 700), (width, 700), (width, 0)]
            pen.moveTo(corners[0])
            for corner in corners[1:]:
                pen.lineTo(corner)
            pen.closePath()
        shapes[names[letter]] = pen.glyph()
    font.setupGlyf(shapes)
    font.setupHorizontalMetrics(
        {".notdef": (500, 0), **{names[letter]: (width, 0) for letter, width in widths.items()}}
    )
    font.setupHorizontalHeader(ascent=800, descent=-200)
    font.setupNameTable({"familyName": path.stem, "styleName": "Regular"})
    font.setupOS2()
    font.setupPost()
    font.save(path)


def boxes(text):
    """Return the (start, width) of each letter from left to right, in thousandths of the font size."""
    found = []
    for operator, points in glyphs.line_of(text).parts:
        if operator == "m":
            found.append([])
        found[-1] += [round(1000 * x) for x in points[:, 0]]
    return sorted((min(across), max(across) - min(across)) for across in found)


@pytest.mark.parametrize(
    ("text", "letters"),
    [
        ("ж袖", [(0, 600), (600, 1000)]),
        ("من", [(0, 300), (300, 400)]),  # right to left
        ("ж من", [(0, 600), (850, 300), (1150, 400)]),
        ("من ж", [(0, 600), (850, 300), (1150, 400)]),  # the line starts at the right, with the Arabic word
        ("٢٣", [(0, 200), (200, 350)]),  # Arabic digits run from left to right
        ("م ٢٣", [(0, 200), (200, 350), (800, 400)]),
        ("(م)", [(0, 150), (150, 400), (550, 450)]),  # mirrored brackets
        ("م(ن)", [(0, 150), (150, 300), (450, 450), (900, 400)]),
    ],
    ids=range(8),
)
def test_letters_are_placed_in_the_direction_of_their_script(folder, text, letters):
    assert boxes(text) == letters
    assert glyphs.line_of("ж袖").width == pytest.approx(1.6)


@given(st.text("aжאبم12١٢+-.,:$% ()[]!<>«»\u0301", max_size=14))
def test_letters_of_both_directions_are_placed_as_by_another_program(text):
    own = levels(text)
    assert "".join(in_visual_order(text, own)) == get_display(text)


def test_letters_are_printed_in_the_height_of_the_text(folder):
    pattern = Pattern.from_result(rectangle(300, 200), piece_names=["袖"], allowance=0.0, notch_spacing=0)
    written = pattern.with_only(["texts"]).write(folder / "x.pdf", paper="projector")
    assert written.warnings == []
    (text,) = pattern.pieces[0].texts
    (page,) = pypdfium2.PdfDocument(folder / "x.pdf")
    scale = 10  # pixels per millimeter
    pixels = dark(page, scale)
    # The largest dark rectangle is the letter, which is as wide as the text is high.
    assert max(longest(pixels), longest(pixels.T)) == pytest.approx(text.height * scale, abs=2)


def longest(pixels):
    """Return the longest run of dark pixels in a row. Only pixels that are dark 1.5 mm above and below count."""
    return max(map(longest_run, pixels & np.roll(pixels, 15, axis=0) & np.roll(pixels, -15, axis=0)))


@pytest.mark.parametrize(("name", "letter"), [("袂", "袂"), ("袖👗", NO_OUTLINE)])
def test_a_letter_that_no_font_has_is_reported(folder, name, letter):
    pattern = Pattern.from_result(rectangle(300, 200), piece_names=[name])
    assert pattern.write(folder / "x.pdf").warnings == [
        f'"{name}" is left out of the PDF: no font with the letter "{letter}" was found.'
    ]


def test_annotations_of_dxf_have_escapes():
    assert escaped_text("Ärmel ß?") == "Armel ss?"
    assert escaped_text("袖 1") == "\\U+8896 1"
    assert escaped_text("👗") == "?"
