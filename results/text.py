# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes Markdown, and phrases about numbers."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from pathlib import Path

WIDTH = 120  # characters per line of the page


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table. The first column is text, and the other columns are numbers."""
    lines = [header, [":--", *["--:"] * (len(header) - 1)], *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def picture(alternative: str, path: Path) -> str:
    # the link to the file itself enlarges the picture
    return f"[![{alternative}](results/{path.name})](results/{path.name})"


def change(before: float, after: float) -> str:
    """Return a verb and an amount, such as "falls by 62%". Below half a percent, return "does not change"."""
    share = after / before - 1
    if abs(share) < 0.005:
        return "does not change"
    return f"{'falls' if share < 0 else 'rises'} by {100 * abs(share):.0f}%"


def count(number: int, one: str, many: str) -> str:
    words = {0: "no", 1: "one", 2: "two", 3: "three", 4: "four", 5: "five", 6: "six"}
    return f"{words.get(number, str(number))} {one if number == 1 else many}"


def millimeters(meters: float) -> str:
    """Return the length in millimeters with two decimals. Rounding errors become 0."""
    return "0" if meters < 1e-9 else "under 0.01" if meters < 1e-5 else f"{1000 * meters:.2f}"


def differ(meters: float) -> str:
    """Return a phrase about the two sides of a seam, such as "differ by at most 1.20 mm"."""
    if meters < 1e-9:
        return "differ by rounding errors only"
    return "differ by less than 0.01 mm" if meters < 1e-5 else f"differ by at most {millimeters(meters)} mm"


def degrees(radians: float) -> str:
    return f"{180 / math.pi * radians:.1f}°"


def wrap(page: str) -> str:
    """Return the page with wrapped paragraphs. Headings, tables, pictures and lists do not change."""
    blocks = page.split("\n\n")
    return "\n\n".join(
        block
        if block.lstrip().startswith(("#", "|", "[![", "- "))
        else textwrap.fill(block, WIDTH, break_on_hyphens=False)
        for block in blocks
    )
