# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares cuts of the same surfaces by OptCuts and WireWarp at equal distortion, and writes the page about them:

PYTHONPATH=results python bench/compare_cuts.py PAGE [--most-triangles N]

Environment: OPTCUTS_MESHES is a folder of OBJ files. OPTCUTS_PROGRAM is the executable built from OptCuts' public
sources. OPTCUTS_RESULTS is a folder that keeps every result of both programs, so that no result is computed twice.
"""

import argparse
import json
import os
import resource
import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

import numpy as np
import wirewarp
from cut_measures import CutFigures, measure_cuts, read_corner_uv
from machine import machine
from mesh_files import read_obj
from optcuts import BOUND, LIMIT, by_size, command, kept_run, limit_processor_time
from run_apart import NoAnswerError, run_apart
from tables import table
from text import wrap
from which_commit import commit

TARGETS = (0.5, 0.25, 0.1, 0.05)  # strains: from about what OptCuts leaves, 0.5, to the default of cut sets, 0.05
LADDER = 60  # largest number of proposed sets for a target, enough for all sets
# Number of the shortest sets to which darts are added. On the mesh caesar1, the third set gave the shortest cuts.
FEWEST = 5
SHARE = 0.5  # share of LIMIT; after this time, no seams are removed, because removal may take minutes for a set
LEAST_LIMIT = 0.2  # first limit of strain while seams are removed: the maximum stretch of plush
LARGE_STEP, SMALL_STEP = 0.1, 0.02  # first and least increase of the limit of strain; large steps save time
MOST_LIMIT = 1.2  # largest limit of strain; OptCuts leaves about 0.5
DARTS = 20  # maximum number of darts: half the largest number of cuts in a set
CHOICE = 5  # number of proposed darts, the default of propose_darts()
KEPT = "\n## The price of exactness\n"  # heading of the first section that this program keeps, with all sections below
CLOCK_LIMIT = 10 * LIMIT  # seconds of wall time; more than LIMIT, because other processes may use the core


@dataclass(frozen=True)
class Outcome:
    seconds: float  # processor time
    without: str  # reason why there are no figures, or empty
    figures: CutFigures | None
    set_length: float | None = None  # CutFigures.length of the shortest proposed set that keeps the bound


Cuts = tuple[np.ndarray, CutFigures]  # edges, and the figures with them


def flat(vertices: np.ndarray, faces: np.ndarray, seams: np.ndarray) -> CutFigures | None:
    """Return the figures with these seams, or None if a piece has no flat shape or overlaps itself.

    Overlaps are refused because OptCuts allows none.
    """
    flattening = wirewarp.flatten(vertices, faces, seams=seams)
    if any(piece.error or len(piece.metrics.overlapping_faces) for piece in flattening.pieces):
        return None
    return measure_cuts(vertices, faces, flattening.corner_uv)


def cut(vertices: np.ndarray, faces: np.ndarray, bound: float) -> tuple[CutFigures, float | None]:
    """Return the figures of the shortest cuts found with an energy of at most `bound`, and Outcome.set_length."""
    nothing = np.zeros((0, 2), dtype=int)
    uncut = flat(vertices, faces, nothing)
    if uncut and (darts := with_darts(vertices, faces, (nothing, uncut), np.inf, bound)):
        return simplified(vertices, faces, darts, bound), None
    sets = flat_sets(vertices, faces)
    below = [cuts for cuts in sets if cuts[1].energy <= bound]
    set_length = below[0][1].length if below else None
    found = []
    for start in starts(vertices, faces, sets, below, bound):
        found.append(simplified(vertices, faces, start, bound))
        if is_late():
            break
    if not found:
        raise ValueError(f"with {DARTS} more darts, the energy is still over {bound}")
    return min(found, key=lambda figures: figures.length), set_length


def starts(
    vertices: np.ndarray, faces: np.ndarray, sets: list[Cuts], below: list[Cuts], bound: float
) -> Iterator[Cuts]:
    """Yield cuts with an energy of at most `bound`, the shortest set of `below` first.

    sets: all cut sets, the shortest first
    below: the sets whose energy is at most `bound` without darts
    """
    longest = below[0][1].length if below else np.inf
    yield from below[:1]
    for first in sets[:FEWEST]:
        if darts := with_darts(vertices, faces, first, longest, bound):
            yield darts
    yield from below[1:]


def is_late() -> bool:
    return time.process_time() > SHARE * LIMIT


def simplified(vertices: np.ndarray, faces: np.ndarray, cuts: Cuts, bound: float) -> CutFigures:
    """Remove seams with increasing limits of strain, as long as the energy is at most `bound`. Return the figures."""
    limit, step = LEAST_LIMIT, LARGE_STEP
    while step >= SMALL_STEP and limit <= MOST_LIMIT and not is_late():
        found = wirewarp.simplify_seams(vertices, faces, seams=cuts[0], strain=limit)
        figures = flat(vertices, faces, found.edges)
        if figures and figures.energy <= bound:
            cuts = found.edges, figures
        else:
            limit, step = limit - step, step / 2
        limit += step
    return cuts[1]


def flat_sets(vertices: np.ndarray, faces: np.ndarray) -> list[Cuts]:
    """Return the different cut sets of all targets, the shortest first. With each set, every piece has a flat shape
    without overlaps."""
    sets = {}
    for target in TARGETS:
        for proposal in wirewarp.propose_seams(vertices, faces, strain=target, count=LADDER):
            key = proposal.edges.tobytes()
            if key not in sets and (figures := flat(vertices, faces, proposal.edges)):
                sets[key] = proposal.edges, figures
    if not sets:
        raise ValueError("no cut set is flat without overlaps")
    return sorted(sets.values(), key=lambda cuts: cuts[1].length)


def with_darts(vertices: np.ndarray, faces: np.ndarray, cuts: Cuts, longest: float, bound: float) -> Cuts | None:
    """Return the cuts with the added darts that decrease the energy most for their lengths.

    Returns None if the cuts get as long as `longest`, or if the energy stays above the bound.
    """
    seams, figures = cuts
    for _ in range(DARTS):
        if figures.energy <= bound or figures.length >= longest:
            break
        tried = []
        for dart in propose_darts(vertices, faces, seams):
            together = np.concatenate([seams, dart.edges])
            if after := flat(vertices, faces, together):
                tried.append(((figures.energy - max(after.energy, bound)) / dart.length, together, after))
        if not tried:
            break
        _, seams, figures = max(tried, key=lambda gain_and_cuts: gain_and_cuts[0])
    return (seams, figures) if figures.energy <= bound and figures.length < longest else None


def propose_darts(vertices: np.ndarray, faces: np.ndarray, seams: np.ndarray) -> list[wirewarp.DartProposal]:
    try:
        return wirewarp.propose_darts(vertices, faces, seams=seams, strain=0, count=CHOICE)
    except wirewarp.FlattenError as error:
        if error.code == wirewarp.ErrorCode.no_proposal:
            return []
        raise


def in_limited_time(mesh: Path, bound: float) -> tuple[CutFigures, float | None]:
    limit_processor_time()
    return cut(*read_obj(mesh), bound)


def folder_of(results: Path, bound: float) -> Path:
    folder = results / str(bound)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def ours(mesh: Path, results: Path, bound: float = BOUND) -> Outcome:
    kept = folder_of(results, bound) / f"{mesh.stem}.ours.json"
    if kept.exists():
        stored = json.loads(kept.read_text())
        return Outcome(**stored | {"figures": stored["figures"] and CutFigures(**stored["figures"])})
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    without, figures, set_length = "", None, None
    try:
        figures, set_length = run_apart(lambda: in_limited_time(mesh, bound), CLOCK_LIMIT)
    except NoAnswerError as reason:
        without = str(reason)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    outcome = Outcome(seconds, f"over {LIMIT} s" if without and seconds >= LIMIT else without, figures, set_length)
    kept.write_text(json.dumps(asdict(outcome)), encoding="utf-8")
    return outcome


def theirs(mesh: Path, results: Path, program: Path, bound: float = BOUND) -> Outcome:
    folder = folder_of(results, bound)
    run = kept_run(program, mesh, folder, bound)
    if run.without:
        return Outcome(run.seconds, run.without, None)
    shape = folder / f"{mesh.stem}.obj"
    return Outcome(run.seconds, "", measure_cuts(*read_obj(shape), read_corner_uv(shape)))


def cells(outcome: Outcome) -> list[str]:
    figures = outcome.figures
    if not figures:
        return ["–"] * 5 + [f"{outcome.seconds:,.0f}"]
    return [
        f"{figures.length:.2f}",
        f"{figures.energy:.3f}",
        f"{100 * figures.strain:.0f}%",
        f"{1000 * figures.mismatch:.1f}",
        str(figures.charts),
        f"{outcome.seconds:,.0f}",
    ]


def own_cells(outcome: Outcome) -> list[str]:
    length, *others = cells(outcome)
    return [length, f"{outcome.set_length:.2f}" if outcome.set_length else "–", *others]


def verdict(peer: Outcome, own: Outcome) -> str:
    if not peer.figures and not own.figures:
        return "neither"
    if not own.figures:
        return f"OptCuts; ours: {own.without}"
    if not peer.figures:
        return f"ours; OptCuts: {peer.without}"
    return "ours" if own.figures.length < peer.figures.length else "OptCuts"


def in_brief(rows: list[tuple[Outcome, Outcome]]) -> str:
    """Return a paragraph: how often each program has the shorter cuts, and medians over surfaces that both can cut."""
    both = [(peer, own) for peer, own in rows if peer.figures and own.figures]
    if not both:
        return "No surface was cut by both programs."
    won = sum(own.figures.length < peer.figures.length for peer, own in both)

    def middle(read: str) -> list[float]:
        return [median(getattr(outcome[i].figures, read) for outcome in both) for i in (0, 1)]

    ratio = median(own.figures.length / peer.figures.length for peer, own in both)
    mismatch, strain, charts = middle("mismatch"), middle("strain"), middle("charts")
    seconds = [median(outcome[i].seconds for outcome in both) for i in (0, 1)]
    return f"""Of {len(rows)} surfaces, {len(both)} were cut below the bound within the time by both methods,
{sum(bool(own.figures and not peer.figures) for peer, own in rows)} by WireWarp alone, and
{sum(bool(peer.figures and not own.figures) for peer, own in rows)} by OptCuts alone. Of the {len(both)}, WireWarp has
the shorter cuts on {won} and OptCuts on {len(both) - won}. WireWarp's cuts are {ratio:.2f} times as long as OptCuts' in
the median. These are the other medians:

