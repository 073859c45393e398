# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs ./dev bench: measures time and memory of the core, Blender and other flatteners, and writes a page with them."""

import os
from pathlib import Path

from tools.blender import BLENDER_APT, BPY_APT, NUMPY, bpy_python, run_with_addon
from tools.environment import BUILD, DEBIAN_VERSION, ROOT, output_of, require_apt, run, say
from tools.native import CORE_APT, build_native
from tools.package import venv_with_core

APT = (*CORE_APT, *BLENDER_APT, *BPY_APT, "libbenchmark-dev")
PACKAGES = (NUMPY[DEBIAN_VERSION], "libigl==2.6.3", "matplotlib==3.10.9")
PEER = "bpy==4.5.15"  # version of Blender whose unwraps are compared
FOLDER = BUILD / "bench"
SHARED = {"PYTHONPATH": str(ROOT / "results")}  # bench/ uses modules of results/, too
NOT_THE_LARGEST = "--benchmark_filter=-triangles:1000000"


def measure_the_core(is_full: bool) -> Path:
    output = FOLDER / "native.json"
    options = [] if is_full else [NOT_THE_LARGEST]
    run([FOLDER / "wirewarp_bench", f"--benchmark_out={output}", "--benchmark_out_format=json", *options])
    return output


def measure_ratios() -> Path:
    output = FOLDER / "ratios.md"
    output.write_text(output_of([FOLDER / "wirewarp_cost_ratios"]))
    return output


def measure_in_blender() -> Path:
    output = FOLDER / "blender.json"
    run_with_addon("bench", ROOT / "bench" / "flatten_in_blender.py", output)
    return output


def measure_peers(python: Path, is_full: bool) -> Path:
    output = FOLDER / "peers.json"
    options = ["--full"] if is_full else []
    run([python, "bench/compare_peers.py", output, *options], WIREWARP_BPY_PYTHON=str(bpy_python(PEER)), **SHARED)
    return output


def measure_real_meshes(python: Path) -> list[str | Path]:
    """Measure the meshes in the folder that WIREWARP_MESHES names, if any. Return options for write_page.py."""
    folder = os.environ.get("WIREWARP_MESHES")
    if not folder:
        say("real meshes are NOT MEASURED: WIREWARP_MESHES names no folder")
        return []
    page, counts = FOLDER / "real_meshes.md", FOLDER / "real_meshes.json"
    run([python, "bench/real_meshes.py", folder, page, counts], WIREWARP_BPY_PYTHON=str(bpy_python(PEER)), **SHARED)
    return ["--real-meshes", counts]


def run_bench(is_full: bool) -> None:
    """Run the benchmarks. Only the full run replaces the page in docs/."""
    require_apt(*APT)
    build_native("bench")
    python = venv_with_core("bench", DEBIAN_VERSION, *PACKAGES)
    measured = [measure_the_core(is_full), measure_in_blender(), measure_peers(python, is_full), measure_ratios()]
    real = measure_real_meshes(python)
    page = ROOT / "docs" / "benchmarks.md" if is_full else FOLDER / "benchmarks.md"
    run([python, "bench/write_page.py", *measured, page, *real], **SHARED)
