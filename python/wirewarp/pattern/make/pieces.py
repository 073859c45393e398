# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pieces of a pattern from flat pieces: cutting lines, stitching lines, folds, wires and grain."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry import Rays, signed_area
from ..grain import grain_line
from ..model import Line, PatternPiece, Point
from ..progress import Steps
from ..units import UnitSystem
from .allowance import CutLines, cut_lines
from .outline import FlatPiece, Side, outlines_of
from .seams import SewnSide, longer_texts
from .sections import Outline, Rules, outline
from .widths import Widths

FOLD_NAME = "Place on the fold"
CLOSED_GAP = "the allowance fills a gap in the outline, so the gap is not cut. To cut it, use a smaller allowance."
STRAIGHT = 0.5  # millimeters; a fold with a smaller error counts as straight, because fabric stretches


@dataclass(frozen=True)
class Laid:
    """A piece with its sides, its outlines in sections, and its cutting lines."""

    index: int
    name: str
    loops: list[list[Side]]
    outlines: list[Outline]
    cut: CutLines
    wires: list[Line]
    grain: np.ndarray  # (2,) unit vector

    @property
    def rays(self) -> Rays:
        return Rays([*self.cut.outer, *self.cut.holes])

    @property
    def sew_loops(self) -> list[np.ndarray]:
        return [np.concatenate([side.points[:-1] for side in loop]) for loop in self.loops]

    @property
    def area(self) -> float:
        """Return the area inside the stitching lines, in square millimeters."""
        return abs(sum(map(signed_area, self.sew_loops)))

    def allowances(self, side: Side) -> tuple[float, ...]:
        """Return the widths of the allowance along a side, in millimeters. A leg of a closed dart has none."""
        runs = [run for own in self.outlines for run in own.runs if run.side is side]
        return tuple(run.width for run in runs if run.width is not None)


def _off_straight(points: np.ndarray) -> float:
    """Return the largest distance of the points (k,2) from the line through the first and the last point."""
    along = (points[-1] - points[0]) / max(float(np.linalg.norm(points[-1] - points[0])), 1e-9)
    to = points - points[0]
    return float(np.abs(to[:, 0] * along[1] - to[:, 1] * along[0]).max())


def lay_all(pieces: Sequence[FlatPiece], widths: Widths, corner: str, darts: str) -> Steps[list[Laid]]:
    """Return all pieces, in steps. Pieces are made together, because the ends of allowances depend on all seams. Raises
    FlattenError."""
    outlines = [outlines_of(index, piece) for index, piece in enumerate(pieces)]
    rules = Rules([loop for own in outlines for loop in own], corner, darts)
    laid = []
    for index, (piece, own) in enumerate(zip(pieces, outlines, strict=True)):
        yield "allowance", index / len(pieces)
        laid.append(_lay(index, piece, own, [outline(loop, widths, rules) for loop in own]))
    widths.check_all_used()
    return laid


def _lay(index: int, piece: FlatPiece, loops: list[list[Side]], outlines: list[Outline]) -> Laid:
    cut = cut_lines([outline.sections for outline in outlines if outline.sections])
    wires = [Line("wire", piece.vertices[wire.vertices], name=wire.name, kind=wire.kind) for wire in piece.wires]
    return Laid(index, piece.name, loops, outlines, cut, wires, piece.grain)


def warnings_of(laid: Laid) -> list[str]:
    """Return sentences about problems with the allowance or the fold that the maker should know."""
    found = []
    holes = sum(1 for outline in laid.outlines if outline.sections) - 1
    if len(laid.cut.holes) < holes:
        found.append(
            f'"{laid.name}": the allowance fills {holes - len(laid.cut.holes)} of {holes} holes, which are not cut.'
        )
    if laid.cut.pockets:
        found.append(f'"{laid.name}": {CLOSED_GAP}')
    crooked = max((_off_straight(run.points) for own in laid.outlines for run in own.runs if run.is_fold), default=0.0)
    if crooked > STRAIGHT:
        found.append(f'"{laid.name}": its fold is {crooked:.1f} mm off a straight line. Fabric cannot fold there.')
    if len(laid.cut.outer) > 1:
        found.append(f'"{laid.name}" is cut as {len(laid.cut.outer)} parts, which only touch at single points.')
    return found


def joined_by(pieces: Sequence[Laid]) -> dict[int, list[str]]:
    """Return the names of the pieces that each seam joins, one for each side, by the index of the seam."""
    names: dict[int, list[str]] = {}
    for laid in pieces:
        for side in (side for loop in laid.loops for side in loop):
            if side.seam is not None:
                names.setdefault(side.seam, []).append(laid.name)
    return names


def notes_on_sides(seams: Sequence[Sequence[SewnSide]], units: UnitSystem) -> dict[int, str]:
    """Return notes on sides that are longer than the shortest side of their seam, by the id() of the side."""
    notes: dict[int, str] = {}
    for sides in (own for own in seams if own):
        texts = longer_texts([float(own.along[-1]) for own in sides], units)
        notes |= {id(own.side): text for own, text in zip(sides, texts, strict=True) if text}
    return notes


def closed_cuts(laid: Laid) -> list[Line]:
    lines = [Line("cut", points, closed=True) for points in laid.cut.outer]
    return lines + [Line("inner_cut", points, closed=True) for points in laid.cut.holes]


def _sewn(laid: Laid, describe: Callable[[Side], Mapping[str, str]]) -> list[Line]:
    """Return stitching lines and folds. describe: returns the fields of Line (such as name) for a side of a seam."""
    lines = []
    for own in laid.outlines:
        for run in own.runs:
            is_whole = len(own.runs) == 1 and run.side.is_closed
            points = run.points[:-1] if is_whole else run.points
            if run.is_fold:
                lines.append(Line("fold", points, name=FOLD_NAME))
            else:
                words = {} if run.side.seam is None else describe(run.side)
                lines.append(Line("sew", points, is_whole, width=run.width, seam=run.side.seam, **words))
    return lines


def finished(
    laid: Laid, points: Sequence[Point], describe: Callable[[Side], Mapping[str, str]], material: str
) -> PatternPiece:
    """Return the piece without texts. points: its marks. describe: returns the fields of Line for a side of a seam."""
    lines = [*closed_cuts(laid), *(Line("inner_cut", slit) for own in laid.outlines for slit in own.slits)]
    lines += [*_sewn(laid, describe), *laid.wires]
    lines.append(grain_line(laid.sew_loops, [wire.points for wire in laid.wires], laid.grain))
    on_fold = any(run.is_fold for outline in laid.outlines for run in outline.runs)
    widths = tuple(sorted({run.width for outline in laid.outlines for run in outline.runs if run.width}))
    return PatternPiece(
        laid.index + 1,
        laid.name,
        lines,
        list(points),
        [],
        material=material,
        on_fold=on_fold,
        area=laid.area,
        allowances=widths,
    )


def outlined(laid: Laid) -> PatternPiece:
    """Return the piece with its lines, without names, marks and texts."""
    sewn = _sewn(laid, lambda *_: {})
    lines = [*closed_cuts(laid), *sewn, *laid.wires]
    return PatternPiece(laid.index + 1, laid.name, lines, [], [], on_fold=any(line.role == "fold" for line in sewn))
