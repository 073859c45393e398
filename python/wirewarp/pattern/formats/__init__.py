# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists the kinds of files for patterns. Writes a file, then reads it again and checks it."""

from collections.abc import Mapping
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np

from ..checks import problem
from ..files import replaced_file
from ..geometry import Motion
from ..pattern_data import PatternData, Written
from ..progress import Steps
from .dxf import DXF_FORMAT
from .hpgl import PLT_FORMAT
from .pdf import PDF_FORMAT
from .read_back import check
from .svg import SVG_FORMAT

FORMATS = {each.suffix: each for each in (PDF_FORMAT, SVG_FORMAT, DXF_FORMAT, PLT_FORMAT)}


def writing(pattern: PatternData, path: Path, options: Mapping[str, Any]) -> Steps[Written]:
    """Do the work of Pattern.write() in steps."""
    chosen = FORMATS.get(path.suffix.lower())
    if chosen is None:
        raise problem(f'"{path.name}" must end in one of {", ".join(FORMATS)}: other files cannot be written.')
    known = list(signature(chosen.write).parameters)[2:]
    for name in options:
        if name not in known:
            raise problem(f"{path.suffix} files have no option {name!r}. Their options: {', '.join(known) or 'none'}.")
    drawn = pattern
    if chosen.is_along_cloth and pattern.marker:
        drawn = pattern.placed(Motion(np.array([0.0, pattern.marker.width]), -90.0))
    with replaced_file(path) as unfinished:
        sheets, warnings = yield from chosen.write(unfinished, drawn, **options)
        outlines = [line.points for piece in drawn.pieces for line in piece.of_role("cut", "inner_cut")]
        off = yield from check(chosen.read_cut_lines(unfinished), outlines)
    return Written(path, sheets, len(pattern.pieces), off, [*pattern.warnings, *warnings])
