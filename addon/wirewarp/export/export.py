# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pattern of flat pieces and writes it to a file, without Blender."""

from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, NamedTuple

from ..core import FlattenError, pattern
from ..issues import object_error
from ..solve.steps import Steps, T, in_one_go, in_slices, reported_as

Stages = Generator[tuple[str, float], None, T]  # each step yields the name of the stage and its completed share


Grain = Literal["one way", "both ways", "free"]
GRAINS: dict[str, Grain] = {"ONE_WAY": "one way", "BOTH_WAYS": "both ways", "FREE": "free"}


@dataclass(frozen=True)
class Cloth:
    """The fabric on which pieces are nested; lengths are in millimeters."""

    width: float
    gap: float
    grain: Grain  # how pieces may be turned


def library_paper(paper: str, roll_width: float) -> str | float:
    """Return a paper of the settings as the library needs it: its name, or the width of the roll. roll_width: width of
    "ROLL", in millimeters."""
    return roll_width if paper == "ROLL" else paper.lower().replace("_", "-")


@dataclass(frozen=True)
class KeptMarker:
    cloth: Cloth
    marker: pattern.Marker


class Allowances(NamedTuple):
    """Marked allowances, in the form that Pattern.from_pieces needs: pairs of vertices, with widths in millimeters."""

    both: list[tuple[int, int, float]]
    sides: list[tuple[int, int, float]]
    folds: list[tuple[int, int]]


@dataclass(frozen=True)
class PatternParts:
    title: str
    pieces: Sequence[pattern.FlatPiece]
    failed: Sequence[str]
    seam_names: Sequence[str]
    allowances: Allowances
    units: Literal["metric", "imperial"]
    date: str
    measures: Sequence[tuple[str, float]] = ()  # names of rigid wires, and their lengths on the model in millimeters
    kept: KeptMarker | None = None

    @property
    def refusal(self) -> str:
        """Return a sentence that says why the pieces should not be cut; empty if they may be cut."""
        if not self.failed:
            return ""
        return (
            f"Failed: {', '.join(self.failed)}. The report names the faults. To export these pieces anyway, turn on "
            "Failed Pieces."
        )

    def narrow(self, allowance: float) -> list[str]:
        """Return the names of the pieces that are too narrow somewhere for two allowances side by side.

        allowance: allowance of unmarked edges, in millimeters.
        """
        return pattern.narrow_pieces(self.pieces, allowance, *self.allowances)

    def cut_lines(self, **options: Any) -> pattern.Pattern:  # noqa: ANN401
        """Return a pattern with only the cutting lines of the pieces, in their places. Raises ObjectError."""
        with _errors_of_library():
            return pattern.Pattern.of_cut_lines(self.pieces, **options, **self._marked)

    def making(self, options: pattern.PatternOptions) -> Stages[pattern.Pattern]:
        """Make the pattern in steps. Raises ObjectError if no pattern can be made from these pieces."""
        own = {"title": self.title, "date": self.date, "measures": self.measures}
        with _errors_of_library():
            return (yield from pattern.Pattern.making(self.pieces, self.seam_names, **options, **own, **self._marked))

    @property
    def _marked(self) -> dict[str, Any]:
        both, sides, folds = self.allowances
        return {"units": self.units, "allowances": both, "side_allowances": sides, "folds": folds}


@contextmanager
def _errors_of_library() -> Iterator[None]:
    """Raise an ObjectError instead of the library's FlattenError."""
    try:
        yield
    except FlattenError as error:
        raise object_error(str(error.code), error.message) from error


def laid_on_kept(made: pattern.Pattern, kept: KeptMarker | None, cloth: Cloth) -> pattern.Pattern | None:
    """Return the pattern on the stored marker; None if the marker is for another fabric or other pieces."""
    if kept is None or kept.cloth != cloth:
        return None
    try:
        return made.laid_on(kept.marker)
    except FlattenError:
        return None


SEARCH = 0.9  # share of the progress bar for the search for a marker, which takes most of the time


@dataclass(frozen=True)
class ExportChoices:
    made: pattern.PatternOptions
    drawn: frozenset[str]  # kinds of lines, marks and texts, as in Pattern.with_only
    options: Mapping[str, Any] = field(default_factory=dict)  # options of Pattern.write
    # If true, pieces are arranged in rows, otherwise they keep their places. With a marker, this has no effect.
    in_rows: bool = False
    cloth: Cloth | None = None  # fabric on which the pieces are nested; None without a marker
    seconds: float = 0.0
    anew: bool = False  # whether to search even if a marker is stored


@dataclass(frozen=True)
class Exported:
    made: pattern.Pattern
    written: pattern.Written
    cloth: Cloth | None  # fabric of the marker


def made_pattern(parts: PatternParts, choices: ExportChoices) -> pattern.Pattern:
    """Return the pattern that export() would write. Raises ObjectError and FlattenError."""
    return in_one_go(in_slices(_making(parts, choices)))


def export(parts: PatternParts, choices: ExportChoices, path: Path) -> Steps[Exported]:
    """Write the file in steps. After an error, or if the steps are closed early, the file is unchanged. Raises
    ObjectError, FlattenError, OSError and RuntimeError."""
    has_search = choices.cloth is not None
    return in_slices(reported_as(_exporting(parts, choices, path), lambda step: _share(*step, has_search)))


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
    """Return the completed share of the whole run, from the completed fraction of a stage."""
    stages = pattern.STAGES
    if stage == "nesting":
        return stages["writing"] * (1 - SEARCH) + fraction * SEARCH
    begin = stages[stage]
    end = min((each for each in stages.values() if each > begin), default=1.0)
    done = begin + fraction * (end - begin)
    if not has_search:
        return done
    return done * (1 - SEARCH) + (SEARCH if begin >= stages["writing"] else 0.0)
