# SPDX-License-Identifier: GPL-3.0-or-later
"""From what was read of flat pieces to a file. No Blender in here, so that it may run in a thread."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..core import pattern
from ..solve.pattern_parts import PatternChoices, PatternParts
from .thread import CancelledError, Progress

ARRANGED = 0.3  # of the whole time: until the pieces lie in their places


@dataclass(frozen=True)
class ExportChoices:
    made: PatternChoices
    drawn: frozenset[str]  # kinds of lines, marks and texts as Pattern.with_only has them
    in_rows: bool  # else as the pieces lie
    options: Mapping[str, object] = field(default_factory=dict)  # of Pattern.write


@dataclass(frozen=True)
class Exported:
    made: pattern.Pattern
    written: pattern.Written


def made_pattern(parts: PatternParts, choices: ExportChoices) -> pattern.Pattern:
    """As it will be written. Raises ObjectError and FlattenError."""
    made = parts.pattern(choices.made).with_only(choices.drawn)
    return made.arranged() if choices.in_rows else made


def export(parts: PatternParts, choices: ExportChoices, path: Path, progress: Progress) -> Exported:
    """Writes the file, whole or not at all.

    Raises CancelledError if progress returned False, ObjectError, FlattenError, OSError and RuntimeError as the library
    does; the file is then as it was.
    """
    _go_on(progress, 0.0)
    made = made_pattern(parts, choices)
    _go_on(progress, ARRANGED)
    return Exported(made, made.write(path, **choices.options))


def _go_on(progress: Progress, fraction: float) -> None:
    if progress("pattern", fraction) is False:
        raise CancelledError
