# SPDX-License-Identifier: GPL-3.0-or-later
"""Which writer writes which kind of file."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .pattern import Written
from .replace_file import replaced_file
from .svg import write_svg
from .widths import problem

if TYPE_CHECKING:
    from .pattern import Pattern


def write(pattern: "Pattern", path: Path, options: Mapping[str, Any]) -> Written:
    if path.suffix.lower() != ".svg":
        raise problem(f'"{path.name}" does not end in .svg, and no other kind of file can be written.')
    with replaced_file(path) as unfinished:
        write_svg(unfinished, pattern)
    return Written(path, 1, pattern.warnings)
