# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes all marks of a pattern: marks that the pieces of a seam share, and marks of single pieces."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..geometry import Rays
from ..model import Point
from ..pattern_data import SeamWalk
from .copies import SeamGroup
from .notches import DOUBLE, clips, drill_hole, leg_notches, notch, places_along, symmetric_places, turns_little
from .outline import Side
from .pieces import Laid
from .seams import SewnLengths, SewnSide

ON_LINE = 1e-6  # millimeters; a wire ends on a side if its end is this close to a point of the side
APART = 0.2  # millimeters; closer places along a seam are the same place, found on two of its sides
BACK = re.compile(r"\bback\b", re.IGNORECASE)


def marks(
    laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]], groups: Sequence[SeamGroup], spacing: float
) -> dict[int, list[Point]]:
    """Return the notches, clips and drill holes of each piece, by its index.

    - groups: the groups of copied_sides()
    - spacing: distance between notches in millimeters
    """
    found: dict[int, list[Point]] = {piece.index: [] for piece in laid}
    rays = {piece.index: piece.rays for piece in laid}
    wire_ends = {piece.index: _wire_ends(piece) for piece in laid}
    at_back = {piece.index for piece in laid if BACK.search(piece.name)}
    widths, closed = _widths(laid), _legs(laid)
    for group in groups:
        for number, places in _places(group, seams, wire_ends, spacing).items():
            sides, is_ring = seams[number], _is_ring(seams[number])
            if any(id(own.side) in closed for own in sides):
                continue
            sewn = SewnLengths.of(sides)
            # Seams of back pieces have double notches.
            if any(own.side.piece in at_back for seam in group.turned for own in seams[seam]):
                doubled = [place + aside for place in places for aside in (-DOUBLE / 2, DOUBLE / 2)]
                places = [place % sewn.whole for place in doubled] if is_ring else doubled
            for order, place in enumerate(place for place in places if 0 <= place < sewn.whole):
                points = [
                    notch(own, sewn.on(own, place), rays[own.side.piece], widths[id(own.side)], (number, order))
                    for own in sides
                ]
                for which, (own, point) in enumerate(zip(sides, points, strict=True)):
                    if point and all(points):  # a notch without a partner could be matched to a wrong notch
                        found[own.side.piece].append(replace(point, side=which))
    for piece in laid:
        found[piece.index] += _own_marks(piece, rays[piece.index], wire_ends[piece.index], widths)
    return found


def _own_marks(piece: Laid, rays: Rays, wire_ends: np.ndarray, widths: Mapping[int, float]) -> list[Point]:
    """Return the marks that the piece shares with no other piece: on open sides, at darts and in corners."""
    found: list[Point] = []
    stitching = Rays([np.concatenate([side.points[:-1] for side in loop]) for loop in piece.loops])
    for outline, loop in zip(piece.outlines, piece.loops, strict=True):
        found += _free_notches(loop, wire_ends, rays, widths)
        found += [drill_hole(dart) for dart in outline.darts]
        if outline.sections:
            widest = max(widths[id(side)] for side in loop)
            for dart in outline.closed_darts:
                found += leg_notches(dart, rays, widest)
        if outline.sections and not outline.darts:
            found += clips(loop, rays, stitching)
    return found


def walks_of(
    laid: Sequence[Laid], names: Sequence[str], seams: Sequence[Sequence[SewnSide]], points: dict[int, list[Point]]
) -> list[SeamWalk]:
    """Return the lengths, allowances and notches of all sides of each seam. points: the result of marks()."""
    return [
        SeamWalk(
            name,
            tuple(laid[own.side.piece].name for own in sides),
            tuple(float(own.along[-1]) for own in sides),
            tuple(laid[own.side.piece].allowances(own.side) for own in sides),
            tuple(_notches_along(points[own.side.piece], seam, which) for which, own in enumerate(sides)),
        )
        for seam, (name, sides) in enumerate(zip(names, seams, strict=True))
    ]