- difference between the sides of a cut, in mm per m: {1000 * mismatch[0]:.3g} for OptCuts, and
  {1000 * mismatch[1]:.2g} for WireWarp
- strain: {100 * strain[0]:.0f}% for OptCuts, and {100 * strain[1]:.0f}% for WireWarp
- number of charts: {charts[0]:.3g} for OptCuts, and {charts[1]:.3g} for WireWarp
- processor time: {seconds[0]:,.1f} s for OptCuts, and {seconds[1]:,.1f} s for WireWarp"""


def page(
    meshes: list[Path], found: list[tuple[Outcome, Outcome]], all_meshes: int, arguments: argparse.Namespace
) -> str:
    most = arguments.most_triangles
    which = (
        f"Of its {all_meshes} surfaces, this page has the {len(meshes)} with at most {most:,} triangles. The others "
        "were not measured, because the runs would have taken too long."
        if most
        else f"This page has all {all_meshes} of them."
    )
    call = " ".join(command("OptCuts", "MESH", BOUND))
    text = f"""# Cuts beside OptCuts

Written by `bench/compare_cuts.py`, which describes the steps; not part of `./dev bench`. Machine: {machine()}. Commit:
{arguments.commit}.

[OptCuts](https://github.com/liminchen/OptCuts) (Li, Kaufman, Kim, Solomon, Sheffer 2018) finds cuts and flat shape
together. It runs as in its authors' benchmark, with an energy of at most {BOUND} and without overlaps (`{call}`),
built without its window. The surfaces are the complete ones of its benchmark, closed or with an outline. {which}

{in_brief(found)}

**Measures.** One program, `bench/cut_measures.py`, measures both results. *Energy* is the symmetric
Dirichlet energy, the mean over the surface's area of σ₁² + σ₂² + 1/σ₁² + 1/σ₂²; it is 4 without distortion. It is
normalized as in OptCuts: by the area of the surface, with the flat shape at its actual size. *Length* is the length
of the cuts on the surface, divided by √area; every edge counts once, and outlines of the surface do not count.
OptCuts divides by
√(area / π), which makes its numbers 1.77 times as large. *Strain* is the value of max(σ₁, 1/σ₂) − 1 that 99% of the
area stays below. *Mismatch* is the difference between the flat lengths of the two sides of a cut edge, in mm per m,
as the mean over the length of the cuts. *s* is the processor time on one core in seconds, at most {LIMIT} for either
program.

**Comparison.** For WireWarp, we take the shortest cuts found that keep the energy below {BOUND}. A surface without a
flat shape, or one for which darts alone do not reach the bound, is cut by `propose_seams`. It proposes cut sets, each
shorter than the one before, for target strains of {", ".join(f"{100 * target:.0f}%" for target in TARGETS)}. The
column *as proposed* has the shortest set below the bound. Darts are added to a surface that is flat without cuts, and
to the {FEWEST} shortest sets, until the energy is below the bound. Each dart is chosen from {CHOICE} proposals of
`propose_darts`: the dart with the largest decrease of energy for its length. `simplify_seams` removes seams from the
shortest set below the bound, then from the results with darts, and then from the other sets below the bound. Its limit
of strain begins at {100 * LEAST_LIMIT:.0f}% and rises in steps of {100 * LARGE_STEP:.0f} points. If the energy exceeds
the bound, the last step is undone and the steps are halved, as long as they have at least
{100 * SMALL_STEP:.0f} points. After {SHARE * LIMIT:.0f} s, no more seams are removed. The
shortest result counts. WireWarp keeps the length of every cut and outline, so that the sides of a cut can be sewn
together. OptCuts does not; it only limits the distortion over the area. The section on the price of
exactness measures how much longer cuts must be if their sides are equally long.

## Surfaces
"""
    rows = []
    for mesh, (peer, own) in zip(meshes, found, strict=True):
        rows.append([mesh.stem, f"{len(read_obj(mesh)[1]):,}", *cells(peer), *own_cells(own), verdict(peer, own)])
    names = ["length", "energy", "strain", "mismatch", "charts", "s"]
    head = [
        "mesh",
        "triangles",
        *(f"OptCuts: {names[0]}", *names[1:]),
        "ours: length",
        "as proposed",
        *names[1:],
        "verdict",
    ]
    return wrap(text) + "\n" + "\n".join(table(head, rows)) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--most-triangles", type=int, help="only surfaces of at most N triangles")
    parser.add_argument("--commit", default=commit(), help="commit with which kept results were computed")
    arguments = parser.parse_args()

    results, program = Path(os.environ["OPTCUTS_RESULTS"]), Path(os.environ["OPTCUTS_PROGRAM"])
    every = by_size(Path(os.environ["OPTCUTS_MESHES"]))
    most = arguments.most_triangles
    meshes = [mesh for mesh in every if most is None or len(read_obj(mesh)[1]) <= most]
    found = []
    for mesh in meshes:
        found.append((theirs(mesh, results, program), ours(mesh, results)))
        print(
            f"{mesh.stem:28} {' '.join(cells(found[-1][0]))}  |  {' '.join(own_cells(found[-1][1]))}  "
            f"{verdict(*found[-1])}",
            flush=True,
        )
    kept = arguments.page.read_text(encoding="utf-8") if arguments.page.exists() else ""
    kept = kept[kept.index(KEPT) :] if KEPT in kept else ""
    arguments.page.write_text(page(meshes, found, len(every), arguments) + kept, encoding="utf-8")


if __name__ == "__main__":
    main()
