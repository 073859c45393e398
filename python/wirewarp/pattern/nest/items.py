# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the items to nest. An item is the outline of a piece with room around it, and the number of copies."""

import math
from collections.abc import Generator, Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import pyclipper

from ..geometry import GRID, Motion, signed_area
from ..model import PatternPiece

Grain = Literal["one way", "both ways", "free"]
# Outlines are simplified with at most this error, in millimeters, because searches are faster with fewer points.
NEAR = 0.2
ROUND = 0.01  # millimeters: error of an arc that consists of straight lines; nobody cuts more exactly


@dataclass(frozen=True)
class Item:
    piece: int  # number of the piece
    mirrored: bool
    count: int
    outline: np.ndarray  # (k,2) counterclockwise, already mirrored, with room() around the piece
    upright: float  # degrees counterclockwise by which the piece must turn until its grain is along the fabric
    area: float  # area of one copy, square millimeters

    def turned(self, angle: float) -> np.ndarray:
        return Motion(np.zeros(2), angle).points(self.outline)


def angles(item: Item, grain: Grain, step: float) -> list[float]:
    """Return the allowed turns of the item in degrees. step: degrees between two turns if all turns are allowed."""
    turns = {"one way": [0.0], "both ways": [0.0, 180.0], "free": np.arange(0.0, 360.0, step).tolist()}[grain]
    return [item.upright + turn for turn in turns]


def room(gap: float) -> float:
    """Return the width of the room around each piece in millimeters."""
    return gap / 2 + NEAR


def room_at_edges(gap: float, grain: Grain) -> float:
    """Return by how many millimeters the outlines of items, which include the room, may extend beyond the fabric.

    If pieces turn freely, this is less than room(), because a simplified outline may be up to NEAR inside the true
    outline.
    """
    return room(gap) - (NEAR if grain == "free" else 0.0)


def items_of(pieces: Sequence[PatternPiece], gap: float, times: int) -> Generator[None, None, list[Item]]:
    """Return the items, in steps, one step for each piece. times: number of copies of the whole pattern."""
    found = []
    for piece in pieces:
        yield
        upright = _upright(piece)
        outline = _outline(piece, gap, upright)
        area = sum(abs(signed_area(line.points)) for line in piece.of_role("cut"))
        for mirrored, count in zip((False, True), piece.quantity, strict=True):
            if count:
                points = Motion(np.zeros(2), mirrored=mirrored).points(outline)[:: -1 if mirrored else 1]
                turn = -upright if mirrored else upright
                found.append(Item(piece.number, mirrored, times * count, points, turn, area))
    return found


def _upright(piece: PatternPiece) -> float:
    for line in piece.of_role("grain"):
        along = line.points[1] - line.points[0]
        return 90.0 - math.degrees(math.atan2(along[1], along[0]))
    return 0.0


def _outline(piece: PatternPiece, gap: float, upright: float) -> np.ndarray:
    """Return the simplified outline of the cutting line with room around it. Its width and height are exact if the
    piece is upright. Parts that touch are united."""
    offset = pyclipper.PyclipperOffset(arc_tolerance=ROUND / GRID)
    for line in piece.of_role("cut"):
        path = np.rint(line.points / GRID).astype(np.int64)
        path = path if signed_area(line.points) > 0 else path[::-1]
        offset.AddPath(path.tolist(), pyclipper.JT_ROUND, pyclipper.ET_CLOSEDPOLYGON)
    grown = np.array(max(offset.Execute(room(gap) / GRID), key=pyclipper.Area)) * GRID
    turned = Motion(np.zeros(2), upright).points(grown)
    widest = [*turned.argmin(axis=0).tolist(), *turned.argmax(axis=0).tolist()]
    return simplified(grown, NEAR, widest)


def simplified(outline: np.ndarray, within: float, kept: Iterable[int]) -> np.ndarray:
    """Return the closed outline (k,2) with fewer points, by the algorithm of Douglas and Peucker.

    within: largest error in millimeters. kept: indices of points that must remain, at least two.
    """
    closed = np.concatenate([outline, outline[:1]])
    fixed = sorted({0, *kept})
    found, spans = set(fixed), list(zip(fixed, [*fixed[1:], len(outline)], strict=True))
    while spans:
        first, last = spans.pop()
        along, to = closed[last] - closed[first], closed[first + 1 : last] - closed[first]
        if not len(to):
            continue
        share = np.clip(to @ along / max(float(along @ along), 1e-12), 0.0, 1.0)
        off = np.linalg.norm(to - share[:, None] * along, axis=1)
        if off.max() > within:
            middle = first + 1 + int(off.argmax())
            found.add(middle)
            spans += [(first, middle), (middle, last)]
    return outline[sorted(found)]