def _notches_along(points: Sequence[Point], seam: int, side: int) -> tuple[float, ...]:
    own = {point.pair[1]: point.along for point in points if point.pair and (point.pair[0], point.side) == (seam, side)}
    return tuple(along for _, along in sorted(own.items()) if along is not None)


def _widths(laid: Sequence[Laid]) -> dict[int, float]:
    """Return the widest allowance of each side, by the id() of the side."""
    widths: dict[int, float] = {}
    for run in (run for piece in laid for outline in piece.outlines for run in outline.runs):
        widths[id(run.side)] = max(widths.get(id(run.side), 0.0), run.width or 0.0)
    return widths


def _legs(laid: Sequence[Laid]) -> set[int]:
    """Return the id() of each leg of the darts that are not cut out. Such legs have no allowance for notches."""
    darts = (dart for piece in laid for outline in piece.outlines for dart in outline.darts)
    return {id(side) for dart in darts for side in (dart.first, dart.second)}


def _places(
    group: SeamGroup, seams: Sequence[Sequence[SewnSide]], wire_ends: Mapping[int, np.ndarray], spacing: float
) -> dict[int, list[float]]:
    """Return the places of notches of each seam of a group, as sewn lengths (see SewnLengths) from the seam's start.

    If all sides are whole outlines and spacing is not 0, one notch is at the start.
    """
    sewn = {seam: SewnLengths.of(seams[seam]) for seam in group.turned if seams[seam]}
    if not sewn:  # true for pieces without a layout
        return {}
    length = next(iter(sewn.values())).whole  # length of the first seam, along which all places are measured
    ends = []
    for seam, own in sewn.items():
        for side in seams[seam]:
            along = own.of_side(side, np.array(_places_of(side, wire_ends[side.side.piece]))) * (length / own.whole)
            ends += (length - along if group.turned[seam] else along).tolist()
    if group.is_symmetric:
        ends += [length - place for place in ends]
    taken: list[float] = []
    for place in sorted(ends):
        if APART < place < length - APART and (not taken or place > taken[-1] + APART):
            taken.append(place)
    # The start can have a notch only if all seams of the group are rings, because other seams have a corner there.
    is_ring = all(_is_ring(seams[seam]) for seam in sewn)
    begin = [0.0] if spacing and is_ring else []
    between = symmetric_places if group.is_symmetric else places_along
    places = np.array(sorted([*begin, *taken, *between(length, taken, spacing)]))
    turned = (length - places) % length if is_ring else length - places
    return {
        seam: sorted(((turned if group.turned[seam] else places) * (own.whole / length)).tolist())
        for seam, own in sewn.items()
    }


def _is_ring(sides: Sequence[SewnSide]) -> bool:
    """Return whether all sides of the seam are whole outlines, so that the seam has no corner where it begins."""
    return all(own.side.is_closed for own in sides)


def _wire_ends(piece: Laid) -> np.ndarray:
    return np.array([end for wire in piece.wires for end in (wire.points[0], wire.points[-1])]).reshape(-1, 2)


def _places_of(own: SewnSide, ends: np.ndarray) -> list[float]:
    """Return the lengths from the start of the side to the wires that end on the side. ends (w,2): ends of wires."""
    near = np.abs(own.points[:, None] - ends[None]).max(axis=2, initial=0) < ON_LINE
    return [float(place) for place in own.along[near.any(axis=1)]] if len(ends) else []


def _free_notches(loop: Sequence[Side], ends: np.ndarray, rays: Rays, widths: Mapping[int, float]) -> list[Point]:
    """Return notches at the ends of wires on sides that are not sewn, and where two sides meet without a visible
    corner."""
    found = []
    for number, side in enumerate(loop):
        forward, length, width = SewnSide(side), float(side.along[-1]), widths[id(side)]
        if len(loop) > 1 and turns_little(side, loop[(number + 1) % len(loop)]):
            found.append(notch(forward, length, rays, width))
        if side.seam is None:
            first = -APART if side.is_closed else APART  # an open side has a corner where it begins
            places = [place for place in _places_of(forward, ends) if first < place < length - APART]
            found += [notch(forward, place, rays, width) for place in places]
    return [point for point in found if point]
