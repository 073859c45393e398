# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how much shorter OptCuts' cuts are because their sides need not be equally long, and prints two tables:

PYTHONPATH=results python bench/price_of_exactness.py [--most-triangles N] [--most-triangles-for-bounds N]

Surfaces are flattened along OptCuts' cuts with exact lengths, and with elastic seams. OptCuts' cuts for smaller bounds
on the energy are longer. Some of these cuts keep the energy below BOUND with exact lengths. The price of exactness is
the length of the shortest of them, divided by the length of OptCuts' cuts for BOUND. The second table has the lengths
of both programs' cuts for BOUND and for smaller bounds. Environment variables: as for compare_cuts.py. This program
uses and extends the results of compare_cuts.py.
"""

import argparse
import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

import wirewarp
from compare_cuts import folder_of, ours, theirs
from cut_measures import CutFigures, cuts_of, measure_cuts, read_corner_uv
from least_energy import least_energy
from mesh_files import read_obj
from optcuts import BOUND, by_size
from tables import table

TOLERANCE = 0.03  # tolerance of elastic seams; each edge is a wire of its own, so that a seam has the most freedom
# OptCuts gets these bounds in this order, until a flattening with exact lengths has an energy of at most BOUND.
TIGHTER = (BOUND, 4.08, 4.065, 4.05, 4.035, 4.02)
BOUNDS = (BOUND, 4.05, 4.02)  # bounds of the second table


@dataclass(frozen=True)
class Flat:
    """A flattening along cuts of OptCuts, with exact lengths or with elastic seams."""

    energy: float
    least: float  # energy after least_energy(), which moves the inner vertices and keeps the outlines
    overlaps: bool


def flatten(shape: Path) -> list[Flat | None]:
    """Return two results, with exact lengths and with elastic seams. A result is None if a piece has no flat shape."""
    vertices, faces = read_obj(shape)
    cuts, _, _ = cuts_of(faces, read_corner_uv(shape))
    found: list[Flat | None] = []
    for wires in ([], [wirewarp.Wire(edge, tolerance=TOLERANCE) for edge in cuts]):
        flat = wirewarp.flatten(vertices, faces, seams=cuts, wires=wires)
        faults = {piece.error.code for piece in flat.pieces if piece.error}
        if faults - {wirewarp.ErrorCode.overlapping_faces}:
            found.append(None)
            continue
        both = (flat.corner_uv, least_energy(vertices, faces, flat.corner_uv))
        energies = [measure_cuts(vertices, faces, corner_uv).energy for corner_uv in both]
        found.append(Flat(*energies, bool(faults)))
    return found


def kept_flat(shape: Path) -> list[Flat | None]:
    kept = shape.with_suffix(".flat.json")
    if not kept.exists():
        kept.write_text(json.dumps([flat and asdict(flat) for flat in flatten(shape)]), encoding="utf-8")
    return [flat and Flat(**flat) for flat in json.loads(kept.read_text())]


class Runs:
    """All results for the surfaces. Each is computed when it is first needed."""

    def __init__(self, results: Path, program: Path) -> None:
        self.results, self.program = results, program

    def lengths(self, mesh: Path, bound: float) -> tuple[float | None, float | None]:
        """Return the length of OptCuts' cuts, and the length of WireWarp's cuts."""
        peer = self.peer(mesh, bound)
        own = ours(mesh, self.results, bound).figures
        return peer and peer.length, own and own.length

    def peer(self, mesh: Path, bound: float) -> CutFigures | None:
        return theirs(mesh, self.results, self.program, bound).figures

    def flat(self, mesh: Path, bound: float) -> list[Flat | None]:
        return kept_flat(folder_of(self.results, bound) / mesh.name)

    def lengths_within(self, mesh: Path) -> list[float | None]:
        """Return the lengths of OptCuts' shortest cuts that suffice with exact seams, and with elastic seams.

        Cuts suffice if Flat.least is at most BOUND and no piece overlaps itself.
        """
        found: list[float | None] = [None, None]
        for bound in TIGHTER:
            peer = self.peer(mesh, bound)
            flat = self.flat(mesh, bound) if peer else [None, None]
            enough = [bool(each and not each.overlaps and each.least <= BOUND) for each in flat]
            # Cuts that suffice with exact seams also suffice with elastic seams.
            for i, is_enough in enumerate((enough[0], any(enough))):
                if peer and is_enough and found[i] is None:
                    found[i] = peer.length
            if None not in found:
                break
        return found


def shown(value: float | None, decimals: int) -> str:
    return "–" if value is None else f"{value:.{decimals}f}"


def middle(values: list[float | None], decimals: int) -> str:
    known = [value for value in values if value is not None]
    return f"**{median(known):.{decimals}f}**" if known else "–"


def price_table(meshes: list[Path], runs: Runs) -> list[str]:
    names, columns = [], []
    for mesh in meshes:
        peer = runs.peer(mesh, BOUND)
        if not peer:
            continue
        flat = runs.flat(mesh, BOUND)
        energies = [value for each in flat for value in ((each.energy, each.least) if each else (None, None))]
        exact, elastic = runs.lengths_within(mesh)
        own = runs.lengths(mesh, BOUND)[1]
        prices = [length and length / peer.length for length in (exact, elastic, own)]
        names.append(mesh.stem + (", overlaps" if flat[0] and flat[0].overlaps else ""))
        columns.append([peer.energy, *energies, *prices, own / exact if own and exact else None])
        print(names[-1], columns[-1], flush=True)
    decimals = [3] * 5 + [2] * 4
    rows = [[name, *map(shown, values, decimals)] for name, values in zip(names, columns, strict=True)]
    rows.append(["**median**", *map(middle, map(list, zip(*columns, strict=True)), decimals)])
    limit = f"±{100 * TOLERANCE:.0f}%"
    return table(["mesh", "OptCuts", "exact", "least", limit, "least", "exact", limit, "ours", "ours/exact"], rows)


def lengths_for_bounds(meshes: list[Path], runs: Runs) -> list[str]:
    rows: list[list[str]] = []
    ratios: list[list[float | None]] = []
    for mesh in meshes:
        lengths = [runs.lengths(mesh, bound) for bound in BOUNDS]
        ratios.append([own / peer if own and peer else None for peer, own in lengths])
        rows.append([mesh.stem, *(shown(value, 2) for both in lengths for value in both)])
        print(" ".join(rows[-1]), flush=True)
    last = [cell for values in zip(*ratios, strict=True) for cell in ("", middle(list(values), 2))]
    rows.append(["**median of ours over theirs**", *last])
    return table(["mesh", *(name for bound in BOUNDS for name in (f"{bound}: OptCuts", "ours"))], rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most-triangles", type=int, help="only surfaces of at most N triangles in the first table")
    parser.add_argument("--most-triangles-for-bounds", type=int, help="the limit N for the second table")
    arguments = parser.parse_args()
    results, program = Path(os.environ["OPTCUTS_RESULTS"]), Path(os.environ["OPTCUTS_PROGRAM"])
    sizes = {mesh: len(read_obj(mesh)[1]) for mesh in by_size(Path(os.environ["OPTCUTS_MESHES"]))}

    def of_at_most(most: int | None) -> list[Path]:
        return [mesh for mesh, size in sizes.items() if most is None or size <= most]

    runs = Runs(results, program)
    priced = price_table(of_at_most(arguments.most_triangles), runs)
    bounded = lengths_for_bounds(of_at_most(arguments.most_triangles_for_bounds), runs)
    print("\n".join([*priced, "", *bounded]))


if __name__ == "__main__":
    main()
