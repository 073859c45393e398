# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the performance targets of the project with the measurements."""

from collections.abc import Callable, Sequence

import flatteners
from comparison import Comparison
from tables import STAGES, select, stage_exponents, table

SIZES = (10_000, 100_000, 1_000_000)
REACHED = "reached"


def nearest(comparisons: Sequence[Comparison], triangles: int) -> Comparison | None:
    return next((c for c in comparisons if abs(c.triangles / triangles - 1) < 0.1), None)


def ratio(comparisons: Sequence[Comparison], ours: str, theirs: str, triangles: int) -> float | None:
    """Return the seconds of `ours` divided by the seconds of `theirs`, or None if one of the methods did not run."""
    found = nearest(comparisons, triangles)
    return over(found, found, ours, theirs) if found else None


def row(what: str, bound: float, found: float | None, unit: str = "") -> tuple[str, ...]:
    verdict = "not measured" if found is None else REACHED if found <= bound else "**not reached**"
    return what, f"≤ {bound:g}{unit}", "" if found is None else f"{found:.3g}{unit}", verdict


def ratios(comparisons: Sequence[Comparison]) -> list[tuple[str, ...]]:
    asked = [
        (flatteners.WARPING, flatteners.ARAP, ((10_000, 0.5), (100_000, 0.5))),
        (flatteners.WARPED_ELASTIC, flatteners.ARAP, ((100_000, 1.0),)),
        (flatteners.REFINED, flatteners.ARAP, ((10_000, 0.5), (100_000, 0.5), (1_000_000, 0.35))),
        (flatteners.REFINED_ELASTIC, flatteners.ARAP, ((10_000, 0.5), (100_000, 0.5), (1_000_000, 0.35))),
        (flatteners.REFINED, flatteners.SLIM, ((10_000, 0.5), (100_000, 0.1))),
        (flatteners.REFINED_ELASTIC, flatteners.SLIM, ((10_000, 0.5), (100_000, 0.1))),
    ]
    return [
        row(
            f"{ours}, seconds relative to {theirs}, {size:,} triangles",
            bound,
            ratio(comparisons, ours, theirs, size),
        )
        for ours, theirs, bounds in asked
        for size, bound in bounds
    ]


def of_hard_sheets(hard: Sequence[Comparison]) -> list[tuple[str, ...]]:
    """Return rows for jittered sheets, compared with ARAP, and for 128 wires, compared with eight wires."""
    ours, theirs = flatteners.REFINED_ELASTIC, flatteners.ARAP
    jittered = [c for c in hard if c.surface.endswith("jittered")]
    rows = [
        row(f"refined, wires ±3%, seconds relative to {theirs}, {c.surface}", 0.5, over(c, c, ours, theirs))
        for c in jittered
    ]
    nets = [c for c in hard if c not in jittered]
    most = over(nets[-1], nets[0], ours, ours)
    return [*rows, row(f"refined, wires ±3%, seconds relative to 8 wires, {nets[-1].surface}", 4, most)]


def over(first: Comparison, second: Comparison, ours: str, theirs: str) -> float | None:
    """Return the seconds of `ours` in `first` over the seconds of `theirs` in `second`; None if one did not run."""
    seconds = (first.seconds(ours), second.seconds(theirs))
    return None if None in seconds else seconds[0] / seconds[1]


def worst(runs: Sequence[dict], value: Callable[[dict], float]) -> float | None:
    return max(map(value, runs), default=None)


def of_the_core(benchmarks: list[dict]) -> list[tuple[str, ...]]:
    largest = [run for run in select(benchmarks, "refine_sheet") if run["triangles"] == SIZES[-1]]
    rows = [
        row("refined, the slowest run of 1,000,000 triangles", 20, worst(largest, lambda r: r["total_ms"] / 1e3), " s"),
        row(
            "refined, most memory of 1,000,000 triangles", 1.3, worst(largest, lambda run: run["peak_MB"] / 1e3), " GB"
        ),
    ]
    for name, method in {"refine_sheet": "refined", "warp_sheet": "wirewarp++"}.items():
        for stage, title in STAGES[name].items():
            exponents = stage_exponents(select(benchmarks, name), stage)
            rows.append(row(f"growth exponent of {method}, {title}, the largest", 1.2, worst(exponents, float)))
    return rows


def of_the_gradient(benchmarks: list[dict]) -> list[tuple[str, ...]]:
    runs = {run["wires"]: run for run in select(benchmarks, "error_gradient") if run["triangles"] == 100_000}
    evaluations = {run["wires"]: run for run in select(benchmarks, "error_evaluation") if run["triangles"] == 100_000}
    in_evaluations = {wires: runs[wires]["real_time"] / evaluations[wires]["real_time"] for wires in runs}
    return [
        row("gradient / evaluation of E, 232 wires relative to 4", 1.0, in_evaluations[232] / in_evaluations[4]),
        row("gradient in milliseconds, 232 wires relative to 4", 1.2, runs[232]["real_time"] / runs[4]["real_time"]),
    ]


def target_table(comparisons: Sequence[Comparison], hard: Sequence[Comparison], benchmarks: list[dict]) -> list[str]:
    """Return the table of all targets. The targets that were not reached come first."""
    rows = [*ratios(comparisons), *of_hard_sheets(hard), *of_the_core(benchmarks), *of_the_gradient(benchmarks)]
    return table(["target", "asked", "found", "verdict"], sorted(rows, key=lambda each: each[-1] == REACHED))
