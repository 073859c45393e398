# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes marks: notches that are sewn onto each other, clips at inward corners, and holes at the tips of darts."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..checks import problem
from ..geometry import Rays, right_normals
from ..model import Point
from .corners import MITRE_LIMIT
from .outline import Side
from .seams import SewnSide, turn_between
from .sections import LEAST_GAP, Dart

DEEPEST = 5.0  # millimeters: largest depth of a notch, half of the usual allowance
SHARE = 0.5  # depth as a share of the allowance; notches never reach the stitching line
ACROSS = 0.3  # depth without allowance, as a share of the distance across the piece, so opposite notches do not meet
# Rays start this far from their own line, in millimeters, so that they miss it. This is also a tolerance of lengths.
NEXT_TO = 2e-3
LEAST_SPACING = 1.0  # millimeters between notches; nobody cuts closer notches
MOST = 10_000  # largest number of notches along one seam: 10 m at the least spacing
CLEAR = 0.2  # share of the spacing; no notch is closer to another notch or to the end of the seam
LEAST_SEAM = 15.0  # millimeters; a shorter seam needs no notch in its middle, only at ends of wires
LOPSIDED = 5.0  # millimeters; in a reversed seam, at least one notch is this far off, so the mistake is noticed
STARTS = (1.0, 0.8, 0.6, 0.4)  # places to try for the first notch of a seam, as multiples of the spacing
DOUBLE = 6.0  # millimeters (about 1/4 in) between the strokes of a double notch, so that both are easy to see
CORNER = math.radians(30)  # radians; nobody can find a corner with a smaller turn on fabric
CLIP_SHORT = 2.0  # millimeters between a clip and the corner of the stitching line, so that the seam is not cut
DRILL_BACK = 13.0  # millimeters (1/2 in) between the hole and the tip of the dart; there, the seam hides the hole
DRILL = 3.0  # millimeters (about 1/8 in): diameter of the hole, through which chalk or a pencil marks the fabric


def check_spacing(spacing: float, seam_names: Sequence[str], sides: Sequence[Sequence[SewnSide]]) -> None:
    """Check the spacing of notches. Raises FlattenError for notches that are too close or too many."""
    if not (spacing == 0 or spacing >= LEAST_SPACING) or spacing == math.inf:
        raise problem(
            f"Notches every {spacing:g} mm cannot be cut: choose {LEAST_SPACING:g} mm or more, or 0 for none."
        )
    for name, own in zip(seam_names, sides, strict=True):
        length = own[0].along[-1] if own else 0.0
        if spacing and length > MOST * spacing:
            raise problem(
                f"{name} is {length / 1000:,.0f} m long, too long for a notch every {spacing:g} mm. Check the "
                "unit of the model, or choose 0 for none."
            )


def places_along(length: float, taken: Sequence[float], spacing: float) -> list[float]:
    """Return the lengths from the start of a seam to further notches.

    These lengths and `taken` (the lengths to other notches) are not symmetric together, so a reversed side does not
    match.
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
        place = min(0.4 * length, (length - LOPSIDED) / 2) if not taken else 0.37 * length
        return [place] if min((abs(place - other) for other in taken), default=length) > 0.05 * length else []
    return []


def symmetric_places(length: float, taken: Sequence[float], spacing: float) -> list[float]:
    """Return lengths as places_along() does, but symmetric, for a seam whose mirror image is the reversed seam. `taken`
    must be symmetric, too."""
    if spacing == 0 or length < LEAST_SEAM:
        return []
    steps = math.floor(length / 2 / spacing)
    found = length / 2 + spacing * np.arange(-steps, steps + 1)
    near = np.abs(found[:, None] - np.array([0.0, length, *taken])).min(axis=1)
    return [float(place) for place in found[near > CLEAR * spacing]]


def _is_lopsided(places: np.ndarray, length: float) -> bool:
    """Return whether some place changes by at least LOPSIDED if the places are measured from the seam's other end."""
    turned = np.sort(length - places)
    return bool(np.abs(np.sort(places) - turned).max() >= LOPSIDED)


