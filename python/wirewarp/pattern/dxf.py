# SPDX-License-Identifier: GPL-3.0-or-later
"""A pattern as DXF: which of its dialects."""

from pathlib import Path
from typing import Literal

from .apparel_dxf import apparel_dxf
from .checks import problem
from .pattern_data import PatternData
from .plain_dxf import plain_dxf
from .progress import Steps


def write_dxf(
    path: Path,
    pattern: PatternData,
    dialect: Literal["astm", "aama", "plain"] = "astm",
    control_square: bool = False,
) -> Steps[tuple[int, list[str]]]:
    """Writes the file; returns 1, and sentences on what could not be kept.

    dialect: "astm" for AccuMark and most apparel CAD, "aama" for CLO and Optitex, "plain" for lasers and drawing
    programs. control_square: of apparel DXF, one more block with a square of 100 mm, whatever unit a reader takes.
    """
    changed: list[str] = []
    if dialect == "plain":
        text = yield from plain_dxf(pattern)
    elif dialect in ("astm", "aama"):
        text, changed = yield from apparel_dxf(pattern, dialect, control_square)
    else:
        raise problem(f"dialect is {dialect!r}: give 'astm', 'aama' or 'plain'.")
    path.write_text(text, encoding="ascii", newline="\r\n")
    return 1, changed
