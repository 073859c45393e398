# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the benchmark sheet by every method in every size, and writes the results as JSON:

PYTHONPATH=results WIREWARP_BPY_PYTHON=PYTHON python bench/compare_peers.py OUTPUT.json [--full]
    [--sizes N ...] [--rounds N]

PYTHON is a Python with the module bpy.
"""

import argparse
import json
import os
from dataclasses import asdict
from pathlib import Path

import flatteners
from comparison import Comparison, Outcome, compare
from surfaces import bumpy_sheet

SIZES, FULL_SIZES = [1_000, 10_000, 100_000], [1_000, 10_000, 100_000, 1_000_000]
SEAM_SIZE = 10_000
JITTER = 0.3  # share of an edge; with it, sheets are about as uneven as scanned and sculpted models
JITTERED_SIZES = [10_000, 100_000]
NET_SIZE, NETS = 40_000, [8, 32, 128]  # triangles; numbers of wires (128 wires are 2.2 edges apart)
LIMIT, FULL_LIMIT = 120.0, 900.0  # seconds of wall time for one method on one surface
LARGEST = {  # maximum number of triangles for methods that would otherwise take longer than all other methods together
    flatteners.ARAP_CONVERGED: 100_000,
    flatteners.SLIM: 100_000,
    flatteners.SLIM_CONVERGED: 10_000,
    flatteners.ANGLE_BASED: 10_000,
    flatteners.CONFORMAL: 10_000,
    flatteners.MINIMUM_STRETCH: 10_000,
}
FULL_LARGEST = {flatteners.SLIM: 100_000, flatteners.SLIM_CONVERGED: 100_000, flatteners.MINIMUM_STRETCH: 100_000}


def rounds_of(triangles: int) -> int:
    return 5 if triangles <= 10_000 else 3 if triangles <= 100_000 else 1


def compare_at(triangles: int, is_full: bool, rounds: int | None) -> Comparison:
    largest = FULL_LARGEST if is_full else LARGEST
    names = [name for name in flatteners.METHODS if triangles <= largest.get(name, triangles)]
    limit = FULL_LIMIT if is_full else LIMIT
    print(f"{triangles:,} triangles by {len(names)} methods", flush=True)
    return compare(bumpy_sheet(triangles), names, rounds or rounds_of(triangles), limit)


def compare_seams() -> Comparison:
    return compare(bumpy_sheet(SEAM_SIZE, in_two_pieces=True), list(flatteners.METHODS), 1, LIMIT)


def compare_hard(rounds: int | None) -> list[Comparison]:
    """Compare the refined method with ARAP, in turn, on jittered sheets and on sheets with many wires."""
    jittered = [bumpy_sheet(size, jitter=JITTER, wires=wires) for size in JITTERED_SIZES for wires in (2, 8)]
    nets = [bumpy_sheet(NET_SIZE, wires=wires) for wires in NETS]
    names = [flatteners.REFINED_ELASTIC, flatteners.ARAP]
    return [compare(s, names, rounds or rounds_of(len(s.faces)), LIMIT) for s in (*jittered, *nets)]


def load(path: Path) -> dict[str, list[Comparison]]:
    """Return what main() has written: "sheets" in all sizes, "hard" sheets, and "seams" of the sheet in two pieces."""
    found = json.loads(path.read_text())
    return {key: [from_dict(comparison) for comparison in comparisons] for key, comparisons in found.items()}


def from_dict(comparison: dict) -> Comparison:
    outcomes = {name: Outcome(**outcome) for name, outcome in comparison["outcomes"].items()}
    return Comparison(**comparison | {"outcomes": outcomes})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--full", action="store_true", help="up to 1,000,000 triangles; larger sheets for slow methods")
    parser.add_argument("--sizes", type=int, nargs="+", help="numbers of triangles, instead of the usual ones")
    parser.add_argument("--rounds", type=int, help="number of rounds, instead of the usual ones")
    arguments = parser.parse_args()

    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    sizes = arguments.sizes or (FULL_SIZES if arguments.full else SIZES)
    found = {
        "sheets": [compare_at(triangles, arguments.full, arguments.rounds) for triangles in sizes],
        "hard": compare_hard(arguments.rounds),
        "seams": [compare_seams()],
    }
    text = json.dumps({key: [asdict(c) for c in comparisons] for key, comparisons in found.items()}, indent=1)
    arguments.output.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
