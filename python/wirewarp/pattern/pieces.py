# SPDX-License-Identifier: GPL-3.0-or-later
"""From the outlines of flat pieces to pieces of a pattern: cut lines, sew lines, wires, marks and texts."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .allowance import CutLines, cut_lines
from .interior import innermost_point
from .model import Line, PatternPiece, Point
from .outline import Side
from .rays import Rays
from .stretches import Outline

if TYPE_CHECKING:
    from .._wirewarp import Piece

GRAIN = 0.7  # of the way across the piece


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
