# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a page and its pictures from measurements:

PYTHONPATH=results python bench/write_page.py NATIVE_JSON BLENDER_JSON PEERS_JSON RATIOS_MD PAGE [--real-meshes JSON]

./dev bench --full runs this program to write docs/benchmarks.md.
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

NO_REAL_MESHES = "No real meshes were available in this run. `WIREWARP_MESHES` names the folder for them."


def peers_section(sheets: list[Comparison]) -> list[str]:
    return [
        "## Against other flatteners",
        "",
        "All methods run on the same surface in turn, on one core, each turn in its own process. The table has CPU "
        "seconds (medians, also as multiples of libigl's ARAP) and the peak memory that a method adds to a process "
        "with the surface.",
        "",
        "- **WireWarp** keeps the outline, and has two or eight rigid wires, or eight wires elastic by ±3%.",
        f"- **libigl** as a Python package starts from the harmonic map, and runs {ITERATIONS} iterations of ARAP or "
        "of SLIM (symmetric Dirichlet energy). A *converged* run ends if ten iterations move no vertex by more than "
        f"{STILL:g} of the width, or after {MOST_ITERATIONS:,} iterations.",
        "- **Blender** 4.5 as a Python module runs its own three unwraps, scaled to the area of the surface.",
        "",
        "`wirewarp.measure` measures all results. *Energy* is the ARAP energy over the area. *Worst outline*, *wire* "
        "and *edge* are the largest errors of a section of the outline, of a wire, and of an edge of either. They are "
        "relative to the target length. libigl and Blender have no targets, so their lengths are compared with the "
        "lengths of the outline and of eight wires on the surface.",
        "",
        *peer_tables.peer_table(sheets),
        "",
        "Without `--full`, these methods run only on sheets up to the number of triangles in brackets: "
        f"{', '.join(f'{name} ({size:,})' for name, size in LARGEST.items())}.",
        "",
        "![Seconds against triangles for every method](benchmarks/times.png)",
        "",
        "The exponents of growth in this picture are for 10,000 or more triangles. The next picture shows the cost of "
        "exact lengths at 10,000 triangles. Methods that keep lengths are on the left, and the others are on the "
        "right.",
        "",
        "![Distortion against the worst length error for every method](benchmarks/lengths.png)",
        "",
        "This is the work of the refined method:",
        "",
        *peer_tables.refined_table(sheets),
        "",
        "This is the work of WireWarping++ with elastic wires:",
        "",
        *peer_tables.elastic_table(sheets),
        "",
    ]


def hard_section(hard: list[Comparison]) -> list[str]:
    return [
        "## Jittered sheets and many wires",
        "",
        "The table is for the refined method with wires elastic by ±3%, eight if no other number is given. *Jittered* "
        f"means that each inner vertex was moved on the surface by up to {JITTER:g} of an edge in each direction, even "
        "on wires. The table has CPU seconds, also as multiples of libigl's ARAP on the same mesh.",
        "",
        *peer_tables.hard_table(hard),
        "",
    ]


def ratios_section(ratios: str) -> list[str]:
    return [
        "## Runs that cost more",
        "",
        "The program `wirewarp_cost_ratios` runs the core with many wires, a fabric, elastic seams or a cache. It "
        "compares these runs with plain runs on the same sheet in the same process. The table has medians of CPU "
        "seconds, and their ratio. The last row is the time until a net of rigid wires without a solution is refused.",
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
        f"The table compares a whole run of Flatten in Blender {in_blender['blender']} with Blender's angle-based "
        "unwrap of the same sheet, in turn in one process on one core. The sheet has two rigid wires, and the table "
        "has median seconds. Flatten reads the model, solves it, makes the report, and writes the UV map, the flat "
        "pieces and the maps.",
        "",
        *tables.blender_table(in_blender["runs"]),
        "",
    ]


