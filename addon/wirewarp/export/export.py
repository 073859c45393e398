# SPDX-License-Identifier: GPL-3.0-or-later
"""From what was read of flat pieces to a file. No Blender in here."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..core import pattern
from ..solve.steps import Steps, in_one_go, in_slices, told_as
from .pattern_parts import Cloth, PatternChoices, PatternParts, Stages, laid_on_kept

SEARCH = 0.9  # of the whole, where a marker is sought, which takes seconds; what else there is comes before and after


@dataclass(frozen=True)
class ExportChoices:
    made: PatternChoices
    drawn: frozenset[str]  # kinds of lines, marks and texts as Pattern.with_only has them
    options: Mapping[str, Any] = field(default_factory=dict)  # of Pattern.write
    in_rows: bool = False  # else as the pieces lie
    cloth: Cloth | None = None  # on which they are nested instead
    seconds: float = 0.0  # to seek one
    anew: bool = False  # also where one is kept


@dataclass(frozen=True)
class Exported:
    made: pattern.Pattern
    written: pattern.Written
    cloth: Cloth | None  # of a marker


def made_pattern(parts: PatternParts, choices: ExportChoices) -> pattern.Pattern:
    """As it will be written. Raises ObjectError and FlattenError."""
    return in_one_go(in_slices(_making(parts, choices)))


def export(parts: PatternParts, choices: ExportChoices, path: Path) -> Steps[Exported]:
    """Writes the file, whole or not at all.

    Raises ObjectError, FlattenError, OSError and RuntimeError as the library does; the file is then as it was, as when
    the steps are closed.
    """
    has_search = choices.cloth is not None
    return in_slices(told_as(_exporting(parts, choices, path), lambda told: _share(*told, has_search)))


def _exporting(parts: PatternParts, choices: ExportChoices, path: Path) -> Stages[Exported]:
    made = yield from _making(parts, choices)
    written = yield from made.writing(path, **choices.options)
    return Exported(made, written, choices.cloth)


def _making(parts: PatternParts, choices: ExportChoices) -> Stages[pattern.Pattern]:
    made = (yield from parts.making(choices.made)).with_only(choices.drawn)
    cloth = choices.cloth
    if cloth is None:
        return made.arranged() if choices.in_rows else made
    kept = None if choices.anew else laid_on_kept(made, parts.kept, cloth)
    if kept:
        return kept
    marker = yield from made.nesting(cloth.width, gap=cloth.gap, grain=cloth.grain, seconds=choices.seconds)
    return made.laid_on(marker)


def _share(stage: str, fraction: float, has_search: bool) -> float:
    """How much of the whole is done."""
    stages = pattern.STAGES
    if stage == "nesting":
        return stages["writing"] * (1 - SEARCH) + fraction * SEARCH
    begin = stages[stage]
    end = min((each for each in stages.values() if each > begin), default=1.0)
    done = begin + fraction * (end - begin)
    if not has_search:
        return done
    return done * (1 - SEARCH) + (SEARCH if begin >= stages["writing"] else 0.0)
