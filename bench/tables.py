# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/benchmarks.md, from the JSON output of wirewarp_bench and from comparisons with peers."""

import math
from collections.abc import Sequence
from itertools import groupby

from peers import PEER, WARPED_ELASTIC, Comparison

STAGES = {  # of FlattenResult.seconds, by the benchmark of a method
    "refine_sheet": {"shape": "shape"},
    "warp_sheet": {"wires": "network", "interior": "interior", "lengths": "lengths"},
}
TEXT_COLUMNS = ("method", "part", "termination")


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    rule = [":--" if name in TEXT_COLUMNS else "--:" for name in head]
    return ["| " + " | ".join(cells) + " |" for cells in (head, rule, *rows)]


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """k of the line through the logarithms: seconds ~ size^k."""
    x, y = [math.log(s) for s in sizes], [math.log(s) for s in seconds]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y, strict=True)) / sum((a - mean_x) ** 2 for a in x)


def arguments_of(benchmark: dict) -> dict[str, int]:
    """From a name such as flatten_sheet/triangles:10000/wires:2."""
    pairs = (part.split(":") for part in benchmark["name"].split("/")[1:])
    return {name: int(value) for name, value in pairs}


def select(benchmarks: list[dict], name: str) -> list[dict]:
    return [b | arguments_of(b) for b in benchmarks if b["name"].startswith(name + "/")]


def stage_table(benchmarks: list[dict], name: str) -> list[str]:
    """Whole runs of one method, and below each kind of wires how its times grow."""
    last_stages = {"packing": "packing", "measure": "measure", "total": "whole run"}
    stages = {"charts": "charts", **STAGES[name], **last_stages}
    rows = []
    for (wires, percent), group in groupby(select(benchmarks, name), key=lambda run: (run["wires"], run["percent"])):
        runs = list(group)
        kind = f"{wires}, ±{percent} %" if percent else f"{wires}, rigid"
        for run in runs:
            times = [f"{run[f'{stage}_ms']:,.3g}" for stage in stages]
            rows.append((f"{run['triangles']:,}", kind, *times, f"{run['peak_MB']:,.0f}"))
        sizes = [run["triangles"] for run in runs]
        growth = [f"*{exponent(sizes, [run[f'{stage}_ms'] for run in runs]):.2f}*" for stage in stages]
        rows.append(("*exponent*", kind, *growth, ""))
    return table(["triangles", "wires", *stages.values(), "peak MB"], rows)


def part_table(benchmarks: list[dict]) -> list[str]:
    """Parts of the stages measured alone."""
    names = {
        "placement_factor": "interior placement, factoring",
        "placement_solve": "interior placement, solving",
        "circle_embedding": "embedding on a circle",
        "free_start": "free ARAP from there, the embedding included",
        "free_start_from_rigid": "free ARAP from the rigid shape",
    }
    rows = []
    for name, what in names.items():
        for wires, group in groupby(select(benchmarks, name), key=lambda run: run["wires"]):
            runs = list(group)
            times = [run["real_time"] for run in runs]
            growth = f"*{exponent([run['triangles'] for run in runs], times):.2f}*"
            rows.append((what, str(wires), *(f"{t:,.3g}" for t in times), growth))
    return table(["part", "wires", "10,000", "100,000", "1,000,000", "*exponent*"], rows)


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
        rows.append((f"{run['triangles']:,}", *times, f"{ratio:.2f}", f"{100 * share:.0f} %"))
    return table(["triangles", "reading", "solving", "writing", "Flatten", "unwrap", "ratio", "read and write"], rows)


def peer_table(comparisons: list[Comparison]) -> list[str]:
    rows = []
    for comparison in comparisons:
        peer = comparison.seconds[PEER]
        for name, result in comparison.results.items():
            piece = result.pieces[0]
            variations = [(wire, wire.variation) for wire in piece.wires] + [(edge, 0.0) for edge in piece.boundaries]
            line_error = max(abs(line.length_2d / ((1 + h) * line.length_3d) - 1) for line, h in variations)
            rows.append(
                (
                    f"{comparison.triangles:,}",
                    name,
                    f"{comparison.seconds[name]:.3g}",
                    f"{comparison.seconds[name] / peer:.2f}",
                    f"{piece.metrics.arap_energy:.5f}",
                    f"{line_error:.1e}",
                    f"{max(line.max_edge_error for line, _ in variations):.1e}",
                    str(len(piece.metrics.flipped_faces)),
                )
            )
    head = ["triangles", "method", "seconds", "of ARAP's", "energy", "worst line", "worst edge", "flipped"]
    return table(head, rows)


def elastic_table(comparisons: list[Comparison]) -> list[str]:
    """What the outer problem of WireWarping++ did."""
    rows = []
    for comparison in comparisons:
        report = comparison.results[WARPED_ELASTIC].pieces[0].report
        counts = (report.gradient_evaluations, report.outer_iterations, report.inner_solves, report.factorizations)
        rows.append((f"{comparison.triangles:,}", *map(str, counts)))
    head = ["triangles", "evaluations of E", "BFGS steps", "factorizations of Eq. (1)", "of interior and free start"]
    return table(head, rows)


def refined_table(comparisons: list[Comparison]) -> list[str]:
    """What the refined method did."""
    rows = []
    for comparison in comparisons:
        for name, result in comparison.results.items():
            if not name.startswith("refined"):
                continue
            report = result.pieces[0].report
            counts = (str(report.factorizations), str(report.outer_iterations), f"{report.objective:.6f}")
            rows.append((f"{comparison.triangles:,}", name, *counts, report.termination))
    return table(["triangles", "method", "factorizations", "steps", "objective", "termination"], rows)


def growth_sentence(comparisons: list[Comparison]) -> str:
    """Of all methods that ran at every size."""
    sizes = [comparison.triangles for comparison in comparisons]
    everywhere = [name for name in comparisons[0].seconds if all(name in c.seconds for c in comparisons)]
    growth = (f"{exponent(sizes, [c.seconds[name] for c in comparisons]):.2f} ({name})" for name in everywhere)
    return f"Seconds grow as triangles to the power of {', '.join(growth)}."
