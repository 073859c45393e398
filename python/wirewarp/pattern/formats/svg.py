# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a pattern as an SVG file in actual size.

Each piece is a group, with a layer of Inkscape for each kind of line. Cutters and plotters distinguish these kinds by
color.
"""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..checks import problem
from ..label.text_place import LINE
from ..model import PatternPiece, Text
from ..pattern_data import PatternData
from ..progress import Steps
from ..sheet.drawing import LAYERS, LOOKS, Stroke, base_lines, strokes_of
from ..units import INCH
from .file_format import Choice, Format, Option
from .read_back import read_svg

SVG, INKSCAPE = "http://www.w3.org/2000/svg", "http://www.inkscape.org/namespaces/inkscape"
MARGIN = 10.0  # millimeters around the drawing
DECIMALS = 4  # decimals of the coordinates, which are in millimeters; as fine as GRID of geometry.py
# This matches all characters that XML 1.0 does not allow.
NO_CHARACTER = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


PIXEL = INCH / 96  # millimeters in a pixel of CSS


@dataclass(frozen=True)
class Preset:
    """The look of lines in files for one kind of program."""

    label: str
    description: str
    stroke: float | None = None  # width of all lines in millimeters; None: each line has its own width
    has_texts: bool = True
    has_dashes: bool = True
    # If true, lengths are in pixels (96 per inch), without a viewBox, because some programs ignore units and viewBox.
    in_pixels: bool = False


PRESETS = {
    "print": Preset("To print or draw on", "Colors, dashes and texts"),
    "laser": Preset(
        "Laser",
        "For LightBurn, Glowforge and similar programs: thin lines without dashes, no texts",
        stroke=0.1,
        has_texts=False,
        has_dashes=False,
    ),
    "cricut": Preset(
        "Cricut",
        "Like Laser, but in pixels, for programs that ignore units",
        stroke=0.3,
        has_texts=False,
        has_dashes=False,
        in_pixels=True,
    ),
}


def write_svg(path: Path, pattern: PatternData, preset: str = "print") -> Steps[tuple[int, list[str]]]:
    """Write the file in steps. Return 1 for one page, and no warnings. preset: a key of PRESETS."""
    if preset not in PRESETS:
        raise problem(f"preset is {preset!r}: give {', '.join(map(repr, PRESETS))}.")
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("inkscape", INKSCAPE)
    tree = ElementTree.ElementTree((yield from _document(pattern, PRESETS[preset])))
    ElementTree.indent(tree, " ")
    tree.write(path, encoding="utf-8", xml_declaration=True)
    return 1, []


def page_size(pattern: PatternData) -> np.ndarray:
    """Return width and height (2,) of the file in millimeters, including the test square."""
    return _page(pattern.size, pattern.units.square[0])[0]


def _page(pieces: np.ndarray, side: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the size of the page, and the lower left corners of the pieces and of the test square.

    pieces (2,): size of all pieces in millimeters; side: side of the square. y points upwards.
    """
    width, height = pieces
    beside = np.array([width + MARGIN + side, max(height, side)])
    below = np.array([max(width, side), height + MARGIN + side])
    border = np.array([MARGIN, MARGIN])
    if np.prod(beside) <= np.prod(below):
        return beside + 2 * MARGIN, border, border + (width + MARGIN, 0)
    return below + 2 * MARGIN, border + (0, side + MARGIN), border


def _document(pattern: PatternData, preset: Preset) -> Steps[ElementTree.Element]:
    side, label = pattern.units.square
    (width, height), offset, square = _page(pattern.size, side)
    offset = offset - np.min([piece.bounds[0] for piece in pattern.pieces], axis=0)
    unit = PIXEL if preset.in_pixels else 1.0
    shown = [f"{value / unit:.{DECIMALS}f}" for value in (width, height)]
    root = ElementTree.Element(f"{{{SVG}}}svg", version="1.1")
    for name, value in zip(("width", "height"), shown, strict=True):
        root.set(name, value if preset.in_pixels else f"{value}mm")
    if not preset.in_pixels:
        root.set("viewBox", f"0 0 {' '.join(shown)}")
    _add(root, "title").text = pattern.title
    drawing = _Drawing(root, height, preset)
    for number, piece in enumerate(pattern.pieces):
        yield "writing", number / len(pattern.pieces)
        drawing.add_piece(piece.moved(offset))
    drawing.add_square(side, label, pattern.allowance_text, square)
    for element in root.iter():
        element.text = element.text and NO_CHARACTER.sub("\ufffd", element.text)
        for key, value in element.items():
            element.set(key, NO_CHARACTER.sub("\ufffd", value))
    return root


