# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a page and its pictures from measurements; docs/benchmarks.md is the page of the longest run:

PYTHONPATH=results python bench/write_page.py NATIVE_JSON BLENDER_JSON PEERS_JSON RATIOS_MD PAGE [--real-meshes JSON]
"""

import argparse
import json
from pathlib import Path

import peer_tables
import tables
from compare_peers import JITTER, LARGEST, load
from comparison import Comparison
from libigl_maps import ITERATIONS, MOST_ITERATIONS, STILL
from machine import machine
from palette import use_style
from plots import plot_lengths, plot_times
from targets import nearest, target_table
from which_commit import commit

NO_REAL_MESHES = "They were not available in this run (`WIREWARP_MESHES` names their folder)."


def peers_section(sheets: list[Comparison]) -> list[str]:
    return [
        "## Against other flatteners",
        "",
        "All methods run on the same surface in turn, on one core, each turn in its own process. The table has CPU "
        "seconds (medians; also as multiples of libigl's ARAP) and the peak memory that a method adds to a process "
        "with the surface. **WireWarp**: the outline and two or eight wires rigid, or eight wires elastic by ±3%. "
        f"**libigl** as a Python package: harmonic start, then {ITERATIONS} iterations of ARAP or of SLIM (symmetric "
        f"Dirichlet energy); it counts as converged if ten iterations move no vertex by more than {STILL:g} of the "
        "width, or "
        f"after {MOST_ITERATIONS:,}. **Blender** 4.5 as a Python module: its own three unwraps, scaled to the area of "
        "the surface.",
        "",
        "`wirewarp.measure` measures all of them. Energy: ARAP energy over area. Worst outline, wire and edge of both: "
        "relative errors from the target lengths. libigl and Blender have no targets, so their lengths are compared "
        "with those of the outline and eight wires on the surface.",
        "",
        *peer_tables.peer_table(sheets),
        "",
        f"Without `--full`, {', '.join(f'{name} (to {size:,})' for name, size in LARGEST.items())} do not run on the "
        "larger sheets.",
        "",
        "![Seconds against triangles for every method](benchmarks/times.png)",
        "",
        "The exponents are for 10,000 or more triangles. The picture below shows the cost of exact lengths at 10,000 "
        "triangles: methods that keep lengths are on the left, the others on the right.",
        "",
        "![Distortion against the worst length error for every method](benchmarks/lengths.png)",
        "",
        "The runs of the refined method:",
        "",
        *peer_tables.refined_table(sheets),
        "",
        "The runs of WireWarping++ with elastic wires:",
        "",
        *peer_tables.elastic_table(sheets),
        "",
    ]


def hard_section(hard: list[Comparison]) -> list[str]:
    return [
        "## Jittered sheets and many wires",
        "",
        "The refined method with wires elastic by ±3%, eight if no other number is given. *Jittered* means that each "
        f"inner vertex is moved on the surface by up to {JITTER:g} of an edge in each direction, even on wires. The "
        "table has CPU seconds, also as multiples of libigl's ARAP on the same mesh.",
        "",
        *peer_tables.hard_table(hard),
        "",
    ]


def ratios_section(ratios: str) -> list[str]:
    return [
        "## Runs that cost more",
        "",
        "Runs of the core with many wires, a fabric, elastic seams or a cache, compared with plain runs on the same "
        "sheet in the same process. The table has medians of processor seconds, and their ratio. The last row is the "
        "time until a net without a solution is refused. Written by `wirewarp_cost_ratios`.",
        "",
        *ratios.splitlines(),
        "",
    ]


def seams_section(seams: Comparison) -> list[str]:
    return [
        "## Two pieces and a seam",
        "",
        f"The sheet is 500 mm wide, has {seams.triangles:,} triangles and is cut in two along a straight row of edges. "
        "The last column is the difference in length between the two sides of the seam, in millimeters. A sewist "
        "must ease in this difference or cut it off.",
        "",
        *peer_tables.seam_table(seams),
        "",
    ]


def blender_section(in_blender: dict) -> list[str]:
    return [
        "## In Blender",
        "",
        f"Flatten from end to end in Blender {in_blender['blender']}, compared with Blender's angle-based unwrap "
        "of the same sheet, in turn in one process on one core. The sheet has two rigid wires, and the table has "
        "median seconds. Flatten reads the model, solves it, makes the report, and writes the UV map, the flat pieces "
        "and the maps.",
        "",
        *tables.blender_table(in_blender["runs"]),
        "",
    ]


def stages_section(benchmarks: list[dict]) -> list[str]:
    sizes = [run["triangles"] for run in tables.select(benchmarks, "refine_sheet")]
    return [
        "## Stage by stage",
        "",
        "The tables have milliseconds of the compiled core; factorizations use two cores. Exponents k: milliseconds "
        "grow as "
        f"triangles to the power of k, fitted from {min(sizes):,} to {max(sizes):,}. Memory is the peak resident "
        "memory of the process, including the mesh. First the refined method, whose `shape` includes everything "
        "after the free ARAP "
        "start:",
        "",
        *tables.stage_table(benchmarks, "refine_sheet"),
        "",
        "Then WireWarping++. Its stage `lengths` solves Eq. (1). With elastic wires, it also includes the free ARAP "
        "start and all evaluations of the shape error E(ψ(h)) with their gradients:",
        "",
        *tables.stage_table(benchmarks, "warp_sheet"),
        "",
        "Parts of these, measured alone, in milliseconds by the number of triangles:",
        "",
        *tables.part_table(benchmarks),
        "",
    ]


def gradient_section(benchmarks: list[dict]) -> list[str]:
    return [
        "## The gradient",
        "",
        "One evaluation of E(ψ(h)) and its gradient with respect to all h. The gradient takes one factorization of "
        "Eq. (1) and one transposed solve of the interior placement, however many wires there are. The sheet is "
        "shallow here (`native/bench/bench_gradient.cpp`), so that an evaluation needs as few factorizations as "
        "possible. This is the least favorable ratio.",
        "",
        *tables.gradient_table(benchmarks),
        "",
    ]


def real_section(counts: dict | None) -> list[str]:
    head = ["## Real meshes", ""]
    if counts is None:
        return [*head, NO_REAL_MESHES, ""]
    answers = ", ".join(f"{count} {outcome}" for outcome, count in counts["outcomes"].items())
    return [
        *head,
        f"The same comparison on {counts['panels']} panels of garments and covers, and on {counts['files']} unchanged "
        "mesh files found on the web, each in its own process for at most a minute: "
        f"{answers}. The meshes are not ours to publish, nor tables made from them: `./dev bench` writes them to "
        "`build/bench/real_meshes.md`.",
        "",
    ]


def document(
    benchmarks: list[dict], in_blender: dict, peers: dict[str, list[Comparison]], ratios: str, real: dict | None
) -> str:
    sheets, (seams,) = peers["sheets"], peers["seams"]
    lines = [
        "# Benchmarks",
        "",
        "Written by `./dev bench --full`; `./dev bench` leaves out the largest sizes and writes to `build/bench/`. The "
        "surface is a smoothly bent square sheet of even quads (`native/bench/bumpy_sheet.h`), with straight wires "
        "across it, half of them in each direction.",
        "",
        f"Machine: {machine()}. Commit: {commit()}.",
        "",
        "## Performance targets",
        "",
        "Ratios are of CPU seconds on one core; seconds and exponents of the core itself are wall time, on two "
        "cores if available.",
        "",
        *target_table(sheets, peers["hard"], benchmarks),
        "",
        *peers_section(sheets),
        *hard_section(peers["hard"]),
        *ratios_section(ratios),
        *seams_section(seams),
        *real_section(real),
        *blender_section(in_blender),
        *stages_section(benchmarks),
        *gradient_section(benchmarks),
    ]
    return "\n".join(lines).rstrip() + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native_json", type=Path, help="what wirewarp_bench --benchmark_out=FILE wrote")
    parser.add_argument("blender_json", type=Path, help="what flatten_in_blender.py wrote")
    parser.add_argument("peers_json", type=Path, help="what compare_peers.py wrote")
    parser.add_argument("ratios_md", type=Path, help="what wirewarp_cost_ratios printed")
    parser.add_argument("page", type=Path, help="to write; its pictures go into the folder beside it of its name")
    parser.add_argument("--real-meshes", type=Path, help="what real_meshes.py wrote")
    arguments = parser.parse_args()

    benchmarks = json.loads(arguments.native_json.read_text())["benchmarks"]
    in_blender = json.loads(arguments.blender_json.read_text())
    peers = load(arguments.peers_json)
    real = json.loads(arguments.real_meshes.read_text()) if arguments.real_meshes else None
    ratios = arguments.ratios_md.read_text()
    page = document(benchmarks, in_blender, peers, ratios, real)  # before the pictures change the result of commit()
    use_style()
    pictures = arguments.page.with_suffix("")
    pictures.mkdir(parents=True, exist_ok=True)
    plot_times(peers["sheets"], pictures / "times.png")
    plot_lengths(nearest(peers["sheets"], 10_000) or peers["sheets"][-1], pictures / "lengths.png")
    arguments.page.write_text(page, encoding="utf-8")
    print(f"wrote {arguments.page}")


if __name__ == "__main__":
    main()
