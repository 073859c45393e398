# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the benchmark sheet with WireWarp and with libigl's ARAP and SLIM, one after the other, and writes
docs/benchmarks.md: these times and lengths, those of the core alone from wirewarp_bench's JSON output, and those in
Blender from that of flatten_in_blender.py.

python bench/compare_peers.py NATIVE_JSON BLENDER_JSON [--triangles N ...] [--output FILE]
"""

import argparse
import json
import os
import platform
import subprocess
from pathlib import Path

import tables
from peers import ITERATIONS, LARGEST_FOR_SLIM, Comparison, compare

ROOT = Path(__file__).resolve().parent.parent


def machine() -> str:
    cpu = next(line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{cpu.partition(':')[2].strip()}, {os.cpu_count()} cores, {memory:.0f} GiB, {platform.system()}"


def commit() -> str:
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty"]
    return subprocess.check_output(command, text=True).strip()


def document(benchmarks: list[dict], in_blender: dict, comparisons: list[Comparison]) -> str:
    return "\n".join(
        [
            "# Benchmarks",
            "",
            "Written by `./dev bench`. The surface is a smoothly bent square sheet of even quads "
            "(`native/bench/bumpy_sheet.h`), with straight wires across it, half of them in each direction.",
            "",
            f"Machine: {machine()}. Commit: {commit()}.",
            "",
            "## Against libigl",
            "",
            f"libigl as a Python package: harmonic start, {ITERATIONS} iterations, and no line keeps its length; SLIM "
            f"(symmetric Dirichlet energy) up to {LARGEST_FOR_SLIM:,} triangles. WireWarp: the outline rigid, and two "
            "or eight rigid wires or eight elastic ones of ±3 %. All called from Python, turn by turn in one process "
            "on one core; median seconds. Distortion (ARAP energy over area) and lengths as in the results of "
            "`wirewarp`: the worst relative error of a whole wire or stretch of outline, and of a single edge of "
            "them, against the lengths that were chosen, for libigl against those on the surface with eight wires.",
            "",
            *tables.peer_table(comparisons),
            "",
            tables.growth_sentence(comparisons),
            "",
            "The runs of the refined method:",
            "",
            *tables.refined_table(comparisons),
            "",
            "Those of WireWarping++ with elastic wires:",
            "",
            *tables.elastic_table(comparisons),
            "",
            "## In Blender",
            "",
            f"Flatten from end to end in Blender {in_blender['blender']}, against Blender's angle-based unwrap of the "
            "same sheet, turn by turn in one process on one core; median seconds. Two rigid wires. Flatten reads "
            "the model, solves, the report included, and writes UV map, flat pieces and maps.",
            "",
            *tables.blender_table(in_blender["runs"]),
            "",
            "## Stage by stage",
            "",
            "Milliseconds of the compiled core; factorizations use two cores. Exponents k: milliseconds grow as "
            "triangles to the power of k, fitted from 10,000 to 1,000,000. Peak resident memory of the process, the "
            "mesh included. First the refined method, whose `shape` is all from the free ARAP start on:",
            "",
            *tables.stage_table(benchmarks, "refine_sheet"),
            "",
            "Then WireWarping++, whose `lengths` solves Eq. (1), with elastic wires also the free ARAP start and all "
            "evaluations of the shape error E(ψ(h)) with their gradients:",
            "",
            *tables.stage_table(benchmarks, "warp_sheet"),
            "",
            "Parts of these measured alone, milliseconds at three numbers of triangles:",
            "",
            *tables.part_table(benchmarks),
            "",
            "## The gradient",
            "",
            "One evaluation of E(ψ(h)) and its gradient by all h. The gradient takes one factorization of Eq. (1) and "
            "one transposed solve of the interior placement, however many wires there are. The sheet is shallow here "
            "(`native/bench/bench_gradient.cpp`), so that an evaluation takes as few factorizations as it can: the "
            "least favorable ratio.",
            "",
            *tables.gradient_table(benchmarks),
            "",
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native_json", type=Path, help="what wirewarp_bench --benchmark_out=FILE wrote")
    parser.add_argument("blender_json", type=Path, help="what flatten_in_blender.py wrote")
    parser.add_argument("--triangles", type=int, nargs="+", default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "benchmarks.md")
    arguments = parser.parse_args()

    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    comparisons = [compare(triangles) for triangles in arguments.triangles]
    benchmarks = json.loads(arguments.native_json.read_text())["benchmarks"]
    in_blender = json.loads(arguments.blender_json.read_text())
    arguments.output.write_text(document(benchmarks, in_blender, comparisons), encoding="utf-8")
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
