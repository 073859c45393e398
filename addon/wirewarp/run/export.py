# SPDX-License-Identifier: GPL-3.0-or-later
"""From what was read of flat pieces to a file. No Blender in here, so that it may run in a thread."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..core import FlattenError, pattern
from ..issues import ObjectError
from ..solve.pattern_parts import PatternChoices, PatternParts
from .thread import CancelledError, Progress

STAGES = {  # of the library: where each begins in the whole, as on a garment of 20 pieces
    "allowance": 0.0,
    "marks and lines": 0.2,
    "texts": 0.3,
    "writing": 0.5,
    "sheets": 0.6,
    "reading again": 0.8,
}


@dataclass(frozen=True)
class ExportChoices:
    made: PatternChoices
    drawn: frozenset[str]  # kinds of lines, marks and texts as Pattern.with_only has them
    in_rows: bool  # else as the pieces lie
    options: Mapping[str, Any] = field(default_factory=dict)  # of Pattern.write


@dataclass(frozen=True)
class Exported:
    made: pattern.Pattern
    written: pattern.Written


def made_pattern(parts: PatternParts, choices: ExportChoices, progress: Progress | None = None) -> pattern.Pattern:
    """As it will be written. Raises ObjectError and FlattenError."""
    made = parts.pattern(choices.made, progress).with_only(choices.drawn)
    return made.arranged() if choices.in_rows else made


def export(parts: PatternParts, choices: ExportChoices, path: Path, progress: Progress) -> Exported:
    """Writes the file, whole or not at all.

    Raises CancelledError if progress returned False, ObjectError, FlattenError, OSError and RuntimeError as the library
    does; the file is then as it was.
    """
    stopped = False

    def whole(stage: str, fraction: float) -> bool:
        nonlocal stopped
        begin = STAGES[stage]
        end = min((each for each in STAGES.values() if each > begin), default=1.0)
        stopped = progress(stage, begin + fraction * (end - begin)) is False
        return not stopped

    try:
        made = made_pattern(parts, choices, whole)
        return Exported(made, made.write(path, progress=whole, **choices.options))
    except (ObjectError, FlattenError) as error:
        if stopped:
            raise CancelledError from error
        raise
