# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes closed models of soft toys, 250 to 300 mm large and symmetric across the plane x = 0.

Coordinates are in millimeters, except for the sample bear, whose coordinates are in meters.
"""

from collections.abc import Callable
from itertools import product

import numpy as np
from mesh_files import Mesh
from shapes import toy

Field = Callable[[np.ndarray], np.ndarray]  # approximate distance of points (..., 3) to the surface, negative inside

COARSE, FINE = 19, 27  # number of cells along each side; odd numbers, so that vertices are on the mirror plane
SMOOTH = ("ball", "egg", "cube", "heart")  # models for which the coarse cells are enough
HALF = 170.0  # mm: half of the side of the cube that the cells fill
ROUNDS = 10  # number of rounds of smoothing
SAME = 1e-6  # share of a cell; diagonals whose lengths differ by less count as equally long
SLOPE_STEP = 1e-4  # share of a cell: step of the difference quotients


def ellipsoid(x: float, y: float, z: float, *radii: float) -> Field:
    """Return an ellipsoid around the point (x, y, z). radii: one radius, or one for each axis."""
    size = np.array(radii if len(radii) == 3 else radii * 3)

    def distance(points: np.ndarray) -> np.ndarray:
        scaled = (points - [x, y, z]) / size
        length = np.linalg.norm(scaled, axis=-1)
        slope = np.linalg.norm(scaled / size, axis=-1)
        return length * (length - 1) / np.maximum(slope, 1e-9)

    return distance


def limb(begin: tuple[float, ...], end: tuple[float, ...], radius: float, end_radius: float | None = None) -> Field:
    """Return a round stick between two points, with round ends."""
    a, b = np.array(begin), np.array(end)

    def distance(points: np.ndarray) -> np.ndarray:
        along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        thickness = radius + along * ((end_radius or radius) - radius)
        return np.linalg.norm(points - a - along[..., None] * (b - a), axis=-1) - thickness

    return distance


def pair(field: Field) -> Field:
    """Return the field together with its mirror image."""
    return lambda points: field(np.abs(points[..., :1]) * [1, 0, 0] + points * [0, 1, 1])


def blend(*fields: Field, width: float = 20) -> Field:
    """Return all fields together, with round transitions."""

    def distance(points: np.ndarray) -> np.ndarray:
        values = np.stack([field(points) for field in fields])
        return -width * np.log(np.exp(-values / width).sum(axis=0))

    return distance


def ring(points: np.ndarray) -> np.ndarray:
    around = np.linalg.norm(points[..., :2], axis=-1) - 105
    return np.hypot(around, points[..., 2]) - 45


def banana(points: np.ndarray) -> np.ndarray:
    bend = np.arctan2(points[..., 0], points[..., 2] + 110)
    radius = np.hypot(points[..., 0], points[..., 2] + 110) - 160
    beyond = np.maximum(np.abs(bend) - 0.85, 0) * 160
    return np.sqrt(radius**2 + points[..., 1] ** 2 + beyond**2) - 38 * (
        1 - 0.25 * (np.minimum(np.abs(bend), 0.85) / 0.85) ** 2
    )


def cube(points: np.ndarray) -> np.ndarray:
    outside = np.abs(points) - 105
    return np.linalg.norm(np.maximum(outside, 0), axis=-1) + np.minimum(outside.max(axis=-1), 0) - 45


def star(points: np.ndarray) -> np.ndarray:
    angle = np.arctan2(points[..., 0], points[..., 2])
    reach = 105 + 42 * np.cos(5 * angle)
    flat = np.hypot(points[..., 0], points[..., 2]) / reach
    return (np.sqrt(flat**2 + (points[..., 1] / 62) ** 2) - 1) * 50


def heart(points: np.ndarray) -> np.ndarray:
    x, y, z = np.moveaxis(points / 120, -1, 0)
    curve = z - 0.75 * np.sqrt(np.abs(x) ** 2 + 0.02) + 0.18
    return (np.sqrt(x**2 + 1.1 * curve**2 + (y / 0.62) ** 2) - 1) * 80


def fields() -> dict[str, Field]:
    return {
        "ball": ellipsoid(0, 0, 0, 150),
        "egg": ellipsoid(0, 0, 0, 105, 105, 150),
        "ring": ring,
        "banana": banana,
        "cube": cube,
        "star": star,
        "heart": heart,
        "mushroom": blend(ellipsoid(0, 0, 60, 140, 140, 70), limb((0, 0, -105), (0, 0, 30), 50, 40), width=8),
        "fish": blend(
            ellipsoid(0, -25, 0, 50, 105, 80),
            ellipsoid(0, 110, 20, 20, 42, 58),
            ellipsoid(0, -10, 75, 18, 45, 42),
            pair(ellipsoid(55, -40, -20, 40, 28, 18)),
            width=6,
        ),
        "whale": blend(
            ellipsoid(0, -40, 0, 85, 110, 75),
            limb((0, 40, -10), (0, 115, 25), 42, 24),
            pair(ellipsoid(42, 125, 32, 50, 28, 18)),
            pair(ellipsoid(90, -35, -35, 50, 30, 18)),
            width=6,
        ),
        "rabbit": blend(
            ellipsoid(0, 0, -75, 70, 62, 75),
            ellipsoid(0, -8, 30, 58, 52, 50),
            pair(ellipsoid(30, 0, 100, 22, 18, 56)),
            pair(limb((45, -25, -45), (95, -50, -60), 24, 22)),
            pair(limb((42, -30, -108), (58, -105, -120), 28)),
            ellipsoid(0, 66, -105, 26),
            width=4,
        ),
    }


def toys() -> dict[str, Mesh]:
    shape = toy()
    models = {name: closed_mesh(field, COARSE if name in SMOOTH else FINE) for name, field in fields().items()}
    return models | {"bear": (shape.vertices, shape.triangles())}


def closed_mesh(field: Field, cells: int) -> Mesh:
    """Return the surface of a field by surface nets: a vertex for each cell that the surface passes through.

    The vertices are then spaced evenly.
    """
    at = np.linspace(-HALF, HALF, cells + 1)
    size = at[1] - at[0]
    values = field(np.stack(np.meshgrid(at, at, at, indexing="ij"), axis=-1))
    places: dict[tuple[int, ...], int] = {}
    vertices: list[np.ndarray] = []
    quads: list[list[int]] = []

    def vertex(cell: tuple[int, ...]) -> int:
        if cell not in places:
            places[cell] = len(vertices)
            vertices.append(crossing(values, cell) * size - HALF)
        return places[cell]

    inside = values < 0
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        ends = np.moveaxis(inside, axis, 0)
        for first in np.argwhere(np.moveaxis(ends[:-1] != ends[1:], 0, axis)).tolist():
            around = []
            for du, dv in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
                cell = list(first)
                cell[u] += du
                cell[v] += dv
                around.append(vertex(tuple(cell)))
            quads.append(around if inside[tuple(first)] else around[::-1])
    images = np.array([places[cells - 1 - i, j, k] for i, j, k in places])
    points = even(np.array(vertices), np.array(quads), images, field, size)
    return points, in_triangles(points, np.array(quads), size)


def crossing(values: np.ndarray, cell: tuple[int, ...]) -> np.ndarray:
    """Return the mean of the points at which the surface crosses the cell's edges, in units of a cell."""
    crossings = []
    for axis, others in product(range(3), product((0, 1), repeat=2)):
        begin = np.array(cell)
        begin[[(axis + 1) % 3, (axis + 2) % 3]] += others
        end = begin.copy()
        end[axis] += 1
        a, b = values[tuple(begin)], values[tuple(end)]
        if (a < 0) != (b < 0):
            crossings.append(begin + (end - begin) * (a / (a - b)))
    return np.mean(crossings, axis=0)


