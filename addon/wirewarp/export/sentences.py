# SPDX-License-Identifier: GPL-3.0-or-later
"""What is said of a pattern before it is written and afterwards."""

import numpy as np

from ..core import SHOWN_NAMES, pattern
from ..words import counted
from .read import pieces_over_others

INCH = 25.4


def crossing_sentence(made: pattern.Pattern) -> str:
    """Empty if no pieces overlap."""
    names = pieces_over_others(made.pieces)
    if not names:
        return ""
    hidden = len(names) - SHOWN_NAMES
    shown = ", ".join(names[:SHOWN_NAMES]) + (f" and {hidden} more" if hidden > 0 else "")
    return f"These pieces overlap: {shown}. Move them apart before you cut."


def copies_sentences(made: pattern.Pattern) -> list[str]:
    """The pieces that are drawn once for their mirror images."""
    pairs = [f"{piece.name} and {piece.mirrored_name}" for piece in made.pieces if piece.mirrored_name]
    folds = [piece.name for piece in made.pieces if piece.on_fold]
    return [f"{what}: {', '.join(names)}" for what, names in (("Cut 1 pair", pairs), ("On the fold", folds)) if names]


def size_sentences(made: pattern.Pattern, size: np.ndarray) -> list[str]:
    return [f"{counted(len(made.pieces), 'piece')} on {_size_text(made, *size)}.", largest_sentence(made)]


def largest_sentence(made: pattern.Pattern) -> str:
    """By the area of its box: what a sheet must have room for."""
    largest = max(made.pieces, key=lambda piece: float(piece.size.prod()))
    return f"Largest piece: {largest.name}, {_size_text(made, *largest.size)}."


def _size_text(made: pattern.Pattern, width: float, height: float) -> str:
    """Of millimeters, in inches too for those who measure in them."""
    inches = f" ({width / INCH:.1f} × {height / INCH:.1f} in)" if made.units.name == "imperial" else ""
    return f"{width:.0f} × {height:.0f} mm{inches}"
