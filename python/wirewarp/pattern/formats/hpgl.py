# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a pattern as HPGL for plotters, with one pen for each kind of line, and with x along the roll."""

from pathlib import Path

import numpy as np

from ..pattern_data import PatternData
from ..progress import Steps
from ..sheet.drawing import Stroke, strokes_of
from .file_format import Format
from .read_back import read_plt

UNITS = 40  # units of HPGL in a millimeter
AT_ONCE = 100  # largest number of points in a command, because some plotters can store only short commands
CUT_PEN = 1


def write_plt(path: Path, pattern: PatternData) -> Steps[tuple[int, list[str]]]:
    """Write the file in steps, pen by pen, with cutting lines last. Return 1 for one page, and no warnings.

    Texts are left out, because a plotter draws texts in HPGL with its own letters.
    """
    strokes: list[Stroke] = []
    for number, piece in enumerate(pattern.pieces):
        yield "writing", number / len(pattern.pieces)
        strokes += strokes_of(piece.without_texts_beside())
    pens = sorted({stroke.look.pen for stroke in strokes}, key=lambda pen: (pen == CUT_PEN, pen))
    commands = ["IN", "PA"]
    for pen in pens:
        commands.append(f"SP{pen}")
        for stroke in strokes:
            if stroke.look.pen == pen:
                points = np.concatenate([stroke.points, stroke.points[:1]]) if stroke.closed else stroke.points
                commands += _drawn(np.rint(points * UNITS).astype(int))
    commands += ["PU", "SP0"]
    path.write_text(";\n".join(commands) + ";\n", encoding="ascii", newline="\n")
    return 1, []


def _drawn(points: np.ndarray) -> list[str]:
    x, y = points[0]
    commands = [f"PU{x},{y}"]
    for start in range(1, len(points), AT_ONCE):
        commands.append("PD" + ",".join(f"{x},{y}" for x, y in points[start : start + AT_ONCE]))
    return commands


PLT_FORMAT = Format(
    ".plt", "PLT, for plotters", "HPGL, which plotters and vinyl cutters read", write_plt, read_plt, is_along_cloth=True
)