def even(points: np.ndarray, quads: np.ndarray, images: np.ndarray, field: Field, size: float) -> np.ndarray:
    """Return the points after they are moved to the mean of their neighbors and back to the surface, ROUNDS times.

    images: index of the mirror image of each vertex.
    """
    edges = np.unique(np.sort(np.concatenate([quads[:, [i, i - 1]] for i in range(4)]), axis=1), axis=0)
    count = np.bincount(edges.ravel(), minlength=len(points))
    for _ in range(ROUNDS):
        sums = np.zeros_like(points)
        np.add.at(sums, edges[:, 0], points[edges[:, 1]])
        np.add.at(sums, edges[:, 1], points[edges[:, 0]])
        points = onto(sums / count[:, None], field, size)
        points = (points + points[images] * [-1, 1, 1]) / 2
    return points


def onto(points: np.ndarray, field: Field, size: float) -> np.ndarray:
    """Return the points after they are moved to the surface by Newton's method."""
    for _ in range(3):
        steps = SLOPE_STEP * size * np.eye(3)
        slope = np.stack([(field(points + s) - field(points - s)) / (2 * SLOPE_STEP * size) for s in steps], axis=-1)
        points = points - (field(points) / (slope**2).sum(axis=-1))[:, None] * slope
    return points


def in_triangles(points: np.ndarray, quads: np.ndarray, size: float) -> np.ndarray:
    """Return triangles: quads divided along their shorter diagonals, so that mirror images are divided alike."""

    def order(a: int, b: int) -> tuple:
        ends = np.round(points[[a, b]] * [np.sign(points[a, 0] + points[b, 0]) or 1, 1, 1] / size / SAME)
        length = np.linalg.norm(points[a] - points[b])
        return round(length / size / SAME), sorted(map(tuple, np.abs(ends).tolist()))

    faces = []
    for a, b, c, d in quads.tolist():
        faces += [(a, b, c), (a, c, d)] if order(a, c) <= order(b, d) else [(b, c, d), (b, d, a)]
    return np.array(faces)
