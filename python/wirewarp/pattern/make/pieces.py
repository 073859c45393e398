# SPDX-License-Identifier: GPL-3.0-or-later
"""From the outlines of flat pieces to pieces of a pattern: cut lines, stitching lines, wires, marks and texts."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry import Rays, innermost_point, signed_area
from ..model import Line, PatternPiece, Point
from ..progress import Steps
from ..units import UnitSystem
from .allowance import CutLines, cut_lines
from .outline import FlatPiece, Side, outlines_of
from .seams import SewnSide, longer_texts
from .sections import Outline, Rules, outline
from .widths import Widths

GRAIN = 0.7  # of the way across the piece
STRAIGHT = 0.5  # millimeters: a fold that is less off is straight, for cloth gives so much


@dataclass(frozen=True)
class Laid:
    """A piece whose outlines are cut into sections, and its cut lines."""

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

    def allowances(self, side: Side) -> tuple[float, ...]:
        """The widths along a side of this piece, in millimeters; none of a leg of a closed dart."""
        runs = [run for own in self.outlines for run in own.runs if run.side is side]
        return tuple(run.width for run in runs if run.width is not None)


def _off_straight(points: np.ndarray) -> float:
    """How far the points (k,2) lie at most from the line through the first and the last of them."""
    along = (points[-1] - points[0]) / max(float(np.linalg.norm(points[-1] - points[0])), 1e-9)
    to = points - points[0]
    return float(np.abs(to[:, 0] * along[1] - to[:, 1] * along[0]).max())


def lay_all(pieces: Sequence[FlatPiece], widths: Widths, corner: str, darts: str) -> Steps[list[Laid]]:
    """All pieces of a pattern; how allowances end depends on what is sewn to what. Raises FlattenError."""
    outlines = [outlines_of(index, piece) for index, piece in enumerate(pieces)]
    rules = Rules([loop for own in outlines for loop in own], corner, darts)
    laid = []
    for index, (piece, own) in enumerate(zip(pieces, outlines, strict=True)):
        yield "allowance", index / len(pieces)
        laid.append(_lay(index, piece, own, [outline(loop, widths, rules) for loop in own]))
    widths.check_all_used()
    return laid


def _lay(index: int, piece: FlatPiece, loops: list[list[Side]], outlines: list[Outline]) -> Laid:
    """With the cut lines and the wires inside of the piece."""
    cut = cut_lines([outline.sections for outline in outlines if outline.sections])
    wires = [Line("wire", piece.vertices[wire.vertices], name=wire.name, kind=wire.kind) for wire in piece.wires]
    return Laid(index, piece.name, loops, outlines, cut, wires, piece.grain)


def warnings_of(laid: Laid) -> list[str]:
    """What the allowance does to the piece that the maker should know."""
    found = []
    holes = sum(1 for outline in laid.outlines if outline.sections) - 1
    if len(laid.cut.holes) < holes:
        found.append(
            f'"{laid.name}": the allowance fills {holes - len(laid.cut.holes)} of {holes} holes; they are not cut.'
        )
    if laid.cut.pockets:
        found.append(f'"{laid.name}": the allowance closes a gap in the outline; what it encloses is not cut out.')
    crooked = max((_off_straight(run.points) for own in laid.outlines for run in own.runs if run.is_fold), default=0.0)
    if crooked > STRAIGHT:
        found.append(f'"{laid.name}": its fold is not straight but {crooked:.1f} mm off, so cloth does not fold there.')
    if len(laid.cut.outer) > 1:
        found.append(f'"{laid.name}" is cut as {len(laid.cut.outer)} parts, for it hangs together in single points.')
    return found


def joined_by(pieces: Sequence[Laid]) -> dict[int, list[str]]:
    """By index of the seam, the names of the pieces that it joins, one for each side."""
    names: dict[int, list[str]] = {}
    for laid in pieces:
        for side in (side for loop in laid.loops for side in loop):
            if side.seam is not None:
                names.setdefault(side.seam, []).append(laid.name)
    return names


def notes_on_sides(seams: Sequence[Sequence[SewnSide]], units: UnitSystem) -> dict[int, str]:
    """By the side's id(), the notes on those that are longer than what they are sewn to."""
    notes: dict[int, str] = {}
    for sides in (own for own in seams if own):
        texts = longer_texts([float(own.along[-1]) for own in sides], units)
        notes |= {id(own.side): text for own, text in zip(sides, texts, strict=True) if text}
    return notes


def closed_cuts(laid: Laid) -> list[Line]:
    lines = [Line("cut", points, closed=True) for points in laid.cut.outer]
    return lines + [Line("inner_cut", points, closed=True) for points in laid.cut.holes]


def lines_of(
    laid: Laid, seam_names: Sequence[str], joined: Mapping[int, list[str]], notes: Mapping[int, str]
) -> list[Line]:
    """joined: see joined_by; notes: see notes_on_sides."""
    lines = closed_cuts(laid)
    for own in laid.outlines:
        lines += [Line("inner_cut", slit) for slit in own.slits]
        for run in own.runs:
            seam = run.side.seam
            is_whole = len(own.runs) == 1 and run.side.is_closed
            points = run.points[:-1] if is_whole else run.points
            if run.is_fold:
                lines.append(Line("fold", points))
            else:
                name = "" if seam is None else seam_names[seam]
                others = [] if seam is None else [other for other in joined[seam] if other != laid.name]
                joins = " – ".join(dict.fromkeys(others))
                note = notes.get(id(run.side), "")
                lines.append(Line("sew", points, is_whole, name, run.width, seam, joins=joins, note=note))
    return [*lines, *laid.wires]


def grain_line(laid: Laid) -> Line:
    """Where there is most room beside wires."""
    center, _ = innermost_point(laid.sew_loops, [wire.points for wire in laid.wires])
    rays = Rays(laid.sew_loops)
    up, down = (GRAIN * rays.length(center, sign * laid.grain) for sign in (1, -1))
    return Line("grain", center + np.array([-down * laid.grain, up * laid.grain]))


def finished(
    laid: Laid,
    points: Sequence[Point],
    seam_names: Sequence[str],
    joined: Mapping[int, list[str]],
    notes: Mapping[int, str],
    material: str,
) -> PatternPiece:
    """The piece, still without a text. joined: see joined_by; notes: see notes_on_sides."""
    lines = [*lines_of(laid, seam_names, joined, notes), grain_line(laid)]
    area = abs(sum(map(signed_area, laid.sew_loops)))
    on_fold = any(run.is_fold for outline in laid.outlines for run in outline.runs)
    widths = tuple(sorted({run.width for outline in laid.outlines for run in outline.runs if run.width}))
    return PatternPiece(laid.index + 1, laid.name, lines, list(points), [], (1, 0), material, on_fold, area, widths)


def outlined(laid: Laid) -> PatternPiece:
    """Only cutting lines and folds."""
    folds = [Line("fold", run.points) for own in laid.outlines for run in own.runs if run.is_fold]
    return PatternPiece(laid.index + 1, laid.name, closed_cuts(laid) + folds, [], [], on_fold=bool(folds))