def stages_section(benchmarks: list[dict]) -> list[str]:
    sizes = [run["triangles"] for run in tables.select(benchmarks, "refine_sheet")]
    return [
        "## Stage by stage",
        "",
        "The tables have milliseconds of the compiled core. Factorizations use two cores. The time grows as the number "
        f"of triangles to the power of the exponent, fitted from {min(sizes):,} to {max(sizes):,} triangles. Memory is "
        "the peak resident memory of the process, including the mesh. The first table is for the refined method, whose "
        "stage `shape` includes everything after the free ARAP start:",
        "",
        *tables.stage_table(benchmarks, "refine_sheet"),
        "",
        "The next table is for WireWarping++, whose stage `lengths` solves Eq. (1). With elastic wires, this stage "
        "also includes the free ARAP start and all evaluations of the shape error E(ψ(h)) with their gradients:",
        "",
        *tables.stage_table(benchmarks, "warp_sheet"),
        "",
        "Some parts of these stages were measured alone, in milliseconds by the number of triangles:",
        "",
        *tables.part_table(benchmarks),
        "",
    ]


def gradient_section(benchmarks: list[dict]) -> list[str]:
    return [
        "## The gradient",
        "",
        "The table has the times of one evaluation of E(ψ(h)), and of its gradient with respect to all h. For any "
        "number of wires, the gradient needs one factorization of Eq. (1) and one transposed solve of the interior "
        "placement. The sheet is shallow (`native/bench/bench_gradient.cpp`), so that an evaluation needs as few "
        "factorizations as possible. For other sheets, the ratio is therefore smaller.",
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
        f"The same methods flattened {counts['panels']} panels of garments and covers. WireWarp also flattened "
        f"{counts['files']} unchanged mesh files from the web, each in its own process for at most a minute: "
        f"{answers}. We may not publish the meshes and the tables made from them. `./dev bench` writes the tables to "
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
        "`./dev bench --full` writes this page. `./dev bench` leaves out the largest sizes and writes to "
        "`build/bench/`. The surface is a smoothly bent square sheet of even quads (`native/bench/bumpy_sheet.h`), "
        "with straight wires across it, half of them in each direction.",
        "",
        f"Machine: {machine()}. Commit: {commit()}.",
        "",
        "## Performance targets",
        "",
        "Times relative to other methods are ratios of CPU seconds on one core. Seconds and exponents of WireWarp "
        "alone are wall time, on two cores if available.",
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
    parser.add_argument("native_json", type=Path, help="output of wirewarp_bench --benchmark_out=FILE")
    parser.add_argument("blender_json", type=Path, help="output of flatten_in_blender.py")
    parser.add_argument("peers_json", type=Path, help="output of compare_peers.py")
    parser.add_argument("ratios_md", type=Path, help="output of wirewarp_cost_ratios")
    parser.add_argument("page", type=Path, help="page to write; its pictures are written to the folder with its name")
    parser.add_argument("--real-meshes", type=Path, help="output of real_meshes.py")
    arguments = parser.parse_args()

    benchmarks = json.loads(arguments.native_json.read_text())["benchmarks"]
    in_blender = json.loads(arguments.blender_json.read_text())
    peers = load(arguments.peers_json)
    real = json.loads(arguments.real_meshes.read_text()) if arguments.real_meshes else None
    ratios = arguments.ratios_md.read_text()
    # The text is made first, because new pictures would mark the commit as changed.
    page = document(benchmarks, in_blender, peers, ratios, real)
    use_style()
    pictures = arguments.page.with_suffix("")
    pictures.mkdir(parents=True, exist_ok=True)
    plot_times(peers["sheets"], pictures / "times.png")
    plot_lengths(nearest(peers["sheets"], 10_000) or peers["sheets"][-1], pictures / "lengths.png")
    arguments.page.write_text(page, encoding="utf-8")
    print(f"wrote {arguments.page}")


if __name__ == "__main__":
    main()
