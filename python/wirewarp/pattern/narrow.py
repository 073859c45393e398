# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrowest width of flat pieces, which decides whether they can be sewn with an allowance."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
import pyclipper
from numpy.typing import ArrayLike

from .geometry import RESOLUTION, signed_area

if TYPE_CHECKING:
    from .._wirewarp import Piece

SCRAP = 0.1  # of the area: smaller parts may be lost
MOST = 0.5  # least share of the area that disks must cover; they never reach into corners
STEPS, HALVINGS = 24, 10  # of the search: each step can find a waist nearly as wide as the part behind it
ARC, ROUGH_ARC = 1e-3, 0.03  # errors of round corners as shares of the radius, for widths and for areas

Polygon = list[list[int]]


def narrowest_width(outlines: Sequence[np.ndarray]) -> float:
    """Return the diameter of the largest disk that can move through a shape, given by its outlines (k,2).

    This is twice the largest inward offset at which the shape is still one part and disks of this radius cover at least
    half of its area. Parts in which the disks cover less than a tenth of the area do not count. Holes run in the
    opposite direction to the outer outline. Lengths may have any unit.
    """
    points = np.concatenate(outlines)
    low = points.min(axis=0)
    step = 4 * float((points.max(axis=0) - low).max()) / RESOLUTION  # offsets stay within Clipper's fast integers
    area = abs(sum(signed_area(outline) for outline in outlines)) / step**2
    if area == 0:
        return 0.0
    paths = [np.rint((outline - low) / step).astype(np.int64).tolist() for outline in outlines]
    largest = float(np.sqrt(area / np.pi))  # the radius of a disk with this area
    whole, broken = 0.0, largest
    for number in range(1, STEPS + 1):
        radius = largest * number / STEPS
        if not _is_whole(paths, radius, area):
            broken = radius
            break
        whole = radius
    for _ in range(HALVINGS):
        radius = (whole + broken) / 2
        if _is_whole(paths, radius, area):
            whole = radius
        else:
            broken = radius
    return 2 * whole * step


def _is_whole(paths: Sequence[Polygon], radius: float, area: float) -> bool:
    """Return whether the area that disks of this radius cover is one part, and the parts of the shape that count."""
    left = _parts(_offset(paths, -radius, ARC))
    if len(left) == 1 and _area(left[0]) >= MOST * area:
        return True
    parts = [_area(_offset(part, radius, ROUGH_ARC)) for part in left]
    kept = [part for part in parts if part >= SCRAP * area]
    return len(kept) == 1 and kept[0] >= MOST * area


def _offset(paths: Sequence[Polygon], distance: float, arc: float) -> list[Polygon]:
    if not paths:
        return []
    offset = pyclipper.PyclipperOffset(2.0, arc * abs(distance))
    offset.AddPaths(paths, pyclipper.JT_ROUND, pyclipper.ET_CLOSEDPOLYGON)
    moved: list[Polygon] = offset.Execute(distance)
    return moved


def _parts(paths: list[Polygon]) -> list[list[Polygon]]:
    """Return each outer outline with its holes."""
    outer = [path for path in paths if pyclipper.Orientation(path)]
    parts = [[path] for path in outer]
    for hole in (path for path in paths if not pyclipper.Orientation(path)):
        around = [part for part in parts if pyclipper.PointInPolygon(hole[0], part[0])]
        min(around, key=lambda part: _area(part[:1])).append(hole)
    return parts


def _area(paths: Sequence[Polygon]) -> float:
    return sum(pyclipper.Area(path) for path in paths)


def piece_width(piece: "Piece") -> float:
    """Return the narrowest width of a piece with a flat shape, in scene units: see narrowest_width()."""
    return narrowest_width(_outlines(piece))


def pieces_along(pieces: Iterable["Piece"], edges: ArrayLike) -> list["Piece"]:
    """Return the pieces with a flat shape that contain any of these edges (k,2) of the model, also on their outline."""
    wanted = np.sort(np.reshape(edges, (-1, 2)), axis=1).astype(np.int64)
    found = []
    for piece in (piece for piece in pieces if not piece.error):
        sides = np.sort(piece.source_vertex[piece_sides(piece)], axis=1).astype(np.int64)
        keys = [1 + max(sides.max(initial=0), wanted.max(initial=0)), 1]
        if np.isin(sides @ keys, wanted @ keys).any():
            found.append(piece)
    return found


def piece_sides(piece: "Piece") -> np.ndarray:
    """Return the sides (3f,2) of the faces, as vertices of the piece in the direction of each face."""
    return piece.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).astype(np.int64)


def outline_sides(piece: "Piece") -> np.ndarray:
    """Return the sides (b,2) with one face, in its direction."""
    sides, count = piece_sides(piece), len(piece.vertices)
    return sides[~np.isin(sides @ [count, 1], sides @ [1, count])]


def _outlines(piece: "Piece") -> list[np.ndarray]:
    following = dict(outline_sides(piece).tolist())
    loops = []
    while following:
        first, at = following.popitem()
        loop = [first]
        while at != first:
            loop.append(at)
            at = following.pop(at)
        loops.append(piece.vertices[loop])
    return loops
