# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a PDF document with named layers, in millimeters. pydyf writes the objects of the format."""

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
import pydyf

from ..label import helvetica
from ..label.glyphs import NoLettersError, line_of
from ..label.text_place import LINE
from ..model import Text
from ..sheet.drawing import Stroke, letters_baselines
from ..units import INCH

POINT = 72 / INCH  # units of PDF in a millimeter


class Content:
    """A stream of drawing commands in millimeters. thinnest: least width of the lines."""

    def __init__(self, thinnest: float = 0.0) -> None:
        self._thinnest = thinnest
        self._parts: list[str] = []
        self.left_out: list[str] = []  # sentences about texts that could not be drawn

    def in_layer(self, layer: str, strokes: Iterable[Stroke], texts: Iterable[Text] = ()) -> None:
        body = [self._stroke(stroke) for stroke in strokes] + [self._text(text) for text in texts]
        if body:
            self._parts += [f"/OC /{_key(layer)} BDC q 1 J 1 j", *body, "Q EMC"]

    def add_form(self, name: str, offset: np.ndarray) -> None:
        self._parts.append(f"q 1 0 0 1 {_pair(offset)} cm /{name} Do Q")

    def clip(self, low: np.ndarray, high: np.ndarray) -> None:
        self._parts.append(f"q {_pair(low)} {_pair(high - low)} re W n")

    def unclip(self) -> None:
        self._parts.append("Q")

    def data(self) -> bytes:
        return "\n".join(self._parts).encode("latin-1")

    def _stroke(self, stroke: Stroke) -> str:
        dashes = " ".join(f"{dash:g}" for dash in stroke.look.dashes)
        corners = [f"{x:.4f} {y:.4f}" for x, y in stroke.points.tolist()]
        return (
            f"{_rgb(stroke.look.color)} RG {max(stroke.look.stroke, self._thinnest):g} w [{dashes}] 0 d\n"
            f"{corners[0]} m\n" + "".join(f"{corner} l\n" for corner in corners[1:]) + ("s" if stroke.closed else "S")
        )

    def _text(self, text: Text) -> str:
        angle = np.deg2rad(text.angle)
        along = np.array([np.cos(angle), np.sin(angle)])
        parts = ["0.2 g"]
        for line, middle in letters_baselines(text, LINE):
            letters = helvetica.encoded(line)
            if letters is None:
                parts.append(self._outlines(line, middle, along * text.height))
                continue
            start = middle - along * helvetica.width(letters, text.height) / 2
            turn = f"{along[0]:.6f} {along[1]:.6f} {-along[1]:.6f} {along[0]:.6f}"
            escaped = letters.replace(b"\\", b"\\\\").replace(b"(", b"\\(").replace(b")", b"\\)").decode("latin-1")
            parts.append(f"BT /F {text.height:.3f} Tf {turn} {_pair(start)} Tm ({escaped}) Tj ET")
        return "\n".join(parts)

    def _outlines(self, line: str, middle: np.ndarray, along: np.ndarray) -> str:
        """Return commands that draw a line with non-Latin letters as filled outlines.

        along (2,): vector in the direction of the line, as long as the text is high.
        """
        try:
            drawn = line_of(line)
        except NoLettersError as error:
            self.left_out.append(f'"{line}" is left out of the PDF: {error}.')
            return ""
        axes = np.array([along, [-along[1], along[0]]])
        start = middle - along * drawn.width / 2
        parts = [" ".join([*map(_pair, points @ axes + start), operator]) for operator, points in drawn.parts]
        return "\n".join([*parts, "f"]) if parts else ""


class Document:
    def __init__(self, title: str, layers: Sequence[str], hidden: Sequence[str] = ()) -> None:
        """Begin a document. hidden: layers that are off until the reader turns them on."""
        self.page_count = 0
        self._pdf = pydyf.PDF()
        # A shortened title may end with half of a surrogate pair, which cannot be encoded.
        whole = title.encode("utf-16", "replace").decode("utf-16")
        self._pdf.info["Title"] = pydyf.String(whole)
        self._pdf.info["Creator"] = pydyf.String("WireWarp")
        self._groups = {layer: pydyf.Dictionary({"Type": "/OCG", "Name": pydyf.String(layer)}) for layer in layers}
        font = {"Type": "/Font", "Subtype": "/Type1", "BaseFont": "/Helvetica", "Encoding": "/WinAnsiEncoding"}
        self._font = pydyf.Dictionary(font)
        for each in (*self._groups.values(), self._font):
            self._pdf.add_object(each)
        references = {layer: group.reference for layer, group in self._groups.items()}
        default = {
            "Name": pydyf.String("Layers"),
            "Order": pydyf.Array(references.values()),
            "ON": pydyf.Array(references[layer] for layer in layers if layer not in hidden),
            "OFF": pydyf.Array(references[layer] for layer in hidden),
        }
        properties = {"OCGs": pydyf.Array(references.values()), "D": pydyf.Dictionary(default)}
        self._pdf.catalog["OCProperties"] = pydyf.Dictionary(properties)
        self._pdf.catalog["PageMode"] = "/UseOC"
        # The print dialog must not scale the pages.
        self._pdf.catalog["ViewerPreferences"] = pydyf.Dictionary({"PrintScaling": "/None"})
        shown = pydyf.Dictionary({_key(layer): reference for layer, reference in references.items()})
        self._resources = {"Properties": shown, "Font": pydyf.Dictionary({"F": self._font.reference})}
        self._forms: dict[str, bytes] = {}

    def add_form(self, name: str, content: Content, low: np.ndarray, high: np.ndarray) -> None:
        """Add a drawing that several pages share. low, high (2,): corners of its box, including the width of lines."""
        extra = {
            "Type": "/XObject",
            "Subtype": "/Form",
            "BBox": pydyf.Array([*map(float, low), *map(float, high)]),
            "Resources": pydyf.Dictionary(self._resources),
        }
        form = pydyf.Stream([content.data()], extra, compress=True)
        self._pdf.add_object(form)
        self._forms[name] = form.reference

    def add_page(self, size: np.ndarray, content: Content) -> None:
        """Add a page. size (2,): width and height in millimeters. 0, 0 is the lower left corner of the page."""
        scaled = pydyf.Stream([f"{POINT:.12f} 0 0 {POINT:.12f} 0 0 cm".encode(), content.data()], compress=True)
        self._pdf.add_object(scaled)
        resources = self._resources | {"XObject": pydyf.Dictionary(self._forms)}
        page = {
            "Type": "/Page",
            "Parent": self._pdf.pages.reference,
            "MediaBox": pydyf.Array([0, 0, *(float(side * POINT) for side in size)]),
            "Contents": scaled.reference,
            "Resources": pydyf.Dictionary(resources),
        }
        self._pdf.add_page(pydyf.Dictionary(page))
        self.page_count += 1

    def write(self, path: Path) -> None:
        with path.open("wb") as file:
            self._pdf.write(file)


def _key(layer: str) -> str:
    return "L" + "".join(letter for letter in layer if letter.isalnum())


def _pair(point: np.ndarray) -> str:
    return f"{point[0]:.4f} {point[1]:.4f}"


def _rgb(color: str) -> str:
    return " ".join(f"{int(color[start : start + 2], 16) / 255:.3g}" for start in (1, 3, 5))
