# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattenings for tests of patterns. Shapely, which is not used to make patterns, measures them."""

from functools import cache

import numpy as np
import pypdfium2
import shapely
import wirewarp
from samples import flattened
from wirewarp.pattern import Line, Pattern, PatternPiece

MILLIMETER = 72 / 25.4  # PDF's points in it
SCALE = 4.0  # pixels per millimeter of measured pages


@cache
def sample(name: str, **options) -> Pattern:
    return Pattern.from_result(flattened(name), title=name, **options)


def quads(points, corners, **options) -> wirewarp.FlattenResult:
    """Return the flattening of quads (q,4) between points (n,2) in millimeters, which are planar already."""
    vertices = np.column_stack([np.array(points) / 1000, np.zeros(len(points))])
    faces = [triangle for a, b, c, d in corners for triangle in ((a, b, c), (a, c, d))]
    return wirewarp.flatten(vertices, np.array(faces), **options)


def rectangle(width: float, height: float) -> wirewarp.FlattenResult:
    """Return a rectangle in millimeters without a seam. Its vertices 0 to 3 run counterclockwise from the lower
    left.
    """
    return quads([(0, 0), (width, 0), (width, height), (0, height)], [(0, 1, 2, 3)])


def turn(angle: float) -> np.ndarray:
    """Return (2,2) for rows of points. angle: degrees counterclockwise."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    return np.array([[cosine, sine], [-sine, cosine]])


def cut_polygon(piece: PatternPiece) -> shapely.Polygon:
    (outer,) = piece.of_role("cut")
    return shapely.Polygon(outer.points, [line.points for line in piece.of_role("inner_cut")])


def sew_polygon(piece: PatternPiece) -> shapely.Polygon:
    """Return the flattened outlines from the stitching lines: the largest one, with the others as holes."""
    rings = shapely.polygonize([line_string(line) for line in piece.of_role("sew")]).geoms
    return max(rings, key=lambda ring: shapely.Polygon(ring.exterior).area)


def line_string(line: Line) -> shapely.LineString:
    return shapely.LineString([*line.points, *line.points[:1]] if line.closed else line.points)


def cut_points(pattern: Pattern) -> list[np.ndarray]:
    return [line.points for piece in pattern.pieces for line in piece.of_role("cut", "inner_cut")]


def dark(page: pypdfium2.PdfPage, scale: float = SCALE) -> np.ndarray:
    """Return (h,w) bool, bottom row first: where there is a line."""
    image = page.render(scale=scale / MILLIMETER, grayscale=True).to_numpy()
    return image.reshape(image.shape[:2])[::-1] < 128


def extent(pixels: np.ndarray, scale: float = SCALE) -> tuple[float, float]:
    """Return the millimeters from the first to the last dark pixel, across and upwards."""
    columns, rows = (np.flatnonzero(pixels.any(axis=axis)) for axis in (0, 1))
    return (columns[-1] - columns[0] + 1) / scale, (rows[-1] - rows[0] + 1) / scale
