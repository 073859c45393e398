# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes patterns for tests, and measures them with Shapely, which WireWarp itself does not use."""

from functools import cache
from pathlib import Path

import numpy as np
import pypdfium2
import shapely
import wirewarp
from samples import flattened
from wirewarp.pattern import Line, Pattern, PatternPiece, Text

MILLIMETER = 72 / 25.4  # in points, the unit of PDF
SCALE = 4.0  # pixels per millimeter of measured pages


@cache
def sample(name: str, **options) -> Pattern:
    return Pattern.from_result(flattened(name), title=name, **options)


def quads(points, corners, **options) -> wirewarp.FlattenResult:
    """Flatten planar quads. points: (n,2) millimeters. corners: (q,4) indices of points."""
    vertices = np.column_stack([np.array(points) / 1000, np.zeros(len(points))])
    faces = [triangle for a, b, c, d in corners for triangle in ((a, b, c), (a, c, d))]
    return wirewarp.flatten(vertices, np.array(faces), **options)


def grid(xs, ys, **options) -> wirewarp.FlattenResult:
    """Flatten a grid of quads. xs, ys: coordinates in millimeters. Vertices are numbered row by row along x."""
    row = len(xs)
    first = [row * y + x for y in range(len(ys) - 1) for x in range(row - 1)]
    return quads([(x, y) for y in ys for x in xs], [(a, a + 1, a + row + 1, a + row) for a in first], **options)


def rectangle(width: float, height: float) -> wirewarp.FlattenResult:
    """Return a flattened rectangle without a seam. Its vertices 0 to 3 run counterclockwise from the lower left.

    width, height: millimeters.
    """
    return quads([(0, 0), (width, 0), (width, height), (0, height)], [(0, 1, 2, 3)])


def turn(angle: float) -> np.ndarray:
    """Return the rotation matrix (2,2) for points in rows. angle: degrees counterclockwise."""
    cosine, sine = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    return np.array([[cosine, sine], [-sine, cosine]])


def marks(piece: PatternPiece, *roles: str) -> list:
    """Return the points of a piece that have these roles: notches, clips or drill holes."""
    return [point for point in piece.points if point.role in roles]


def cut_polygon(piece: PatternPiece) -> shapely.Polygon:
    (outer,) = piece.of_role("cut")
    return shapely.Polygon(outer.points, [line.points for line in piece.of_role("inner_cut")])


def sew_polygon(piece: PatternPiece) -> shapely.Polygon:
    """Return the area inside the stitching lines: a polygon whose holes are the inner outlines."""
    rings = shapely.polygonize([line_string(line) for line in piece.of_role("sew")]).geoms
    return max(rings, key=lambda ring: shapely.Polygon(ring.exterior).area)


def line_string(line: Line) -> shapely.LineString:
    return shapely.LineString([*line.points, *line.points[:1]] if line.closed else line.points)


def letters(text: Text) -> shapely.Polygon:
    """Return a rectangle around a text of one line, for letters that are half as wide as high."""
    half = np.array([len(text.lines[0]) / 2, 1.0]) * text.height / 2
    turned = shapely.affinity.rotate(shapely.box(*-half, *half), text.angle, origin=(0, 0))
    return shapely.affinity.translate(turned, *text.center)


def cut_points(pattern: Pattern) -> list[np.ndarray]:
    return [line.points for piece in pattern.pieces for line in piece.of_role("cut", "inner_cut")]


def dark(page: pypdfium2.PdfPage, scale: float = SCALE) -> np.ndarray:
    """Return a mask (h,w) of the pixels with a line, bottom row first."""
    image = page.render(scale=scale / MILLIMETER, grayscale=True).to_numpy()
    return image.reshape(image.shape[:2])[::-1] < 128


def extent(pixels: np.ndarray, scale: float = SCALE) -> tuple[float, float]:
    """Return the millimeters from the first to the last dark pixel, across and upwards."""
    columns, rows = (np.flatnonzero(pixels.any(axis=axis)) for axis in (0, 1))
    return (columns[-1] - columns[0] + 1) / scale, (rows[-1] - rows[0] + 1) / scale


def longest_run(row: np.ndarray) -> int:
    """Return the length of the longest run of true values."""
    changes = np.flatnonzero(np.diff(np.concatenate([[0], row.astype(int), [0]])))
    return max(changes[1::2] - changes[::2], default=0)


def proof_words(pattern: Pattern, path: Path, paper="a0") -> str:
    """Write the pattern with its proof, and return the words on the pages of the proof, with single spaces."""
    pattern.write(path, paper=paper, proof=True)
    pages = list(pypdfium2.PdfDocument(path))
    assert len(pages) == len(pattern.page_sizes(paper, proof=True))
    own = pages[len(pattern.page_sizes(paper)) :]
    return " ".join(" ".join(page.get_textpage().get_text_range() for page in own).split())
