# SPDX-License-Identifier: GPL-3.0-or-later
"""A pattern as an SVG file in true size: one unit is one millimeter.

One group per piece, and in it a layer, as Inkscape knows them, for each kind of line; each kind has its own color too,
by which cutters and plotters tell them apart.
"""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from .pattern import Pattern, PatternPiece, PieceText, Ruler
from .piece_texts import LINE

SVG, INKSCAPE = "http://www.w3.org/2000/svg", "http://www.inkscape.org/namespaces/inkscape"
MARGIN = 10.0  # around everything
DECIMALS = 4  # of a millimeter
ON_PAPER = ("Measure before cutting", "No seam allowance")  # below the length, in the square
# As attributes of every line: many cutters' programs read neither style sheets nor what a group hands down.
LINE_LOOK = {"fill": "none", "stroke-width": "0.3", "stroke-linejoin": "round"}
LOOKS = {
    "cut": {"stroke": "#000000"},
    "rigid": {"stroke": "#0048e8"},
    "elastic": {"stroke": "#c76b00", "stroke-dasharray": "6 2"},
    "free": {"stroke": "#008a78", "stroke-dasharray": "0.3 2", "stroke-linecap": "round", "stroke-width": "0.5"},
    "notch": {"stroke": "#d8001f"},
}
TEXT_LOOK = {"fill": "#505050", "font-family": "sans-serif", "text-anchor": "middle"}
NO_CHARACTER = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")  # of XML 1.0


def write_svg(path: Path, pattern: Pattern) -> None:
    """Raises OSError if the file cannot be written."""
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("inkscape", INKSCAPE)
    tree = ElementTree.ElementTree(_document(pattern))
    ElementTree.indent(tree, " ")
    tree.write(path, encoding="utf-8", xml_declaration=True)


def page_size(pattern: Pattern) -> np.ndarray:
    """Width and height in millimeters, the square to measure included."""
    return _page(pattern)[0]


def _page(pattern: Pattern) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The page's size, the offset that brings the pieces into it, and the lower left corner of the square.

    All with y upwards. The square stands right of the pieces or below them, where it takes less paper.
    """
    low, high = pattern.bounds
    width, height = high - low
    side = pattern.ruler.side
    beside = np.array([width + MARGIN + side, max(height, side)])
    below = np.array([max(width, side), height + MARGIN + side])
    border = np.array([MARGIN, MARGIN])
    if np.prod(beside) <= np.prod(below):
        return beside + 2 * MARGIN, border - low, border + (width + MARGIN, 0)
    return below + 2 * MARGIN, border + (0, side + MARGIN) - low, border


def _document(pattern: Pattern) -> ElementTree.Element:
    size, offset, square = _page(pattern)
    width, height = (f"{side:.{DECIMALS}f}" for side in size)
    root = ElementTree.Element(
        f"{{{SVG}}}svg", width=f"{width}mm", height=f"{height}mm", viewBox=f"0 0 {width} {height}", version="1.1"
    )
    _add(root, "title").text = pattern.title
    drawing = _Drawing(root, float(size[1]))
    for piece in pattern.pieces:
        drawing.add_piece(piece, offset)
    drawing.add_square(pattern.ruler, square)
    for element in root.iter():  # names may hold what XML cannot
        element.text = element.text and NO_CHARACTER.sub("\ufffd", element.text)
        for key, value in element.items():
            element.set(key, NO_CHARACTER.sub("\ufffd", value))
    return root


class _Drawing:
    """Everything comes in with y upwards and the origin in the page's lower left corner; on the page y is downwards."""

    def __init__(self, root: ElementTree.Element, height: float) -> None:
        self._root, self._height = root, height
        self._ids: set[str] = set()

    def add_piece(self, piece: PatternPiece, offset: np.ndarray) -> None:
        group = self._add_group(self._root, piece.name, piece.name)
        _add(group, "title").text = piece.name
        cut = self._add_layer(group, piece.name, "Cut")
        for outline in piece.outlines:
            self._add_path(cut, "cut", outline + offset, closed=True)
        for kind in ("rigid", "elastic", "free"):
            wires = [wire for wire in piece.wires if wire.kind == kind]
            layer = self._add_layer(group, piece.name, f"{kind.capitalize()} Wires") if wires else group
            for wire in wires:
                line = self._add_path(layer, kind, wire.points + offset, closed=False)
                _add(line, "title").text = wire.name
        notches = self._add_layer(group, piece.name, "Notches")
        for notch in piece.notches:
            self._add_path(notches, "notch", notch.line + offset, closed=False)
        self._add_text(self._add_layer(group, piece.name, "Text"), piece.text, piece.text.center + offset)
        names = self._add_layer(group, piece.name, "Line Names") if piece.line_names else group
        for name in piece.line_names:
            self._add_text(names, name, name.center + offset)

    def add_square(self, ruler: Ruler, corner: np.ndarray) -> None:
        layer = self._add_layer(self._root, "", "Scale")
        corners = corner + ruler.side * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
        self._add_path(layer, "cut", corners, closed=True)
        center = corner + ruler.side / 2
        self._add_text(layer, PieceText((ruler.text, *ON_PAPER), center, 5.0, 0.0), center)

    def _add_path(self, layer: ElementTree.Element, kind: str, points: np.ndarray, closed: bool) -> ElementTree.Element:
        down = points * (1, -1) + (0, self._height)
        corners = " ".join(f"{x:.{DECIMALS}f},{y:.{DECIMALS}f}" for x, y in down)
        return _add(layer, "path", **LINE_LOOK | LOOKS[kind], d=f"M {corners}{' Z' if closed else ''}")

    def _add_text(self, layer: ElementTree.Element, text: PieceText, center: np.ndarray) -> None:
        x, y = center * (1, -1) + (0, self._height)
        placed = f"translate({x:.{DECIMALS}f} {y:.{DECIMALS}f}) rotate({-text.angle:g})"
        element = _add(layer, "text", **TEXT_LOOK | {"font-size": f"{text.height:.2f}", "transform": placed})
        for number, line in enumerate(text.lines):
            base = LINE * (number - (len(text.lines) - 1) / 2) + 0.36  # capitals are 0.72 of the size high
            _add(element, "tspan", x="0", y=f"{base * text.height:.2f}").text = line

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
    """The name as XML allows it for an id: no spaces, no digit in front; none twice."""
    plain = re.sub(r"[^\w.-]", "_", name)
    plain = plain if re.match(r"[^\W\d]", plain) else f"_{plain}"
    free, number = plain, 2
    while free in taken:
        free, number = f"{plain}_{number}", number + 1
    taken.add(free)
    return free
