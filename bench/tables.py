# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes Markdown tables from the JSON output of wirewarp_bench (the core alone) and of flatten_in_blender.py."""

import math
from collections.abc import Sequence
from itertools import groupby

STAGES = {  # for the benchmark of each method: keys of FlattenResult.seconds and their titles
    "refine_sheet": {"charts": "charts", "shape": "shape", "packing": "packing", "measure": "measure", "total": "all"},
    "warp_sheet": {
        "charts": "charts",
        "wires": "network",
        "interior": "interior",
        "lengths": "lengths",
        "packing": "packing",
        "measure": "measure",
        "total": "all",
    },
}
TEXT_COLUMNS = ("method", "part", "termination", "target", "verdict", "mesh", "outcome", "what is said")


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    rule = [":--" if name in TEXT_COLUMNS else "--:" for name in head]
    return ["| " + " | ".join(cells) + " |" for cells in (head, rule, *rows)]


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return the slope k of the line fitted to the logarithms: seconds ~ size^k."""
    x, y = [math.log(s) for s in sizes], [math.log(s) for s in seconds]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y, strict=True)) / sum((a - mean_x) ** 2 for a in x)


def arguments_of(benchmark: dict) -> dict[str, int]:
    """Return the arguments in the name of a benchmark, such as refine_sheet/triangles:10000/wires:2."""
    pairs = (part.split(":") for part in benchmark["name"].split("/")[1:])
    return {name: int(value) for name, value in pairs}


def select(benchmarks: list[dict], name: str) -> list[dict]:
    return [b | arguments_of(b) for b in benchmarks if b["name"].startswith(name + "/")]


def by_wires(runs: list[dict]) -> list[list[dict]]:
    """Return the runs of one method, grouped by number and tolerance of the wires."""
    return [list(group) for _, group in groupby(runs, key=lambda run: (run["wires"], run["percent"]))]


def stage_exponents(runs: list[dict], stage: str) -> list[float]:
    """Return the exponent of growth of a stage for each group of by_wires()."""
    return [exponent([r["triangles"] for r in same], [r[f"{stage}_ms"] for r in same]) for same in by_wires(runs)]


def stage_table(benchmarks: list[dict], name: str) -> list[str]:
    """Return a table of one method's runs. Below the runs with each kind of wires, a row has the growth exponents."""
    stages = STAGES[name]
    rows = []
    for runs in by_wires(select(benchmarks, name)):
        wires, percent = runs[0]["wires"], runs[0]["percent"]
        kind = f"{wires}, ±{percent}%" if percent else f"{wires}, rigid"
        for run in runs:
            times = [f"{run[f'{stage}_ms']:,.3g}" for stage in stages]
            rows.append((f"{run['triangles']:,}", kind, *times, f"{run['peak_MB']:,.0f}"))
        growth = [f"*{k:.2f}*" for stage in stages for k in stage_exponents(runs, stage)]
        rows.append(("*exponent*", kind, *growth, ""))
    return table(["triangles", "wires", *stages.values(), "peak MB"], rows)


def part_table(benchmarks: list[dict]) -> list[str]:
    """Return the table of parts of stages that were measured alone, in milliseconds."""
    names = {
        "placement_factor": "interior placement, factoring",
        "placement_solve": "interior placement, solving",
        "circle_embedding": "embedding on a circle",
        "free_start": "free ARAP from the circle, including the embedding",
        "free_start_from_rigid": "free ARAP from the rigid shape",
    }
    sizes = sorted({run["triangles"] for name in names for run in select(benchmarks, name)})
    rows = []
    for name, what in names.items():
        for wires, group in groupby(select(benchmarks, name), key=lambda run: run["wires"]):
            runs = list(group)
            times = [run["real_time"] for run in runs]
            growth = f"*{exponent([run['triangles'] for run in runs], times):.2f}*"
            rows.append((what, str(wires), *(f"{t:,.3g}" for t in times), growth))
    return table(["part", "wires", *(f"{size:,}" for size in sizes), "*exponent*"], rows)


def gradient_table(benchmarks: list[dict]) -> list[str]:
    rows = []
    evaluations, gradients = select(benchmarks, "error_evaluation"), select(benchmarks, "error_gradient")
    for evaluation, gradient in zip(evaluations, gradients, strict=True):
        rows.append(
            (
                f"{evaluation['triangles']:,}",
                str(evaluation["wires"]),
                f"{evaluation['real_time']:,.3g}",
                f"{gradient['real_time']:,.3g}",
                f"{gradient['real_time'] / evaluation['real_time']:.2f}",
                f"{evaluation['factorizations']:.0f}",
                f"{gradient['factorizations']:.0f}",
            )
        )
    head = ["triangles", "wires", "E(ψ(h)), ms", "gradient, ms", "ratio", "factorizations for E", "for the gradient"]
    return table(head, rows)


def blender_table(runs: list[dict]) -> list[str]:
    rows = []
    for run in runs:
        times = [f"{run[name]:.3g}" for name in ("read", "solve", "write", "flatten", "unwrap")]
        ratio, share = run["flatten"] / run["unwrap"], (run["read"] + run["write"]) / run["flatten"]
        rows.append((f"{run['triangles']:,}", *times, f"{ratio:.2f}", f"{100 * share:.0f}%"))
    return table(["triangles", "reading", "solving", "writing", "Flatten", "unwrap", "ratio", "read and write"], rows)
