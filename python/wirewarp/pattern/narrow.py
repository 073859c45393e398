# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the narrowest width of flat pieces. The width shows whether a piece has room for its allowances."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np
import pyclipper
from numpy.typing import ArrayLike

from .geometry import RESOLUTION, signed_area

if TYPE_CHECKING:
    from .._wirewarp import Piece

SCRAP = 0.1  # share of the area; parts below it, such as the tip of a tail, do not count
MOST = 0.5  # least share of the area that disks must cover; far below 1, because disks never fill corners
# Disks of STEPS radii are tried, up to the radius of a disk with equal area. Then the interval between two radii is
# halved HALVINGS times. As shares of the largest radius:
#
# - A waist is found if it is narrower than its surroundings by 1/24.
# - The error after ten halvings is 1/24,000, less than a thread in a piece a meter wide.
STEPS, HALVINGS = 24, 10
ARC, ROUGH_ARC = 1e-3, 0.03  # errors of round corners as shares of the radius: for widths, and for areas

Polygon = list[list[int]]


def narrowest_width(outlines: Sequence[np.ndarray], most: float = np.inf) -> float:
    """Return the diameter of the largest disk that can move through a shape, in the unit of its outlines.

    The disk must reach half of the area. Parts in which it covers less than a tenth of the area do not count.

    - outlines (k,2): outlines of the shape; holes run in the opposite direction to the outer outline
    - most: a result of at least `most` may be too small, because the search ends there
    """
    points = np.concatenate(outlines)
    low = points.min(axis=0)
    step = 4 * float((points.max(axis=0) - low).max()) / RESOLUTION  # offsets stay within Clipper's fast integers
    area = abs(sum(signed_area(outline) for outline in outlines)) / step**2
    if area == 0:
        return 0.0
    paths = [np.rint((outline - low) / step).astype(np.int64).tolist() for outline in outlines]
    largest = float(np.sqrt(area / np.pi))  # the radius of a disk with the area of the shape
    whole, broken = 0.0, largest
    for number in range(1, STEPS + 1):
        if 2 * whole * step >= most:
            return 2 * whole * step
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


def has_room(piece: "Piece", allowance: float, sides: ArrayLike = (), widths: ArrayLike = ()) -> bool:
    """Return whether a flat piece stays in one part after its allowances are removed inside its outline.

    Parts below a tenth of the area do not count. Widths are in units of the model.

    - allowance: width at all sides without their own width
    - sides (k,2): sides with their own widths, as pairs of vertices of the model in the direction of the face
    - widths (k,): widths at these sides
    """
    return outline_has_room(piece.vertices, piece.source_vertex, outline_sides(piece), allowance, sides, widths)


def outline_has_room(
    vertices: np.ndarray,
    source_vertex: np.ndarray,
    outline: np.ndarray,
    allowance: float,
    sides: ArrayLike,
    widths: ArrayLike,
) -> bool:
    """Return the result of has_room() for a shape.

    vertices (p,2): places of the vertices; source_vertex (p,): vertices of the model; outline (b,2): outline sides.
    """
    count = 1 + int(max(source_vertex.max(), np.max(sides, initial=0)))
    given = dict(zip((np.reshape(sides, (-1, 2)) @ [count, 1]).tolist(), np.ravel(widths).tolist(), strict=True))
    keys = source_vertex[outline].astype(np.int64) @ [count, 1]
    strips = np.array([given.get(key, allowance) for key in keys.tolist()])
    loops = closed_lines(vertices, outline)
    narrowest = narrowest_width(loops, 2 * float(strips.max()))
    if narrowest >= 2 * strips.max():
        return True
    return narrowest >= 2 * strips.min() and _is_whole_without(loops, vertices[outline], strips)


