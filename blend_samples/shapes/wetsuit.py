# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the upper body of a wetsuit: front, two backs with a zip between them, and two side panels (Fig. 9)."""

from __future__ import annotations

import numpy as np

from . import bodice, torso
from .curves import coons_patch, cubic_spline
from .shape import Shape, ShapeBuilder

NECK_DEPTH = {1: 0.17, -1: 0.05}  # of front (1) and back (-1): depth of bodice.neckline()
# Longitudes of the side panels' seams at hem, waist and bust line. The seams end at the armhole.
SEAM_LONGITUDES = {1: np.radians([57, 55, 59]), -1: np.radians([59, 57, 61])}
TOLERANCE = 0.05


def wetsuit_upper_body(
    shoulder: int = 7, neck: int = 14, hem: int = 12, ribs: int = 11, stub: int = 5, under: int = 5, armhole: int = 13
) -> Shape:
    """Return the suit with rigid bust and waist lines, and elastic lines down front and back and around the ribs.

    The arguments are numbers of edges along the sections. On front and back, an armhole has `under` edges below the
    side panel's seam and `armhole` edges above it.
    """
    builder = ShapeBuilder()
    columns, bust = 2 * shoulder + neck, hem + ribs
    seams = {half: _seam(half, hem, ribs, stub, under, under + armhole) for half in (1, -1)}
    panels = {}
    for half in (1, -1):
        grid = _panel(half, seams[half], bust, stub, under, armhole, shoulder, neck)
        panel = builder.add_grid(torso.Half(half).points(*np.moveaxis(grid, -1, 0)), flip=half < 0)
        for edge in (0, -1):
            builder.add_seam(panel[: bust + stub + 1, edge])
        builder.add_seam(panel[-1, : shoulder + 1])
        builder.add_seam(panel[-1, columns - shoulder :])
        panels[half] = panel
    builder.add_seam(panels[-1][:, columns // 2])
    sides = {}
    for arm in (1, -1):
        front, back = (
            torso.Half(half).points(*np.moveaxis(_side(half, seams[half], bust, stub, under, armhole), -1, 0))
            for half in (1, -1)
        )
        grid = np.concatenate([front, back[:, -2::-1]], axis=1) * [arm, 1, 1]
        sides[arm] = builder.add_grid(grid, flip=arm < 0)

    for row, name, tolerance in (
        (bust, "Bust line", 0.0),
        (hem, "Waist line", 0.0),
        ((hem + bust) // 2, "Rib line", TOLERANCE),
    ):
        around = [panels[1][row], sides[1][row, 1:], panels[-1][row, -2::-1], sides[-1][row, -2::-1]]
        builder.add_wire(np.concatenate(around), name, tolerance)
    builder.add_wire(panels[1][:, columns // 2], "Center front", TOLERANCE)
    for half, place in ((1, "front"), (-1, "back")):
        for column, name in ((columns - shoulder, "Left"), (shoulder, "Right")):
            builder.add_wire(panels[half][:, column], f"{name} {place} line", TOLERANCE)
    return builder.build("Wetsuit upper body", cloth="neoprene")


def _seam(half: int, hem: int, ribs: int, stub: int, under: int, armhole: int) -> np.ndarray:
    """Return longitudes and v (hem + ribs + stub + 1, 2) of the side panel's seam from the hem up to the armhole."""
    end = bodice.evenly(torso.Half(half), bodice.armhole(half), armhole)[under]
    knots = [0.0, torso.v_at_height(torso.WAIST), torso.v_at_height(torso.BUST), end[1]]
    curve = cubic_spline(knots, [*SEAM_LONGITUDES[half], end[0]])
    heights = np.concatenate([np.linspace(0, torso.WAIST, hem + 1), np.linspace(torso.WAIST, torso.BUST, ribs + 1)[1:]])
    v = np.array([torso.v_at_height(z) for z in heights])
    v = np.concatenate([v, np.linspace(v[-1], end[1], stub + 1)[1:]])
    seam = np.stack([curve(v), v], axis=-1)
    seam[-1] = end
    return seam


def _panel(
    half: int, seam: np.ndarray, bust: int, stub: int, under: int, armhole: int, shoulder: int, neck: int
) -> np.ndarray:
    """Return longitudes and v (bust + stub + armhole + 1, c, 2) of the front or back between the side panels."""
    body = torso.Half(half)
    columns = 2 * shoulder + neck
    rows = np.array([bodice.level_row(body, v, -phi, phi, columns) for phi, v in seam[: bust + 1]])
    left = np.concatenate([seam[bust:], bodice.evenly(body, bodice.armhole(half), under + armhole)[under + 1 :]])
    upper = bodice.upper_edge(body, left[-1], NECK_DEPTH[half], shoulder, neck)
    return np.concatenate([rows, bodice.upper_block(rows[-1], left, upper, body, straight=True)[1:]])


def _side(half: int, seam: np.ndarray, bust: int, stub: int, under: int, armhole: int) -> np.ndarray:
    """Return longitudes and v (bust + stub + 1, under + 1, 2) of half a side panel, from its seam to the underarm."""
    body = torso.Half(half)
    rows = np.array([bodice.level_row(body, v, phi, np.pi / 2, under) for phi, v in seam[: bust + 1]])
    top = bodice.evenly(body, bodice.armhole(half), under + armhole)[under::-1]
    middle = np.linspace(rows[-1, -1], top[-1], stub + 1)
    return np.concatenate([rows, coons_patch(rows[-1], top, seam[bust:], middle)[1:]])
