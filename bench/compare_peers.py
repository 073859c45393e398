# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the benchmark sheet with WireWarp and with libigl's ARAP, one after the other on one core, and writes
docs/benchmarks.md: these times and lengths, and the stages of the core from wirewarp_bench's JSON output.

python bench/compare_peers.py NATIVE_JSON [--triangles N ...] [--output FILE]
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

os.environ["IGL_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"  # read when the modules are loaded

import igl
import numpy as np
import wirewarp

ROOT = Path(__file__).resolve().parent.parent
ARAP_ITERATIONS = 10
STAGES = {  # of FlattenResult.seconds
    "charts": "charts",
    "wires": "network",
    "lengths": "inner problem",
    "interior": "interior",
    "packing": "packing",
    "measure": "measure",
    "total": "whole run",
}


@dataclass
class Sheet:
    vertices: np.ndarray  # (n, 3)
    faces: np.ndarray  # (m, 3)
    wires: list[wirewarp.Wire]


def bumpy_sheet(triangles: int, wires: int) -> Sheet:
    """The sheet of native/bench/bumpy_sheet.h."""
    n = round((triangles / 2) ** 0.5)
    side = np.linspace(-1.0, 1.0, n + 1)
    x, y = (c.ravel() for c in np.meshgrid(side, side))
    index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)  # [row, column]
    a, b, c, d = (q.ravel() for q in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]))
    lines = [k * n // (wires // 2 + 1) for k in range(1, wires // 2 + 1)]
    return Sheet(
        vertices=np.column_stack([x, y, 0.3 * np.sin(3.1 * x + 0.4) * np.cos(2.7 * y - 0.3)]),
        faces=np.stack([np.column_stack([a, b, c]), np.column_stack([a, c, d])], axis=1).reshape(-1, 3),
        wires=[wirewarp.Wire(chain) for line in lines for chain in (index[line, :], index[:, line])],
    )


def wirewarp_uv(sheet: Sheet) -> np.ndarray:
    """(m, 3, 2) corner positions, all wires rigid."""
    return wirewarp.flatten(sheet.vertices, sheet.faces, wires=sheet.wires).corner_uv


def libigl_arap_uv(sheet: Sheet) -> np.ndarray:
    """(m, 3, 2) corner positions: harmonic map to a disk of the sheet's area, then local/global iterations."""
    vertices, faces = sheet.vertices, sheet.faces
    boundary = igl.boundary_loop(faces)
    radius = np.sqrt(igl.doublearea(vertices, faces).sum() / 2 / np.pi)
    circle = radius * igl.map_vertices_to_circle(vertices, boundary)
    start = igl.harmonic(vertices, faces, boundary, circle, 1)
    data = igl.ARAPData()
    data.max_iter = ARAP_ITERATIONS
    igl.arap_precomputation(vertices, faces, 2, boundary[:1].astype(np.int32), data)
    return igl.arap_solve(start[boundary[:1]], data, start)[faces]


METHODS: dict[str, Callable[[Sheet], np.ndarray]] = {"WireWarp": wirewarp_uv, "libigl ARAP": libigl_arap_uv}


@dataclass
class Comparison:
    triangles: int
    seconds: dict[str, float]  # of each method, the median of its rounds
    measures: dict[str, wirewarp.FlattenResult]


def compare(triangles: int, wires: int) -> Comparison:
    sheet = bumpy_sheet(triangles, wires)
    rounds = 5 if triangles <= 100_000 else 1
    seconds: dict[str, list[float]] = {name: [] for name in METHODS}
    layouts = {}
    for _ in range(rounds):
        for name, method in METHODS.items():
            begin = time.perf_counter()
            layouts[name] = method(sheet)
            seconds[name].append(time.perf_counter() - begin)
    return Comparison(
        triangles=len(sheet.faces),
        seconds={name: statistics.median(times) for name, times in seconds.items()},
        measures={
            name: wirewarp.measure(sheet.vertices, sheet.faces, uv, wires=sheet.wires) for name, uv in layouts.items()
        },
    )


def peer_rows(comparison: Comparison) -> list[str]:
    rows = []
    for name, result in comparison.measures.items():
        piece = result.pieces[0]
        lines = [*piece.wires, *piece.boundaries]
        length_error = max(abs(line.length_2d / line.length_3d - 1) for line in lines)
        cells = (
            f"{comparison.triangles:,}",
            name,
            f"{comparison.seconds[name]:.3g}",
            f"{comparison.seconds[name] / comparison.seconds['libigl ARAP']:.2f}",
            f"{piece.metrics.arap_energy:.5f}",
            f"{length_error:.1e}",
            f"{piece.metrics.edge_length_variation.max():.1e}",
            str(len(piece.metrics.flipped_faces)),
        )
        rows.append("| " + " | ".join(cells) + " |")
    return rows


def native_rows(native_json: Path) -> list[str]:
    """One row per whole run, one per placement."""
    benchmarks = json.loads(native_json.read_text())["benchmarks"]
    flatten = [b for b in benchmarks if b["name"].startswith("flatten_sheet/")]
    factor = {size_of(b): b for b in benchmarks if b["name"].startswith("placement_factor/")}
    solve = {size_of(b): b for b in benchmarks if b["name"].startswith("placement_solve/")}
    rows = []
    for run in flatten:
        size = size_of(run)
        milliseconds = [run[f"{stage}_ms"] for stage in STAGES]
        milliseconds += [factor[size]["real_time"], solve[size]["real_time"]]
        cells = [f"{int(size[0]):,}", size[1], *(f"{t:,.3g}" for t in milliseconds), f"{run['peak_MB']:,.0f}"]
        rows.append("| " + " | ".join(cells) + " |")
    return rows


def size_of(benchmark: dict[str, str]) -> tuple[str, str]:
    """Triangles and wires, from a name such as flatten_sheet/triangles:10000/wires:2."""
    _, triangles, wires = (part.rpartition(":")[2] for part in benchmark["name"].split("/"))
    return triangles, wires


def machine() -> str:
    cpu = next(line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{cpu.partition(':')[2].strip()}, {os.cpu_count()} cores, {memory:.0f} GiB, {platform.system()}"


def commit() -> str:
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty"]
    return subprocess.check_output(command, text=True).strip()


def document(native: list[str], peers: list[str]) -> str:
    return "\n".join(
        [
            "# Benchmarks",
            "",
            "Written by `./dev bench`. The surface is a smoothly bent square sheet of even quads "
            "(`native/bench/bumpy_sheet.h`), with straight rigid wires across it, half of them in each direction.",
            "",
            f"Machine: {machine()}. Commit: {commit()}.",
            "",
            "## Stage by stage",
            "",
            "Milliseconds of the compiled core on one thread; `interior` is factoring and one placement, the columns "
            "factor and place are the same measured alone. Peak resident memory of the process, the mesh included.",
            "",
            "| triangles | wires | " + " | ".join(STAGES.values()) + " | factor | place | peak MB |",
            "|" + "--:|" * (len(STAGES) + 5),
            *native,
            "",
            "## Against libigl's ARAP",
            "",
            f"libigl from PyPI: harmonic start, {ARAP_ITERATIONS} iterations, and no line keeps its length. WireWarp: "
            "outline and two wires rigid. Both called from Python, turn by turn in one process on one core; median "
            "seconds. Distortion (ARAP energy over area) and lengths by `wirewarp.measure`: the worst relative error "
            "of a whole wire or stretch of outline, and of a single edge of them.",
            "",
            "| triangles | method | seconds | of libigl's | energy | worst line | worst edge | flipped |",
            "|--:|:--|--:|--:|--:|--:|--:|--:|",
            *peers,
            "",
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("native_json", type=Path, help="what wirewarp_bench --benchmark_out=FILE wrote")
    parser.add_argument("--triangles", type=int, nargs="+", default=[10_000, 100_000, 1_000_000])
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "benchmarks.md")
    arguments = parser.parse_args()

    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    peers = [row for triangles in arguments.triangles for row in peer_rows(compare(triangles, wires=2))]
    arguments.output.write_text(document(native_rows(arguments.native_json), peers), encoding="utf-8")
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