class _Drawing:
    """Draws on a page whose y points down. Its methods use y upwards, from the lower left corner of the page."""

    def __init__(self, root: ElementTree.Element, height: float, preset: Preset) -> None:
        self._root, self._height, self._preset = root, height, preset
        self._unit = PIXEL if preset.in_pixels else 1.0
        self._ids: set[str] = set()

    def add_piece(self, piece: PatternPiece) -> None:
        group = self._add_group(self._root, piece.name, piece.name)
        _add(group, "title").text = piece.name
        drawn = piece if self._preset.has_texts else piece.without_texts_beside()
        strokes = list(strokes_of(drawn))
        for label in reversed(LAYERS):  # the cutting line is drawn last
            own = [stroke for stroke in strokes if stroke.look.layer == label]
            texts = [text for text in piece.texts if LOOKS[text.role].layer == label and self._preset.has_texts]
            if own or texts:
                layer = self._add_layer(group, piece.name, label)
                for stroke in own:
                    self._add_path(layer, stroke)
                for text in texts:
                    self._add_text(layer, text)

    def add_square(self, side: float, label: str, allowance: str, corner: np.ndarray) -> None:
        layer = self._add_layer(self._root, "", LOOKS["scale"].layer)
        self._add_path(layer, Stroke("scale", corner + side * np.array([[0, 0], [1, 0], [1, 1], [0, 1]]), True))
        included = "No seam allowance" if allowance == "none" else f"Allowance included: {allowance}"
        lines = (label, "Measure before cutting", included)
        if self._preset.has_texts:
            self._add_text(layer, Text(lines, corner + side / 2, 5.0))

    def _add_path(self, layer: ElementTree.Element, stroke: Stroke) -> None:
        down = (stroke.points * (1, -1) + (0, self._height)) / self._unit
        corners = " ".join(f"{x:.{DECIMALS}f},{y:.{DECIMALS}f}" for x, y in down)
        # Every line has its own attributes, because many programs for cutters ignore style sheets and attributes of
        # groups.
        width = (self._preset.stroke or stroke.look.stroke) / self._unit
        look = {"fill": "none", "stroke": stroke.look.color, "stroke-width": f"{width:.3g}"}
        look |= {"stroke-linejoin": "round", "data-role": stroke.role}
        if stroke.look.dashes and self._preset.has_dashes:
            look["stroke-dasharray"] = " ".join(f"{dash:g}" for dash in stroke.look.dashes)
        path = _add(layer, "path", **look, d=f"M {corners}{' Z' if stroke.closed else ''}")
        if stroke.name:
            _add(path, "title").text = stroke.name

    def _add_text(self, layer: ElementTree.Element, text: Text) -> None:
        x, y = text.center * (1, -1) + (0, self._height)
        placed = f"translate({x:.{DECIMALS}f} {y:.{DECIMALS}f}) rotate({-text.angle:g})"
        look = {"fill": LOOKS[text.role].color, "font-family": "sans-serif", "text-anchor": "middle"}
        element = _add(layer, "text", **look, **{"font-size": f"{text.height:.2f}", "transform": placed})
        for line, below in base_lines(text, LINE):
            _add(element, "tspan", x="0", y=f"{below:.2f}").text = line

    def _add_layer(self, parent: ElementTree.Element, owner: str, label: str) -> ElementTree.Element:
        layer = self._add_group(parent, f"{owner} {label}".strip(), label)
        layer.set(f"{{{INKSCAPE}}}groupmode", "layer")
        return layer

    def _add_group(self, parent: ElementTree.Element, name: str, label: str) -> ElementTree.Element:
        group = _add(parent, "g", id=_free_id(name, self._ids))
        group.set(f"{{{INKSCAPE}}}label", label)
        return group


def _add(parent: ElementTree.Element, tag: str, **attributes: str) -> ElementTree.Element:
    return ElementTree.SubElement(parent, f"{{{SVG}}}{tag}", attributes)


def _free_id(name: str, taken: set[str]) -> str:
    """Return the name as a unique id for XML: without spaces, and without a digit at the beginning. Add it to
    `taken`."""
    plain = re.sub(r"[^\w.-]", "_", name)
    plain = plain if re.match(r"[^\W\d]", plain) else f"_{plain}"
    free, number = plain, 2
    while free in taken:
        free, number = f"{plain}_{number}", number + 1
    taken.add(free)
    return free


SVG_FORMAT = Format(
    ".svg",
    "SVG, to draw on and cut",
    "For Inkscape, LightBurn, Glowforge and Cricut",
    write_svg,
    read_svg,
    options=(
        Option(
            "preset",
            "For",
            "Programs that read the file",
            tuple(Choice(name, each.label, each.description) for name, each in PRESETS.items()),
        ),
    ),
    size_of=page_size,
)
