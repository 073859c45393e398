# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a pair of jeans: two fronts, two backs, two back yokes and a waistband (Fig. 6)."""

from __future__ import annotations

import numpy as np

from . import legs
from .curves import chord_lengths
from .shape import Shape, ShapeBuilder

# meters
SIDE_OF_CROTCH = 0.850  # height at the side of the row that ends at the crotch
HIP, THIGH = 0.930, 0.790  # heights of the hip line and the thigh line at the side
CREASE_AT_WAIST = 0.090  # x of the crease at the waist
TOLERANCE = 0.05


def jeans(leg: int = 30, seat: int = 9, yoke: int = 4, band: int = 3, columns: int = 14) -> Shape:
    """Return the jeans with rigid hip and knee lines, elastic thigh lines and elastic creases down front and back.

    leg, seat, yoke, band: numbers of rows of faces, from the hem up; leg ends at the crotch, and band at the waist.
    columns: number of columns of faces of a front or back.
    """
    builder = ShapeBuilder()
    rise = seat + yoke + band
    waist_seam, yoke_seam = leg + seat + yoke, leg + seat
    grids = {}
    heights = _side_heights(leg, rise)
    for side in (1, -1):
        points = legs.Half(side).points(*_panel(side, leg, heights, columns))
        for wearer in (1, -1):
            grid = builder.add_grid(points * [wearer, 1, 1], flip=side * wearer < 0)
            builder.add_seam(grid[: waist_seam + 1, -1])
            builder.add_seam(grid[: waist_seam + 1, 0])
            builder.add_seam(grid[waist_seam])
            if side < 0:
                builder.add_seam(grid[yoke_seam])
            grids[side, wearer] = grid
    builder.relax(_near_the_crotch, 12)
    builder.add_seam(grids[1, 1][waist_seam:, 0])  # the waistband opens in front

    hip, thigh, knee = (int(np.abs(heights - z).argmin()) for z in (HIP, THIGH, legs.KNEE))
    quarters = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    builder.add_wire(_around(grids, quarters, hip), "Hip line")
    for wearer, name in ((1, "Left"), (-1, "Right")):
        builder.add_wire(_around(grids, [(1, wearer), (-1, wearer)], thigh), f"{name} thigh line", TOLERANCE)
        builder.add_wire(_around(grids, [(1, wearer), (-1, wearer)], knee), f"{name} knee line")
    for side, place in ((1, "front"), (-1, "back")):
        for wearer, name in ((1, "Left"), (-1, "Right")):
            crease = grids[side, wearer][: waist_seam + 1, columns // 2]
            builder.add_wire(crease, f"{name} {place} crease", TOLERANCE)
    return builder.build("Jeans", cloth="woven")


def _around(grids: dict[tuple[int, int], np.ndarray], quarters: list[tuple[int, int]], row: int) -> np.ndarray:
    """Return the closed chain along a row: outward in the first quarter, inward in the second, and so on."""
    chains = [grids[quarter][row, :: 1 if k % 2 == 0 else -1] for k, quarter in enumerate(quarters)]
    return np.concatenate([chains[0], *(chain[1:] for chain in chains[1:])])


def _side_heights(leg: int, rise: int) -> np.ndarray:
    """Return the heights of the rows along the outer seam. Below the crotch, rows become denser upward."""
    below = _graded(leg, 0.55)
    above = np.linspace(SIDE_OF_CROTCH, legs.WAIST, rise + 1)
    return np.concatenate([legs.HEM + (SIDE_OF_CROTCH - legs.HEM) * below, above[1:]])


def _graded(count: int, last: float) -> np.ndarray:
    """Return count + 1 numbers from 0 to 1. The last step is `last` times the first step."""
    return np.concatenate([[0], np.cumsum(np.linspace(1, last, count))]) / np.linspace(1, last, count).sum()


def _panel(side: int, leg: int, heights: np.ndarray, columns: int) -> tuple[np.ndarray, np.ndarray]:
    """Return angles and heights (r, columns + 1) of the left front or back, from the inner seams to the side."""
    inner_angle, inner_height = _inner_edge(side, leg, len(heights) - 1 - leg)
    s = np.linspace(0, 1, columns + 1)
    near = (1 - s) ** 3  # the effect of the corner at the crotch fades out quickly
    middle = (3 * heights + inner_height) / 4
    above = np.clip((middle - THIGH) / (legs.WAIST - THIGH), 0, 1)
    crease = np.where(above > 0, legs.center(THIGH) * (1 - above) + CREASE_AT_WAIST * above, legs.center(middle))
    begin = ((legs.angle_at(crease, middle) - np.pi / 2 - inner_angle / 8) * 8 / 3)[:, None]
    angle = begin + (np.pi - begin) * s + (inner_angle[:, None] - begin) * near
    angle[:, -1] = np.pi
    return angle, heights[:, None] + (inner_height - heights)[:, None] * (1 - s) ** 2


def _inner_edge(side: int, leg: int, rise: int) -> tuple[np.ndarray, np.ndarray]:
    """Return angles and heights along the inseam, the crotch and the middle up to the waist."""
    z = legs.CROTCH + (legs.WAIST - legs.CROTCH) * np.linspace(0, 1, 4001) ** 2
    curve = legs.Half(side).points(legs.middle_angle(z), z)
    z = np.interp(_graded(rise, 0.65), chord_lengths(curve), z)
    inseam = legs.HEM + (legs.CROTCH - legs.HEM) * _graded(leg, 0.6)
    heights = np.concatenate([inseam[:-1], z])
    return np.where(heights > legs.CROTCH, legs.middle_angle(heights), 0.0), heights


def _near_the_crotch(points: np.ndarray) -> np.ndarray:
    """Return the share of relaxation of each point, 0 to 1. It is above 0 near the crotch, at which rows converge."""
    distance = np.linalg.norm((points - [0, 0, legs.CROTCH]) / [0.15, 0.20, 0.14], axis=1)
    return np.clip(1.2 - distance, 0, 0.7)
