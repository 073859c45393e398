# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a picture of a flattening: the pieces in their places, colored by strain, with wires and piece numbers."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from .. import FlattenResult
from ..pattern.files import replaced_file
from ..pattern.make.outline import FlatPiece, flat_piece
from ..pattern.sheet.drawing import LOOKS, WIRES

LONGEST = 2000  # pixels along the longer side of the pieces, including margins
SMOOTH = 2  # the picture is drawn this much larger and then reduced, for soft edges
MARGIN = 60  # pixels around the pieces
LEAST = 0.01  # the strongest color shows at least this strain, because less strain is invisible on fabric
# The rows are RGB colors, from no strain to the largest strain.
COLORS = np.array([[255, 255, 255], [255, 221, 140], [235, 120, 50], [160, 20, 30]], dtype=float)
LEGEND = 24  # pixels: height of the letters in the legend; numbers of pieces are twice as high
Point = tuple[float, float]


def write_picture(path: Path, result: FlattenResult, millimeters: float) -> bool:
    """Write a PNG file, and return True. If no piece has a layout, write nothing and return False.

    millimeters: length of the model's unit.
    """
    pieces = {number: piece for number, piece in enumerate(result.pieces, start=1) if len(piece.vertices)}
    if not pieces:
        return False
    corners = np.concatenate([piece.vertices for piece in pieces.values()])
    low, size = corners.min(axis=0), np.ptp(corners, axis=0)
    scale = SMOOTH * (LONGEST - 2 * MARGIN) / float(size.max())
    width, height = (scale * size + 2 * SMOOTH * MARGIN).astype(int).tolist()
    foot = SMOOTH * (LEGEND + MARGIN)
    image = Image.new("RGB", (width, height + foot), "white")
    draw = ImageDraw.Draw(image)

    def placed(points: np.ndarray) -> list[Point]:
        x, y = ((points - low) * scale + SMOOTH * MARGIN).T
        return list(zip(x.tolist(), (height - y).tolist(), strict=True))

    strains = [piece.metrics.face_aspect_ratio - 1 for piece in pieces.values()]
    every = np.concatenate(strains)
    most = max(LEAST, float(every[np.isfinite(every)].max(initial=0.0)))
    for (number, piece), own in zip(pieces.items(), strains, strict=True):
        at = placed(piece.vertices)
        for face, color in zip(piece.faces.tolist(), _colors(own / most), strict=True):
            draw.polygon([at[corner] for corner in face], fill=color)
        _draw_lines(draw, flat_piece(piece, "", 1.0), at)
        middle = (piece.vertices.min(axis=0) + piece.vertices.max(axis=0)) / 2
        font = ImageFont.load_default(2 * LEGEND * SMOOTH)
        halo = {"stroke_width": 4 * SMOOTH, "stroke_fill": "white"}
        draw.text(placed(middle[None])[0], str(number), fill="black", font=font, anchor="mm", **halo)
    _draw_legend(draw, (SMOOTH * MARGIN, height), most, 100 / millimeters * scale)
    with replaced_file(path) as unfinished:
        image.resize((width // SMOOTH, (height + foot) // SMOOTH), Image.Resampling.LANCZOS).save(unfinished, "PNG")
    return True


def _colors(shares: np.ndarray) -> list[tuple[int, ...]]:
    steps = np.linspace(0, 1, len(COLORS))
    columns = [np.interp(shares, steps, COLORS[:, column]) for column in range(3)]
    return [tuple(row) for row in np.column_stack(columns).astype(int).tolist()]


def _draw_lines(draw: ImageDraw.ImageDraw, piece: FlatPiece, at: list[Point]) -> None:
    for a, b in piece.outline.tolist():
        draw.line([at[a], at[b]], fill="black", width=3 * SMOOTH)
    for wire in piece.wires:
        color = LOOKS[WIRES[wire.kind]].color
        draw.line([at[vertex] for vertex in wire.vertices.tolist()], fill=color, width=3 * SMOOTH, joint="curve")


def _draw_legend(draw: ImageDraw.ImageDraw, corner: Point, most: float, hundred: float) -> None:
    """Draw the legend. corner: its upper left; most: strain of the strongest color; hundred: 100 mm in pixels."""
    x, y = corner
    long, high = 100 * SMOOTH, LEGEND * SMOOTH
    for column, color in enumerate(_colors(np.linspace(0, 1, long))):
        draw.line([(x + column, y), (x + column, y + high)], fill=color)
    draw.rectangle([x, y, x + long, y + high], outline="black", width=SMOOTH)
    font = ImageFont.load_default(LEGEND * SMOOTH)
    words = f"0 to {100 * most:.1f}% strain"
    draw.text((x + long + high / 2, y + high / 2), words, fill="black", font=font, anchor="lm")
    end = x + long + high + draw.textlength(words, font=font) + high
    draw.line([(end, y + high / 2), (end + hundred, y + high / 2)], fill="black", width=3 * SMOOTH)
    draw.text((end + hundred + high / 2, y + high / 2), "100 mm", fill="black", font=font, anchor="lm")
