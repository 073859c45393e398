# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands on a piece."""

from .pieces import Laid


def card_lines(piece: Laid, count: int, title: str, material: str, allowance: str) -> tuple[str, ...]:
    """Style, number of how many, name, how often to cut it, material, allowance."""
    includes = "No seam allowance" if allowance == "none" else f"Includes {allowance} allowance"
    lines = (title, f"{piece.index + 1} of {count}", piece.name, "Cut 1", material, includes)
    return tuple(line for line in lines if line.strip())
