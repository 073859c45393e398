# SPDX-License-Identifier: GPL-3.0-or-later
"""Which writer writes which kind of file."""

from collections.abc import Callable, Mapping
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .checks import problem
from .dxf import write_dxf
from .hpgl import write_plt
from .pattern import Written
from .pdf import write_pdf
from .read_back import check
from .replace_file import replaced_file
from .svg import write_svg

if TYPE_CHECKING:
    from .pattern import Pattern


WRITERS: dict[str, Callable[..., tuple[int, list[str]]]] = {
    ".svg": write_svg,
    ".pdf": write_pdf,
    ".dxf": write_dxf,
    ".plt": write_plt,
}


def write(pattern: "Pattern", path: Path, options: Mapping[str, Any]) -> Written:
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
    with replaced_file(path) as unfinished:
        sheets, warnings = writer(unfinished, pattern, **options)
        outlines = [line.points for piece in pattern.pieces for line in piece.of_role("cut", "inner_cut")]
        off = check(unfinished, kind, outlines)
    return Written(path, sheets, len(pattern.pieces), off, [*pattern.warnings, *warnings])
