# SPDX-License-Identifier: GPL-3.0-or-later
"""Which writer writes which kind of file."""

from collections.abc import Callable, Mapping
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np

from .checks import problem
from .dxf import write_dxf
from .hpgl import write_plt
from .motion import Motion
from .pattern_data import PatternData, Written
from .pdf import write_pdf
from .progress import Steps
from .read_back import check
from .replace_file import replaced_file
from .svg import write_svg

WRITERS: dict[str, Callable[..., Steps[tuple[int, list[str]]]]] = {
    ".svg": write_svg,
    ".pdf": write_pdf,
    ".dxf": write_dxf,
    ".plt": write_plt,
}


def writing(pattern: PatternData, path: Path, options: Mapping[str, Any]) -> Steps[Written]:
    kind = path.suffix.lower()
    writer = WRITERS.get(kind)
    if writer is None:
        known = ", ".join(WRITERS)
        raise problem(f'"{path.name}" ends in none of {known}: no other kind of file can be written.')
    known_options = list(signature(writer).parameters)[2:]
    for name in options:
        if name not in known_options:
            has = " and ".join(known_options) or "none"
            raise problem(f"{path.suffix} files have no option {name!r}; they have {has}.")
    drawn = pattern
    if kind == ".plt" and pattern.marker:  # with x along the cloth, as plotters have it
        drawn = pattern.placed(Motion(np.array([0.0, pattern.marker.width]), -90.0))
    with replaced_file(path) as unfinished:
        sheets, warnings = yield from writer(unfinished, drawn, **options)
        outlines = [line.points for piece in drawn.pieces for line in piece.of_role("cut", "inner_cut")]
        off = yield from check(unfinished, kind, outlines)
    return Written(path, sheets, len(pattern.pieces), off, [*pattern.warnings, *warnings])
