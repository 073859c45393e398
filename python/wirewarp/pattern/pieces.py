# SPDX-License-Identifier: GPL-3.0-or-later
"""From the outlines of flat pieces to pieces of a pattern: cut lines, sew lines, wires, marks and texts."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .allowance import CutLines, cut_lines
from .interior import innermost_point
from .model import Line, PatternPiece, Point
from .notches import DOUBLE, clips, drill_hole, notch, places_along, turns_little
from .outline import Side
from .rays import Rays
from .seams import SewnSide
from .stretches import Outline

if TYPE_CHECKING:
    from .._wirewarp import Piece

GRAIN = 0.7  # of the way across the piece
SAME_PLACE = 1e-6  # millimeters


@dataclass(frozen=True)
class Laid:
    """A piece whose outlines are cut into stretches, and its cut lines."""

    index: int
    name: str
    loops: list[list[Side]]
    outlines: list[Outline]
    cut: CutLines
    wires: list[Line]

    @property
    def rays(self) -> Rays:
        return Rays([*self.cut.outer, *self.cut.holes])

    @property
    def sew_loops(self) -> list[np.ndarray]:
        return [np.concatenate([side.points[:-1] for side in loop]) for loop in self.loops]


def lay(index: int, name: str, piece: "Piece", loops: list[list[Side]], outlines: list[Outline], scale: float) -> Laid:
    """With the cut lines and the wires inside of the piece."""
    cut = cut_lines([outline.stretches for outline in outlines if outline.stretches])
    return Laid(index, name, loops, outlines, cut, _wires(piece, scale))


def warnings_of(laid: Laid) -> list[str]:
    """What the allowance does to the piece that the maker should know."""
    found = []
    holes = sum(1 for outline in laid.outlines if outline.stretches) - 1
    if len(laid.cut.holes) < holes:
        found.append(
            f'"{laid.name}": the allowance fills {holes - len(laid.cut.holes)} of {holes} holes; they are not cut.'
        )
    if laid.cut.pockets:
        found.append(f'"{laid.name}": the allowance closes a gap in the outline; what it encloses is not cut out.')
    if len(laid.cut.outer) > 1:
        found.append(f'"{laid.name}" is cut as {len(laid.cut.outer)} parts, for it hangs together in single points.')
    return found


def _wires(piece: "Piece", scale: float) -> list[Line]:
    """Those inside; along the outline there is the sew line already."""
    sides = np.concatenate([piece.faces[:, [0, 1]], piece.faces[:, [1, 2]], piece.faces[:, [2, 0]]])
    ends = {}
    for a, b in sides.tolist():
        key = (int(piece.source_vertex[a]), int(piece.source_vertex[b]))
        ends[key], ends[key[::-1]] = (a, b), (b, a)
    lines = []
    for wire in piece.wires:
        if wire.kind != "boundary":
            pairs = list(zip(wire.vertices[:-1].tolist(), wire.vertices[1:].tolist(), strict=True))
            points = piece.vertices[[ends[pairs[0]][0], *(ends[pair][1] for pair in pairs)]] * scale
            lines.append(Line("wire", points, name=wire.name, kind=wire.kind))
    return lines


def marks(laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]], spacing: float) -> dict[int, list[Point]]:
    """By piece: notches in pairs along seams, at the ends of wires and of seams that nothing shows; clips; holes."""
    rays = {piece.index: piece.rays for piece in laid}
    names = {piece.index: piece.name for piece in laid}
    closed = {id(side) for piece in laid for outline in piece.outlines for dart in outline.darts
              for side in (dart.first, dart.second)}  # fmt: skip
    found: dict[int, list[Point]] = {piece.index: [] for piece in laid}
    at_wires = {piece.index: _wire_ends(piece) for piece in laid}
    runs = [run for piece in laid for outline in piece.outlines for run in outline.runs]
    widths: dict[int, float] = {}
    for run in runs:
        widths[id(run.side)] = max(widths.get(id(run.side), 0.0), run.width or 0.0)
    for number, sides in enumerate(seams):
        if not sides or any(id(own.side) in closed for own in sides):
            continue
        at_back = any(re.search(r"\bback\b", names[own.side.piece], re.IGNORECASE) for own in sides)
        taken = sorted({place for own in sides for place in _places_of(own, at_wires[own.side.piece])})
        length = float(sides[0].along[-1])
        inner = [place for place in taken if SAME_PLACE < place < length - SAME_PLACE]
        places = sorted([*inner, *places_along(length, inner, spacing)])
        if at_back:  # two beside each other
            places = [place + aside for place in places for aside in (-DOUBLE / 2, DOUBLE / 2)]
            places = [place for place in places if 0 < place < length]
        for own in sides:
            share = own.along[-1] / length  # of a side that is eased, notches stand at equal shares
            for order, place in enumerate(places):
                index = own.side.piece
                cut = notch(own, place * share, rays[index], widths[id(own.side)], (number, order))
                found[index] += [cut] if cut else []
    for piece in laid:
        for outline, loop in zip(piece.outlines, piece.loops, strict=True):
            found[piece.index] += _free_notches(loop, at_wires[piece.index], rays[piece.index], widths)
            found[piece.index] += [drill_hole(dart) for dart in outline.darts]
            if outline.stretches and not outline.darts:
                found[piece.index] += clips(loop, rays[piece.index])
    return found


def _wire_ends(piece: Laid) -> np.ndarray:
    """(w,2)"""
    return np.array([end for wire in piece.wires for end in (wire.points[0], wire.points[-1])]).reshape(-1, 2)


def _places_of(own: SewnSide, ends: np.ndarray) -> list[float]:
    """Lengths from the start of the side at which wires end on it."""
    near = np.abs(own.points[:, None] - ends[None]).max(axis=2, initial=0) < SAME_PLACE
    return own.along[near.any(axis=1)].round(6).tolist() if len(ends) else []


def _free_notches(loop: Sequence[Side], ends: np.ndarray, rays: Rays, widths: Mapping[int, float]) -> list[Point]:
    """Where wires end on an outline that is not sewn, and where a seam ends and the outline runs on smoothly."""
    found = []
    for number, side in enumerate(loop):
        forward, length, width = SewnSide(side, True), float(side.along[-1]), widths[id(side)]
        if len(loop) > 1 and turns_little(side, loop[(number + 1) % len(loop)]):
            found.append(notch(forward, length, rays, width))
        if side.seam is None:
            places = [place for place in _places_of(forward, ends) if SAME_PLACE < place < length - SAME_PLACE]
            found += [notch(forward, place, rays, width) for place in places]
    return [point for point in found if point]


def lines_of(laid: Laid) -> list[Line]:
    lines = [Line("cut", points, closed=True) for points in laid.cut.outer]
    lines += [Line("inner_cut", points, closed=True) for points in laid.cut.holes]
    for outline in laid.outlines:
        lines += [Line("inner_cut", slit) for slit in outline.slits]
        for run in outline.runs:
            seam = run.side.seam
            is_whole = len(outline.runs) == 1 and run.side.is_closed
            points = run.points[:-1] if is_whole else run.points
            lines.append(Line("sew", points, is_whole, "" if seam is None else f"Seam {seam + 1}", run.width, seam))
    return [*lines, *laid.wires]


def grain_line(laid: Laid) -> Line:
    """Upright, where there is most room beside wires."""
    center, _ = innermost_point(laid.sew_loops, [wire.points for wire in laid.wires])
    rays = Rays(laid.sew_loops)
    up, down = (GRAIN * rays.to_cut(center, np.array([0.0, sign])) for sign in (1, -1))
    return Line("grain", center + np.array([[0.0, -down], [0.0, up]]))


def finished(laid: Laid, points: Sequence[Point], material: str) -> PatternPiece:
    """The piece, still without a text."""
    return PatternPiece(
        laid.index + 1, laid.name, [*lines_of(laid), grain_line(laid)], list(points), [], material=material
    )
