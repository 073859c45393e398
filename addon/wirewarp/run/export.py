# SPDX-License-Identifier: GPL-3.0-or-later
"""From what was read of flat pieces to a file. No Blender in here, so that it may run in a thread."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..core import FlattenError, pattern
from ..issues import ObjectError
from ..solve.pattern_parts import Cloth, PatternChoices, PatternParts, laid_on_kept
from .thread import CancelledError, Progress

STAGES = {  # of the library: where each begins in the whole, as on a garment of 20 pieces
    "allowance": 0.0,
    "marks and lines": 0.2,
    "texts": 0.3,
    "writing": 0.5,
    "sheets": 0.6,
    "reading again": 0.8,
}
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


def made_pattern(parts: PatternParts, choices: ExportChoices, progress: Progress | None = None) -> pattern.Pattern:
    """As it will be written. Raises ObjectError and FlattenError."""
    made = parts.pattern(choices.made, progress).with_only(choices.drawn)
    if choices.cloth is None:
        return made.arranged() if choices.in_rows else made
    kept = None if choices.anew else laid_on_kept(made, parts.kept, choices.cloth)
    cloth, seconds = choices.cloth, choices.seconds
    return kept or made.laid_on(
        made.nested(cloth.width, gap=cloth.gap, grain=cloth.grain, seconds=seconds, progress=progress)
    )


def export(parts: PatternParts, choices: ExportChoices, path: Path, progress: Progress) -> Exported:
    """Writes the file, whole or not at all.

    Raises CancelledError if progress returned False, ObjectError, FlattenError, OSError and RuntimeError as the library
    does; the file is then as it was.
    """
    stopped = False

    def whole(stage: str, fraction: float) -> bool:
        nonlocal stopped
        stopped = progress(stage, _share(stage, fraction, choices.cloth is not None)) is False
        return not stopped

    try:
        made = made_pattern(parts, choices, whole)
        if stopped:  # a search that is stopped has the best marker so far
            raise CancelledError
        return Exported(made, made.write(path, progress=whole, **choices.options), choices.cloth)
    except (ObjectError, FlattenError) as error:
        if stopped:
            raise CancelledError from error
        raise


def _share(stage: str, fraction: float, has_search: bool) -> float:
    """How much of the whole is done."""
    if stage == "nesting":
        return STAGES["writing"] * (1 - SEARCH) + fraction * SEARCH
    begin = STAGES[stage]
    end = min((each for each in STAGES.values() if each > begin), default=1.0)
    done = begin + fraction * (end - begin)
    if not has_search:
        return done
    return done * (1 - SEARCH) + (SEARCH if begin >= STAGES["writing"] else 0.0)
