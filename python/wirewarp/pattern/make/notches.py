# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks: notches that are sewn onto each other, clips at inward corners, holes at the tips of darts."""

import math
from collections.abc import Sequence

import numpy as np

from ..checks import problem
from ..geometry import Rays, right_normals
from ..model import Point
from .corners import MITRE_LIMIT
from .outline import Side
from .seams import SewnSide, turn_between
from .sections import Dart

DEEPEST = 5.0  # millimeters
SHARE = 0.5  # of the allowance: notches never reach the stitching line
ACROSS = 0.3  # without allowance, of the way across the piece: two notches that face each other do not meet
NEXT_TO = 2e-3  # millimeters: beside a line, not on it
LEAST_SPACING = 1.0  # millimeters
MOST = 10_000  # along one seam
CLEAR = 0.2  # of the spacing: so close to another notch or to the end of the seam there is none
LEAST_SEAM = 15.0  # millimeters: a shorter one needs no notch in its middle
LOPSIDED = 5.0  # millimeters by which notches of a seam turned end for end must miss each other
STARTS = (1.0, 0.8, 0.6, 0.4)  # of the spacing, from the start of the seam to its first notch
DOUBLE = 6.0  # millimeters between the two of a double notch
CORNER = math.radians(30)  # what turns less is no corner that can be found on cloth
CLIP_SHORT = 2.0  # millimeters that a clip ends before the corner of the stitching line
DRILL_BACK = 13.0  # millimeters before the tip of the dart, where the seam covers it (1/2 in)
DRILL = 3.0  # millimeters: diameter


def check_spacing(spacing: float, seam_names: Sequence[str], sides: Sequence[Sequence[SewnSide]]) -> None:
    """Raises FlattenError where notches stand so close that they cannot be cut."""
    if not (spacing == 0 or spacing >= LEAST_SPACING) or spacing == math.inf:
        raise problem(
            f"Notches every {spacing:g} mm cannot be cut: choose {LEAST_SPACING:g} mm or more, or 0 for none."
        )
    for name, own in zip(seam_names, sides, strict=True):
        length = own[0].along[-1] if own else 0.0
        if spacing and length > MOST * spacing:
            raise problem(
                f"{name} is {length / 1000:,.0f} m long, too long for a notch every {spacing:g} mm: see whether the "
                "unit of the model is right, or choose 0 for none."
            )


def places_along(length: float, taken: Sequence[float], spacing: float) -> list[float]:
    """Lengths from the start of a seam at which its notches stand; with those of `taken` they differ end for end.

    taken: where there are notches already, as at the ends of wires.
    """
    if spacing == 0 or length < LEAST_SEAM:
        return []
    for start in STARTS:
        found = np.arange(start * spacing, length, spacing)
        near = np.abs(found[:, None] - np.array([0.0, length, *taken])).min(axis=1)
        found = found[near > CLEAR * spacing]
        if len(found) and _is_lopsided(np.array([*found, *taken]), length):
            return [float(place) for place in found]
    if not taken or not _is_lopsided(np.array(taken), length):
        place = (0.4 if not taken else 0.37) * length
        return [place] if min((abs(place - other) for other in taken), default=length) > 0.05 * length else []
    return []


def symmetric_places(length: float, taken: Sequence[float], spacing: float) -> list[float]:
    """As places_along, but the same from both ends, as `taken` are: for a seam that a mirror turns end for end."""
    if spacing == 0 or length < LEAST_SEAM:
        return []
    steps = math.floor(length / 2 / spacing)
    found = length / 2 + spacing * np.arange(-steps, steps + 1)
    near = np.abs(found[:, None] - np.array([0.0, length, *taken])).min(axis=1)
    return [float(place) for place in found[near > CLEAR * spacing]]


def _is_lopsided(places: np.ndarray, length: float) -> bool:
    """Whether the same places counted from the other end of the seam are others."""
    turned = np.sort(length - places)
    return bool(np.abs(np.sort(places) - turned).max() >= LOPSIDED)


def notch(own: SewnSide, length: float, rays: Rays, width: float, pair: tuple[int, int] | None = None) -> Point | None:
    """From where the normal of the side, at this length, meets the cut line; inwards, short of the stitching line.

    width: the widest allowance of the side. None where the cut line is much farther, for allowances run together there.
    """
    at_sew, outward = own.at(length)
    allowance = rays.length(at_sew, outward)
    if allowance > MITRE_LIMIT * width + NEXT_TO:
        return None
    room = SHARE * allowance if allowance > 0 else ACROSS * rays.length(at_sew - outward * NEXT_TO, -outward)
    return Point("notch", at_sew + allowance * outward, -outward, min(DEEPEST, room), pair, length if pair else None)


def clips(loop: Sequence[Side], rays: Rays) -> list[Point]:
    """At inward corners of the stitching line: cut to these, or the allowance does not turn."""
    found = []
    points = np.concatenate([side.points[:-1] for side in loop])
    normals = right_normals(np.concatenate([points[-1:], points, points[:1]]))
    before, after = normals[:-1], normals[1:]
    turns = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))
    for row in np.flatnonzero((turns < -CORNER) & (turns > -math.pi + CORNER)):
        outward = before[row] + after[row]
        outward /= np.linalg.norm(outward)
        allowance = rays.length(points[row], outward)
        if allowance > 2 * CLIP_SHORT:
            found.append(Point("clip", points[row] + allowance * outward, -outward, allowance - CLIP_SHORT))
    return found


def drill_hole(dart: Dart) -> Point:
    """On the middle line of a dart, before its tip."""
    back = dart.mouth.mean(axis=0) - dart.tip
    if dart.first.points.shape[0] > 2:  # of curved legs: where they lead from the tip
        back = (dart.first.points[-2] + dart.second.points[1]) / 2 - dart.tip
    length = np.linalg.norm(back)
    depth = float(np.linalg.norm(dart.mouth.mean(axis=0) - dart.tip))
    if length < 1e-9:  # a slit that is closed: along it
        back, length = dart.first.points[-2] - dart.tip, np.linalg.norm(dart.first.points[-2] - dart.tip)
        depth = float(dart.first.along[-1])
    return Point("drill", dart.tip + back / length * min(DRILL_BACK, depth / 2), depth=DRILL)


def turns_little(first: Side, second: Side) -> bool:
    """Whether nothing shows on the cloth where the one ends and the other begins."""
    return abs(turn_between(first, second)) < CORNER
