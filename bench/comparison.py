# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs all methods on a surface in turn, each turn in its own process, and compares the results."""

import statistics
from dataclasses import dataclass, replace

import wirewarp
from flatteners import METHODS, Answer, Method
from run_apart import NoAnswerError, run_apart
from surfaces import Surface

ONCE_IS_ENOUGH = 20.0  # seconds of a run; slower methods run once


@dataclass(frozen=True)
class Outcome:
    """Results of one method. Errors are relative to its target lengths, or else to the lengths on the surface."""

    seconds: float  # CPU seconds of the method
    megabytes: float  # peak memory, without the memory of the surface
    energy: float  # ARAP energy divided by the area
    outline_error: float  # error of the worst section of outline
    wire_error: float  # error of the worst wire
    edge_error: float  # error of the worst edge of outline and wires
    mismatch: float  # difference in length between the sides of the worst seam, in the surface's units; 0 without seams
    flipped: int
    iterations: int | None  # number of iterations of libigl; None for other methods
    counts: dict[str, float | str]  # counts of work, objective and termination in the report on the first piece


@dataclass(frozen=True)
class Comparison:
    surface: str
    triangles: int
    outcomes: dict[str, Outcome]  # by the name of the method
    without: dict[str, str]  # reasons why methods have no result, by the name of the method

    def seconds(self, name: str) -> float | None:
        return self.outcomes[name].seconds if name in self.outcomes else None


def judged(answer: Answer) -> Outcome:
    """Return the outcome. Raises NoAnswerError if a piece has no layout."""
    pieces = answer.flattening.pieces
    for piece in pieces:
        if piece.error and not piece.error.has_layout:
            raise NoAnswerError(f"refused: {piece.error.code}")
    stretches = [stretch for piece in pieces for stretch in piece.boundaries]
    parts = [part for piece in pieces for part in piece.wires]
    report = pieces[0].report.to_dict()
    names = ("factorizations", "outer_iterations", "inner_solves", "gradient_evaluations", "objective", "termination")
    area = sum(piece.metrics.area_3d for piece in pieces)
    return Outcome(
        seconds=answer.seconds,
        megabytes=answer.megabytes,
        energy=sum(piece.metrics.arap_energy * piece.metrics.area_3d for piece in pieces) / area,
        outline_error=max(abs(stretch.length_2d / stretch.length_3d - 1) for stretch in stretches),
        wire_error=max((length_error(part) for part in parts), default=0.0),
        edge_error=max(line.max_edge_error for line in [*stretches, *parts]),
        mismatch=max((seam.mismatch for seam in answer.flattening.seams), default=0.0),
        flipped=sum(len(piece.metrics.flipped_faces) for piece in pieces),
        iterations=answer.iterations,
        counts={name: report[name] for name in names},
    )


def length_error(part: wirewarp.WireReport) -> float:
    return abs(part.length_2d / ((1 + part.variation) * part.length_3d) - 1)


def compare(surface: Surface, names: list[str], rounds: int, limit: float) -> Comparison:
    """Return the results of all methods, with medians of the costs over the rounds. Slow methods run only once.

    limit: seconds of wall time for a method in a round.
    """
    found: dict[str, list[Outcome]] = {}
    without: dict[str, str] = {}
    for turn in range(rounds):
        for name in names:
            if name in without or (turn > 0 and found[name][0].seconds > ONCE_IS_ENOUGH):
                continue
            try:
                found.setdefault(name, []).append(run_apart(lambda name=name: run(METHODS[name], surface), limit))
            except NoAnswerError as reason:
                without[name] = str(reason)
                found.pop(name, None)
    return Comparison(surface.name, len(surface.faces), {n: medians(o) for n, o in found.items()}, without)


def run(method: Method, surface: Surface) -> Outcome:
    return judged(method(surface))


def medians(outcomes: list[Outcome]) -> Outcome:
    return replace(
        outcomes[-1],
        seconds=statistics.median(outcome.seconds for outcome in outcomes),
        megabytes=statistics.median(outcome.megabytes for outcome in outcomes),
    )
