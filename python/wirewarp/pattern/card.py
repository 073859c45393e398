# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands on a piece."""

from dataclasses import replace

import numpy as np

from .interior import place_text
from .model import PatternPiece

TEXT_HEIGHT = 8.0  # millimeters, at most


def with_card(piece: PatternPiece, number: int, count: int, title: str, allowance: str) -> PatternPiece:
    """With its number, and a text inside: style, number of how many, name, how often to cut it, material, allowance."""
    includes = "No seam allowance" if allowance == "none" else f"Includes {allowance} allowance"
    lines = (title, f"{number} of {count}", piece.name, how_to_cut(piece), piece.material, includes)
    inside = [line.points for line in piece.of_role("wire", "grain")]
    outlines = [line.points for line in piece.of_role("cut", "inner_cut")]
    sewn = [np.asarray(line.points) for line in piece.of_role("sew")]
    text = place_text(tuple(line for line in lines if line.strip()), outlines, [*inside, *sewn], TEXT_HEIGHT)
    return replace(piece, number=number, texts=[text])


def how_to_cut(piece: PatternPiece) -> str:
    """As makers say it."""
    as_drawn, mirrored = piece.quantity
    if piece.on_fold:
        return f"Cut {as_drawn} on the fold"
    if mirrored == as_drawn:
        return "Cut 1 pair (2 pieces, one mirrored)" if as_drawn == 1 else f"Cut {as_drawn} pairs"
    return f"Cut {as_drawn}"
