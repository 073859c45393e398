# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the cutting lines and the pages of flat pieces as arrays, without the GPU."""

from dataclasses import dataclass, field

import numpy as np

from ..core import FlattenError, counted, pattern
from ..export.export import Cloth, PatternParts, laid_on_kept
from ..export.read import kept_marker
from ..issues import ObjectError
from .lines import Name

BELOW = 50.0  # millimeters between the pieces and the pages below them, so that they look separate
# Place of a page's name from the page's lower left corner, as shares of its size: 13 mm and 15 mm on A4.
INSET = np.array([0.06, 0.05])


@dataclass(frozen=True)
class CutLines:
    """The cutting lines of the pieces in their places, in millimeters."""

    made: pattern.Pattern | None  # None if no pattern can be made from the pieces; Export reports why
    has_allowance: bool


@dataclass(frozen=True)
class PagePreview:
    """The pages to draw. Places and names are in Blender units, in the space of the flat pieces."""

    sentence: str  # number of pages, or why there are none
    is_good: bool
    places: dict[str, np.ndarray] = field(default_factory=dict)  # (2k,3) float32, ends of lines by kind
    names: list[Name] = field(default_factory=list)


def cut_lines(parts: PatternParts | None, allowance: float, **options: object) -> CutLines:
    """Return the cutting lines. parts: see read_outlines; allowance: allowance of unmarked edges, in millimeters;
    options: see PatternOptions."""
    if parts is None:
        return CutLines(None, False)
    try:
        return CutLines(parts.cut_lines(allowance=allowance, **options), allowance > 0 or any(parts.allowances))
    except ObjectError:
        return CutLines(None, False)


def cut_places(cut: CutLines, millimeters: float) -> np.ndarray:
    """Return the ends (2k,3) of the cutting lines in Blender units, float32; empty if no piece has an allowance.
    millimeters: number of millimeters in a Blender unit."""
    return _in_space(_outlines(cut.made) if cut.made and cut.has_allowance else [], np.zeros(2), millimeters)


@dataclass(frozen=True)
class PageChoices:
    paper: str | float  # paper for the library: a name, or the width of a roll in millimeters
    arrangement: str  # "IN_ROWS", "AS_LAID_OUT" or "MARKER"
    cloth: Cloth  # the fabric of a marker
    marker: str  # text of the stored marker, see export.read


def page_preview(cut: CutLines, drawn: CutLines, choices: PageChoices, millimeters: float) -> PagePreview:
    """Return the pages of a PDF, over the pieces, or below the pieces if the PDF arranges them differently.

    cut: cutting lines of all pieces in their places
    drawn: cutting lines in the PDF, with copies drawn once and symmetric pieces as halves
    millimeters: number of millimeters in a Blender unit
    """
    made = drawn.made
    if made is None or cut.made is None:
        return PagePreview("These pieces cannot be exported. Press Export Pattern to see the reason.", False)
    if choices.arrangement == "MARKER":
        made = laid_on_kept(made, kept_marker(choices.marker), choices.cloth)
        if made is None:
            return PagePreview("No marker of these pieces on this fabric yet. Export Pattern makes the marker.", True)
    keeps = choices.arrangement == "AS_LAID_OUT"
    try:
        paper = None if made.marker else choices.paper
        laid, pages = (made.arranged() if choices.arrangement == "IN_ROWS" else made).pages(paper, keeps)
    except FlattenError as error:
        return PagePreview(error.message, False)
    if keeps:
        offset = made.bounds[0] - laid.bounds[0]
    else:
        lows, highs = (np.array([page.low + share * page.size for page in pages]) for share in (0, 1))
        offset = cut.made.bounds[0] - (lows[:, 0].min(), highs[:, 1].max()) - (0, BELOW)
    unit = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    places = {"page": _in_space([page.low + page.size * unit for page in pages], offset, millimeters)}
    if not keeps:
        places["cut"] = _in_space(_outlines(laid), offset, millimeters)
    names = [
        Name(
            (page.name,),
            np.append((page.low + INSET * page.size + offset) / millimeters, 0.0)[None],
            np.array([[0.0, 0.0, 1.0]]),
            float(page.size[0]) / 2 / millimeters,
            piece=-1 - number,
        )
        for number, page in enumerate(pages)
    ]
    if made.marker:
        sentence = made.marker.sentence(made.units)
    else:
        known = pattern.PAPERS.get(str(choices.paper))
        label = known.label if known else f"Roll of {made.units.text(float(choices.paper))}"
        sentence = f"{counted(len(pages), 'sheet' if known and known.height else 'page')}: {label}"
    return PagePreview(sentence if keeps else f"{sentence}. Drawn below the pieces", True, places, names)


def _outlines(made: pattern.Pattern) -> list[np.ndarray]:
    return [line.points for piece in made.pieces for line in piece.of_role("cut", "inner_cut")]


def _in_space(outlines: list[np.ndarray], offset: np.ndarray, millimeters: float) -> np.ndarray:
    """Return the ends (2k,3) of the edges of closed lines in Blender units, float32. outlines: points (k,2) of each
    line in millimeters; offset (2,): added to the points."""
    ends = [np.stack([line, np.roll(line, -1, axis=0)], axis=1).reshape(-1, 2) for line in outlines]
    places = (np.concatenate([np.empty((0, 2)), *ends]) + offset) / millimeters
    return np.column_stack([places, np.zeros(len(places))]).astype(np.float32)
