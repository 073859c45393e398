# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens panels of real garments by every method, and each mesh file of a folder by WireWarp:

PYTHONPATH=results WIREWARP_BPY_PYTHON=PYTHON python bench/real_meshes.py FOLDER OUTPUT.md COUNTS.json [--panels N]

PYTHON is a Python with the module bpy. FOLDER and its subfolders contain the mesh files. FOLDER/_panels contains the
panels, with wires in NAME.wires.json beside NAME.obj. OUTPUT is not published. COUNTS, from which docs/benchmarks.md is
written, only contains numbers: of panels, of files, and of files with each outcome.
"""

import argparse
import json
import os
import time
from collections import Counter
from pathlib import Path

import flatteners
import numpy as np
import wirewarp
from comparison import Comparison, compare
from machine import machine
from mesh_files import READERS, read_mesh
from peer_tables import peer_table
from run_apart import NoAnswerError, run_apart
from surfaces import Surface
from tables import table
from which_commit import commit

LIMIT = 60.0  # seconds for a mesh, or for a method on a panel
MESH_SUFFIXES = (*READERS, ".dae", ".dxf")


def read_panel(path: Path) -> Surface:
    vertices, faces = read_mesh(path)
    listed = path.with_suffix(".wires.json")
    wires = json.loads(listed.read_text())["wires"] if listed.exists() else []
    chains = [np.array(wire["vertices"]) for wire in wires]
    no_seams = np.zeros((0, 2), dtype=int)
    return Surface(path.stem, vertices, faces, no_seams, [np.arange(len(faces))], chains, chains)


def compare_panel(path: Path) -> Comparison:
    """Compare the methods on a panel. All methods use all wires, even methods that use only two wires on the sheet."""
    names = [name for name in flatteners.METHODS if name != flatteners.REFINED]
    return compare(read_panel(path), names, 1, LIMIT)


def flattening_outcome(path: Path) -> tuple[str, str]:
    """Return a short outcome for counting, and a sentence with the number of pieces or the first error."""
    vertices, faces = read_mesh(path)
    try:
        pieces = wirewarp.flatten(vertices, faces).pieces
    except wirewarp.FlattenError as error:
        return "refused by a sentence", f"{error.code}: {error.message}"
    errors = [piece.error for piece in pieces if piece.error]
    if not errors:
        return "flattened", f"{len(pieces)} pieces"
    outcome = "refused by a sentence" if len(errors) == len(pieces) else "flattened except for some pieces"
    return outcome, f"{len(errors)} of {len(pieces)} pieces, the first: {errors[0].code}: {errors[0].message}"


def outcome_of(path: Path) -> tuple[str, str, str]:
    """Return the outcome of flattening_outcome(), the wall time in seconds, and the sentence."""
    if path.suffix.lower() not in READERS:
        return "in a format that the benchmark does not read", "", ""
    begin = time.monotonic()
    try:
        outcome, sentence = run_apart(lambda: flattening_outcome(path), LIMIT)
    except NoAnswerError as reason:
        outcome, sentence = "**without an answer**", str(reason)
    return outcome, f"{time.monotonic() - begin:.2f}", sentence


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("counts", type=Path)
    parser.add_argument("--panels", type=int, help="number of panels, for a shorter run")
    arguments = parser.parse_args()

    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    panels = [compare_panel(path) for path in sorted(arguments.folder.glob("_panels/*.obj"))[: arguments.panels]]
    paths = sorted(path for path in arguments.folder.rglob("*") if path.suffix.lower() in MESH_SUFFIXES)
    outcomes = [(str(path.relative_to(arguments.folder)), *outcome_of(path)) for path in paths]
    lines = [
        "# Real meshes",
        "",
        f"Machine: {machine()}. Commit: {commit()}. Columns as in docs/benchmarks.md.",
        "",
        "## Panels",
        "",
        "Every method with all wires of a panel, rigid or elastic as its name says.",
        "",
        *peer_table(panels, first="mesh"),
        "",
        "## Every file as it is",
        "",
        *table(["mesh", "outcome", "seconds", "what is said"], outcomes),
        "",
    ]
    arguments.output.write_text("\n".join(lines), encoding="utf-8")
    counts = Counter(outcome for _, outcome, *_ in outcomes)
    found = {"panels": len(panels), "files": len(outcomes), "outcomes": dict(counts.most_common())}
    arguments.counts.write_text(json.dumps(found, indent=1), encoding="utf-8")
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