def notch(own: SewnSide, length: float, rays: Rays, width: float, pair: tuple[int, int] | None = None) -> Point | None:
    """Return the notch at this length along a side; None if the cutting line is much farther away than the width.

    width: widest allowance of the side, in millimeters. pair: see Point.
    """
    at_sew, outward = own.at(length)
    found = _notch_at(at_sew, outward, rays, width)
    return replace(found, pair=pair, along=length) if found and pair else found


def _notch_at(at_sew: np.ndarray, outward: np.ndarray, rays: Rays, width: float) -> Point | None:
    """Return the notch where the ray from at_sew (2,) in the direction outward (2,) meets the cutting line.

    Return None if this place is much farther than the width, because allowances meet there.
    """
    allowance = rays.length(at_sew, outward)
    if allowance > MITRE_LIMIT * width + NEXT_TO:
        return None
    room = SHARE * allowance if allowance > 0 else ACROSS * rays.length(at_sew - outward * NEXT_TO, -outward)
    return Point("notch", at_sew + allowance * outward, -outward, min(DEEPEST, room))


def leg_notches(dart: Dart, rays: Rays, width: float) -> list[Point]:
    """Return the notches of a closed dart, which meet when the dart is folded. A dart without a gap has one notch.

    width: widest allowance of the outline, in millimeters.
    """
    legs = [dart.first.points, dart.second.points[::-1]]
    if np.linalg.norm(dart.mouth[1] - dart.mouth[0]) <= LEAST_GAP:
        del legs[1]
    extensions = ((leg[0], (leg[0] - leg[1]) / np.linalg.norm(leg[0] - leg[1])) for leg in legs)
    found = (_notch_at(start, outward, rays, width) for start, outward in extensions)
    return [point for point in found if point]


def clips(loop: Sequence[Side], rays: Rays, stitching: Rays) -> list[Point]:
    """Return the clips at inward corners of the stitching line, without which the allowance could not be turned.

    rays: to the cutting lines; stitching: to the stitching lines.
    """
    found = []
    points = np.concatenate([side.points[:-1] for side in loop])
    normals = right_normals(np.concatenate([points[-1:], points, points[:1]]))
    before, after = normals[:-1], normals[1:]
    turns = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1))
    for row in np.flatnonzero((turns < -CORNER) & (turns > -math.pi + CORNER)):
        outward = before[row] + after[row]
        outward /= np.linalg.norm(outward)
        allowance = rays.length(points[row], outward)
        # In a narrow gap, which allowances fill, a clip would reach a stitching line.
        if 2 * CLIP_SHORT < allowance < stitching.length(points[row] + outward * NEXT_TO, outward):
            found.append(Point("clip", points[row] + allowance * outward, -outward, allowance - CLIP_SHORT))
    return found


def drill_hole(dart: Dart) -> Point:
    """Return the drill hole on the middle line of a dart, before its tip."""
    back = dart.mouth.mean(axis=0) - dart.tip
    if dart.first.points.shape[0] > 2:  # if the legs are curved, use their direction at the tip
        back = (dart.first.points[-2] + dart.second.points[1]) / 2 - dart.tip
    length = np.linalg.norm(back)
    depth = float(np.linalg.norm(dart.mouth.mean(axis=0) - dart.tip))
    if length < 1e-9:  # a slit without a gap has its hole along the leg
        back, length = dart.first.points[-2] - dart.tip, np.linalg.norm(dart.first.points[-2] - dart.tip)
        depth = float(dart.first.along[-1])
    return Point("drill", dart.tip + back / length * min(DRILL_BACK, depth / 2), depth=DRILL)


def turns_little(first: Side, second: Side) -> bool:
    """Return whether the corner between two sides is too flat to be found on fabric."""
    return abs(turn_between(first, second)) < CORNER
