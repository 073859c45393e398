# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture of a sample: the model with seams and wires beside its flat pieces, at the same scale."""

from __future__ import annotations

import math
from pathlib import Path

import bpy
import numpy as np

from .drawing import Box, Sheet
from .labels import inside_point, seam_labels
from .legend import draw_color_scale, draw_length_scale, draw_line_key
from .measure import chains, cloth_stretch
from .palette import FAINT_INK, INK, INSIDE, MODEL, SEAM, lit, round_limit, stretch_colors
from .surfaces import Flat, Model, read_flat, read_model
from .wire_kinds import by_kind

WIDTH, HEIGHT = 14.0, 7.9
MODEL_BOX = Box(-6.65, -2.0, -0.75, 2.75)  # inches
FLAT_BOX = Box(-1.15, 6.65, -2.7, 3.6)
TABLE_Y, TABLE_STEP, TABLE_TEXT = -1.12, 0.22, 0.165
LEGEND_Y = -3.6
LINE_WIDTH = 0.04


def draw_sample(
    model: bpy.types.Object, flat: bpy.types.Object, view: tuple[float, float], report: dict, path: Path
) -> None:
    """Render the picture.

    model, flat: the model and its flat pieces; view: rotation of the model to the left and its tilt toward the viewer,
    in degrees; report: the object's part of the JSON report.
    """
    sheet = Sheet(WIDTH, HEIGHT)
    body = read_model(model)
    pieces = read_flat(flat)
    turned, normals = body.vertices @ view_matrix(*view).T, body.normals @ view_matrix(*view).T
    scale = min(MODEL_BOX.fit(turned), FLAT_BOX.fit(pieces.vertices))

    draw_model(sheet, body, MODEL_BOX.center(turned, scale) + [0, 0, -10], normals)
    placed = FLAT_BOX.center(pieces.vertices, scale)
    stretch = cloth_stretch(pieces.vertices[:, :2], body.vertices[pieces.source_vertex], pieces.triangles)
    limit = round_limit(stretch)
    draw_pieces(sheet, pieces, placed, stretch_colors(stretch, limit))
    _draw_numbers(sheet, pieces, placed, report)

    sheet.add_text(report["object"], MODEL_BOX.left, 3.3, 0.38, INK)
    if report["seams"]:
        key = "Large numbers: pieces, small numbers: seams, where there is room"
        sheet.add_text(key, MODEL_BOX.left, 3.0, TABLE_TEXT, FAINT_INK)
    _draw_lengths(sheet, report)
    kinds = [kind for kind, _ in by_kind(body.wires, body.tolerances)]
    draw_line_key(sheet, MODEL_BOX.left, LEGEND_Y, LINE_WIDTH, kinds)
    draw_length_scale(sheet, FLAT_BOX.left, LEGEND_Y, scale)
    draw_color_scale(sheet, FLAT_BOX.right - 4.2, FLAT_BOX.right, LEGEND_Y, limit, np.abs(stretch).max())
    sheet.render(path)


def draw_model(sheet: Sheet, body: Model, points: np.ndarray, normals: np.ndarray, marked: float = 1.0) -> None:
    """Draw the surface in soft light with its lines. The inside is darker. marked: drawn share of seams and wires."""
    corners = points[body.triangles]
    away = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] < 0
    colors = lit(normals[body.triangles], MODEL)
    colors[away] = lit(-normals[body.triangles[away]], INSIDE)
    sheet.add_triangles(corners, colors)
    for edges, share in ((body.seams, marked), (body.outline, 1.0)):
        sheet.add_lines(_beginnings(points, edges, share), LINE_WIDTH, SEAM)
    _draw_wires(sheet, body, points, marked)


def draw_pieces(sheet: Sheet, pieces: Flat, points: np.ndarray, colors: np.ndarray) -> None:
    sheet.add_triangles(points[pieces.triangles], colors[pieces.triangles])
    sheet.add_lines([points[chain] for chain in chains(pieces.outline)], LINE_WIDTH, SEAM)
    _draw_wires(sheet, pieces, points)


def _draw_wires(sheet: Sheet, surface: Model | Flat, points: np.ndarray, marked: float = 1.0) -> None:
    for kind, edges in by_kind(surface.wires, surface.tolerances):
        sheet.add_rimmed_lines(_beginnings(points, edges, marked), LINE_WIDTH, kind.color, kind.rim)


def _beginnings(points: np.ndarray, edges: np.ndarray, share: float) -> list[np.ndarray]:
    """Return the points of each line, from its beginning to this share of its vertices."""
    begun = [points[chain[: round(share * len(chain))]] for chain in chains(edges)]
    return [line for line in begun if len(line) > 1]


def _draw_numbers(sheet: Sheet, pieces: Flat, points: np.ndarray, report: dict) -> None:
    """Draw a large number in each piece, and a small number on both sides of each seam. tables.py prints them, too."""
    lines = points[np.unique(np.concatenate([pieces.outline, pieces.wires]))]
    taken = []
    for piece in np.unique(pieces.piece):
        centers = points[pieces.triangles[pieces.piece == piece]].mean(axis=1)
        place, room = inside_point(centers, lines)
        size = float(np.clip(1.8 * room, 0.21, 0.34))
        sheet.add_text(str(piece + 1), place[0], place[1] - 0.36 * size, size, INK, "CENTER")
        taken.append(place)
    for number, place in seam_labels(pieces, points, report["seams"], 0.16, taken):
        sheet.add_text(str(number), place[0], place[1] - 0.055, 0.15, INK, "CENTER")


def _draw_lengths(sheet: Sheet, report: dict) -> None:
    """Draw a table of the wires' lengths on the model and flat, and a sentence on the sides of the seams."""
    columns = (MODEL_BOX.left, MODEL_BOX.left + 3.5, MODEL_BOX.left + 4.65)
    rows = [("Length in mm", "on the model", "flat")]
    for wire in report["wires"]:
        rows.append((wire["name"], *(f"{1000 * m:.2f}" for m in (wire["length_3d_m"], wire["length_2d_m"][0]))))
    for row, cells in enumerate(rows):
        for x, cell, align in zip(columns, cells, ("LEFT", "RIGHT", "RIGHT"), strict=True):
            color = FAINT_INK if row == 0 else INK
            sheet.add_text(cell, x, TABLE_Y - TABLE_STEP * row, TABLE_TEXT, color, align)
    if report["seams"]:
        worst = 1000 * max(seam["mismatch_m"] for seam in report["seams"])
        sides = "Except for ease, the sides" if any(any(seam["eases"]) for seam in report["seams"]) else "The sides"
        text = f"{sides} of every seam differ by less than {max(math.ceil(1e4 * worst), 1) / 1e4:.4f} mm"
        sheet.add_text(text, MODEL_BOX.left, TABLE_Y - TABLE_STEP * len(rows), TABLE_TEXT, FAINT_INK)


def view_matrix(yaw: float, pitch: float) -> np.ndarray:
    """Return the rotation from the model (z up, front toward -y) to the sheet (y up, z toward the viewer)."""
    upright = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    a, b = np.radians([yaw, pitch])
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    tip = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return tip @ upright @ turn
