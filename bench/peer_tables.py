# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the tables of docs/benchmarks.md that compare the methods."""

from collections.abc import Sequence

from comparison import Comparison, Outcome
from flatteners import ARAP, METHODS, REFINED_ELASTIC, WARPED_ELASTIC
from tables import exponent, table

COSTS = ["seconds", "of ARAP's", "MB"]
DISTORTION = ["energy", "worst outline", "worst wire", "worst edge", "flipped"]


def method_cell(name: str, outcome: Outcome | None) -> str:
    return f"{name} ({outcome.iterations} iterations)" if outcome and outcome.iterations else name


def costs(comparison: Comparison, name: str) -> list[str]:
    if name in comparison.without:
        return [comparison.without[name].replace("|", "/"), "", ""]
    outcome, peer = comparison.outcomes[name], comparison.seconds(ARAP)
    of_peer = f"{outcome.seconds / peer:.2f}" if peer else ""
    return [f"{outcome.seconds:,.3g}", of_peer, f"{outcome.megabytes:,.0f}"]


def distortion(outcome: Outcome | None) -> list[str]:
    if outcome is None:
        return [""] * len(DISTORTION)
    errors = [f"{error:.1e}" for error in (outcome.outline_error, outcome.wire_error, outcome.edge_error)]
    return [f"{outcome.energy:.5f}", *errors, str(outcome.flipped)]


def cells(comparison: Comparison, name: str) -> list[str]:
    outcome = comparison.outcomes.get(name)
    return [method_cell(name, outcome), *costs(comparison, name), *distortion(outcome)]


def methods_of(comparison: Comparison) -> list[str]:
    return [name for name in METHODS if name in comparison.outcomes or name in comparison.without]


def peer_table(comparisons: Sequence[Comparison], first: str = "triangles") -> list[str]:
    rows = [(c.surface, *cells(c, name)) for c in comparisons for name in methods_of(c)]
    return table([first, "method", *COSTS, *DISTORTION], rows)


def hard_table(comparisons: Sequence[Comparison]) -> list[str]:
    rows = []
    for c in comparisons:
        outcome = c.outcomes.get(REFINED_ELASTIC)
        rows.append((c.surface, *costs(c, REFINED_ELASTIC), str(outcome.counts["factorizations"]) if outcome else ""))
    return table(["triangles", *COSTS, "factorizations"], rows)


def seam_table(comparison: Comparison) -> list[str]:
    rows = []
    for name in methods_of(comparison):
        outcome = comparison.outcomes.get(name)
        mismatch = f"{1e3 * outcome.mismatch:.2g}" if outcome else ""
        rows.append((*cells(comparison, name), mismatch))
    return table(["method", *COSTS, *DISTORTION, "seam, mm"], rows)


def elastic_table(comparisons: Sequence[Comparison]) -> list[str]:
    """Return the table with the work of WireWarping++ in the search for the best lengths."""
    names = ("gradient_evaluations", "outer_iterations", "inner_solves", "factorizations")
    rows = [
        (c.surface, *(str(c.outcomes[WARPED_ELASTIC].counts[name]) for name in names))
        for c in comparisons
        if WARPED_ELASTIC in c.outcomes
    ]
    head = ["triangles", "evaluations of E", "BFGS steps", "factorizations of Eq. (1)", "of interior and free start"]
    return table(head, rows)


def refined_table(comparisons: Sequence[Comparison]) -> list[str]:
    rows = []
    for comparison in comparisons:
        for name, outcome in comparison.outcomes.items():
            if name.startswith("refined"):
                found = outcome.counts
                counts = (str(found["factorizations"]), str(found["outer_iterations"]), f"{found['objective']:.6f}")
                rows.append((comparison.surface, name, *counts, found["termination"]))
    return table(["triangles", "method", "factorizations", "steps", "objective", "termination"], rows)


def growth(comparisons: Sequence[Comparison], name: str) -> tuple[list[int], list[float], float | None]:
    """Return sizes, seconds and the exponent of growth.

    The exponent is for 10,000 triangles or more, because fixed costs dominate smaller sizes.
    """
    points = [(c.triangles, c.outcomes[name].seconds) for c in comparisons if name in c.outcomes]
    large = [point for point in points if point[0] > 5_000]
    sizes, seconds = [size for size, _ in points], [time for _, time in points]
    return sizes, seconds, exponent(*zip(*large, strict=True)) if len(large) > 1 else None