def _is_whole_without(outlines: Sequence[np.ndarray], sides: np.ndarray, widths: np.ndarray) -> bool:
    """Return whether a shape stays one part after strips of these widths (k,) along the sides (k,2,2) are removed."""
    points = np.concatenate(outlines)
    low = points.min(axis=0)
    size = float((points.max(axis=0) - low).max())
    step = 4 * size / RESOLUTION
    paths = [np.rint((outline - low) / step).astype(np.int64).tolist() for outline in outlines]
    lines = np.rint((sides - low) / step).astype(np.int64)
    reach = np.minimum(widths, size) / step  # a strip as wide as the shape covers the whole shape
    clipper = pyclipper.Pyclipper()
    clipper.AddPaths(paths, pyclipper.PT_SUBJECT, True)
    for width in np.unique(reach[reach > 0]).tolist():
        around = pyclipper.PyclipperOffset(2.0, ROUGH_ARC * width)
        around.AddPaths(lines[reach == width].tolist(), pyclipper.JT_ROUND, pyclipper.ET_OPENROUND)
        clipper.AddPaths(around.Execute(width), pyclipper.PT_CLIP, True)
    rule = pyclipper.PFT_NONZERO
    left = _parts(clipper.Execute(pyclipper.CT_DIFFERENCE, rule, rule))
    parts = [_area(_offset(part, reach.max(), ROUGH_ARC)) for part in left]
    return sum(part >= SCRAP * _area(paths) for part in parts) == 1


def _is_whole(paths: Sequence[Polygon], radius: float, area: float) -> bool:
    """Return whether disks of this radius cover only one part, and at least the share MOST of the area.

    Parts below the share SCRAP do not count. paths: outlines on Clipper's grid, with this area.
    """
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
    """Return the parts of a shape, each as its outer outline followed by its holes."""
    outer = [path for path in paths if pyclipper.Orientation(path)]
    parts = [[path] for path in outer]
    for hole in (path for path in paths if not pyclipper.Orientation(path)):
        around = [part for part in parts if pyclipper.PointInPolygon(hole[0], part[0])]
        min(around, key=lambda part: _area(part[:1])).append(hole)
    return parts


def _area(paths: Sequence[Polygon]) -> float:
    return sum(pyclipper.Area(path) for path in paths)


def piece_width(piece: "Piece") -> float:
    """Return the narrowest width of a flat piece in units of the model, as narrowest_width() defines it."""
    return narrowest_width(closed_lines(piece.vertices, outline_sides(piece)))


def pieces_along(pieces: Iterable["Piece"], edges: ArrayLike) -> list["Piece"]:
    """Return the pieces that contain any of these edges (k,2) of the model, inside or on their outlines."""
    wanted = np.sort(np.reshape(edges, (-1, 2)), axis=1).astype(np.int64)
    found = []
    for piece in pieces:
        sides = np.sort(piece.source_vertex[piece_sides(piece)], axis=1).astype(np.int64)
        keys = [1 + max(sides.max(initial=0), wanted.max(initial=0)), 1]
        if np.isin(sides @ keys, wanted @ keys).any():
            found.append(piece)
    return found


def piece_sides(piece: "Piece") -> np.ndarray:
    """Return the sides (3f,2) of the faces, as vertices of the piece in the direction of each face."""
    return piece.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).astype(np.int64)


def outline_sides(piece: "Piece") -> np.ndarray:
    """Return the sides (b,2) of the piece that belong to only one face, in the direction of that face."""
    sides, count = piece_sides(piece), len(piece.vertices)
    return sides[~np.isin(sides @ [count, 1], sides @ [1, count])]


def closed_lines(vertices: np.ndarray, outline: np.ndarray) -> list[np.ndarray]:
    """Return the closed outlines (k,2) that the sides form. Outlines may meet at a vertex.

    vertices (p,2): places of the vertices; outline (b,2): the sides as pairs of vertices.
    """
    following: dict[int, list[int]] = {}
    for first, second in outline.tolist():
        following.setdefault(first, []).append(second)
    loops = []
    while following:
        loop = [next(iter(following))]
        while loop[-1] in following:
            at = loop[-1]
            loop.append(following[at].pop())
            if not following[at]:
                del following[at]
        loops.append(vertices[loop[:-1]])
    return loops
