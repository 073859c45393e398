# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the cuts that the core library suggests, as lines on the mesh, and describes them in words."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..core import (
    DartProposal,
    ErrorCode,
    FlattenError,
    Job,
    LengthText,
    SurfacePath,
    Threads,
    counted,
    percent_text,
    quoted,
    start_darts,
    start_plan,
    start_seams,
)
from ..issues import ObjectError
from ..names import NO_SEAM
from .arrays import MeshArrays
from .chains import are_among
from .cut_faces import Pairs, Segments, segments_of
from .flatten import FlattenChoices, issue_of_error, library_arguments, polygons_across, result_of
from .steps import CanceledError, Steps

# Pieces have at least this width, as a multiple of the allowance: two allowances, and a fifth more to turn the piece
# right side out.
ROOM = 2.4
# A set with more pieces is worth the sewing if its stretch is below this share of the stretch of a set with fewer.
# Smaller gains are not felt in fabric.
WORTH_PIECES = 0.95
CORNER = math.cos(math.radians(30))  # larger turns are corners; a sewist sees smaller turns as a curve
PAINTED = f' Seams are also not allowed where "{NO_SEAM}" is painted.'


@dataclass(frozen=True)
class NoSeam:
    """Faces and vertices that the user has painted, because no seam may cross them."""

    faces: np.ndarray  # (f,) bool, whether each face of the mesh is painted
    vertices: np.ndarray  # (n,) bool, whether each vertex is painted

    def is_same(self, other: "NoSeam") -> bool:
        return np.array_equal(self.faces, other.faces) and np.array_equal(self.vertices, other.vertices)


@dataclass(frozen=True)
class Target:
    """The target for several cuts that are marked together."""

    strain: float  # maximum of Cut.strain
    most: int  # maximum number of cuts; a cut set counts as one
    length: float | None  # maximum total length of the cuts on the model, in Blender units; None: any length


@dataclass(frozen=True)
class Cut:
    """A suggestion and its effect: a dart, a seam, a mirrored pair of darts or seams, a cut set, or seams to clear.

    If there is a target, each cut includes all cuts before it.
    """

    edges: Pairs  # edges of the cut; empty if a line crosses faces
    diagonals: Pairs  # edges of the cut that are diagonals of faces
    paths: list[SurfacePath] = field(compare=False)  # the cut as lines, for library.cut_mesh
    segments: Segments = field(compare=False)  # the cut as segments to draw
    piece: int  # index of the piece
    lengths: list[float]  # length of each line on the model, or total length of a cut set, in Blender units
    strain: float  # after the cut, 99% of the piece, or of its worst part, has at most this strain
    strain_before: float  # strain before the cut; infinite for a cut set
    num_pieces: int  # number of pieces after the first line, after a cut set, or without the cleared seams
    is_bent: bool = False  # whether a line along edges has a corner
    cleared: Pairs = field(default_factory=list)  # seams to clear; if there are any, nothing is cut
    width: float | None = None  # narrowest width of the pieces of a set, in Blender units; None until it is measured
    is_narrow: bool = False  # whether two allowances of a piece have no room side by side
    threads: Threads | None = None  # threads of the piece that exceeds the fabric most; None until measured

    @property
    def is_first(self) -> bool:
        """Return whether the piece has no flat shape without the cut."""
        return math.isinf(self.strain_before)

    @property
    def is_set(self) -> bool:
        """Return whether the cut is a complete set of seams for a piece or model. Sets in a list are alternatives."""
        return bool(self.cleared) or (self.is_first and len(self.lengths) == 1)

    def excess(self, limits: Sequence[float]) -> float:
        """Return by how much the worst piece exceeds the maximum stretch, as in the verdict; at most 0 if none does.

        limits: maximum stretches, the smaller direction first
        """
        # Before the set is measured, its strain is compared with the smaller limit.
        return self.threads.excess if self.threads else self.strain - limits[0]


@dataclass(frozen=True)
class SearchOptions:
    kind: str  # DARTS, SEAMS, or FEWER for seams to clear
    piece: int | None = None  # index of the piece to cut; None for any piece
    target: Target | None = None
    strain: float | None = None  # accepted strain of cut sets; None: the library's default; ignored with a target
    is_smooth: bool = False  # whether darts and cut sets may cross faces; ignored if there is a target
    names: dict[int, str] = field(default_factory=dict)  # names of pieces by their ids

    def piece_text(self, arrays: MeshArrays, triangles: np.ndarray) -> str:
        """Return the name of the piece of these triangles in quotes; "the piece" if the name is not known."""
        ids = np.unique(arrays.piece_ids[arrays.triangle_polygons[triangles]])
        return quoted([self.names[int(ids[0])]]) if len(ids) == 1 and ids[0] in self.names else "the piece"


def suggest_cuts(
    arrays: MeshArrays, choices: FlattenChoices, options: SearchOptions, no_seam: NoSeam
) -> Steps[list[Cut]]:
    """Return cuts, the best dart or seam first, or the steps to a target.

    If the search is canceled, return the cut sets found so far. Raises ObjectError, for example if no cut helps.
    """
    try:
        shared = library_arguments(arrays, choices)
        across = diagonals(arrays)
        forbidden = np.concatenate([_forbidden_edges(arrays, no_seam), _forbidden_diagonals(across, arrays, no_seam)])
        arguments = {"vertices": arrays.vertices, "faces": arrays.triangles, **shared, "piece": options.piece}
        around = arrays.edges[painted_at_edges(arrays, no_seam) > 0]
        job = _start(options, arguments | {"no_seam": forbidden}, around, arrays.default_allowance)
        try:
            proposals = yield from result_of(job)
        except CanceledError:
            proposals = yield from _found_by_then(job)
        if options.target is not None:
            return _steps_of(proposals, arrays, options.piece)
        cuts = _with_mirror_images(proposals, arrays)
        if options.is_smooth and options.kind == "DARTS":
            cuts.sort(key=lambda cut: cut.is_bent)  # darts with corners are last
        return cuts
    except FlattenError as error:
        issue = issue_of_error(error, arrays, piece=options.piece_text(arrays, np.asarray(error.faces, dtype=int)))
        if issue.code == "no_proposal" and (no_seam.faces.any() or no_seam.vertices.any()):
            issue = replace(issue, sentence=issue.sentence + PAINTED)
        raise ObjectError(issue) from error


def _found_by_then(job: "Job[list[DartProposal]]") -> Steps[list[DartProposal]]:
    """Return the cut sets that a canceled job has found. Raises CanceledError if it has found none."""
    while not job.is_done():
        yield job.progress()[1]
    try:
        return job.result()
    except FlattenError as error:
        if error.code != ErrorCode.cancelled:
            raise
        raise CanceledError from error


def _start(
    options: SearchOptions, arguments: dict[str, Any], around_painted: np.ndarray, allowance: float
) -> "Job[list[DartProposal]]":
    """Return the started job of the search.

    around_painted: edges (k,2) that smooth lines must not cross, because they would enter painted faces; allowance:
    width of the allowance in Blender units.
    """
    target, is_dart = options.target, options.kind == "DARTS"
    if target is not None:
        arguments |= {"strain": target.strain, "most": target.most, "total_length": target.length}
        return start_plan(**arguments, kind="dart" if is_dart else "seam", twins=True)
    arguments |= {"smooth": options.is_smooth, "no_crossing": around_painted}
    if not is_dart:
        return start_seams(**arguments, strain=options.strain, narrowest=ROOM * allowance)
    return start_darts(**arguments)


def diagonals(arrays: MeshArrays) -> np.ndarray:
    """Return the sides (k,2) of triangles that are not edges of the mesh, the vertex with the lower index first."""
    sides = np.sort(arrays.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return np.unique(sides[~are_among(sides, arrays.edges)], axis=0)


def _forbidden_edges(arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """Return the edges (k,2) whose ends are both painted or whose faces are all painted.

    A cut may run around painted faces.
    """
    counts = np.bincount(arrays.loop_edges, minlength=len(arrays.edges))
    is_forbidden = (counts > 0) & (painted_at_edges(arrays, no_seam) == counts)
    return arrays.edges[is_forbidden | no_seam.vertices[arrays.edges].all(axis=1)]


def painted_at_edges(arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """Return the number of painted faces (e,) of each edge."""
    face_of_loop = np.repeat(np.arange(len(arrays.polygon_sizes)), arrays.polygon_sizes)
    return np.bincount(arrays.loop_edges[no_seam.faces[face_of_loop]], minlength=len(arrays.edges))


def _forbidden_diagonals(across: np.ndarray, arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """Return the diagonals (k,2) in painted faces, or with two painted ends. across: all diagonals of the mesh."""
    is_painted = no_seam.faces[polygons_across(across, arrays)] | no_seam.vertices[across].all(axis=1)
    return across[is_painted]


def _with_mirror_images(proposals: list[DartProposal], arrays: MeshArrays) -> list[Cut]:
    """Return cuts in the library's order. Two mirror images become one cut, unless one of them alone helps as much."""
    cuts = []
    for index, proposal in enumerate(proposals):
        if proposal.twin is not None and proposal.twin < index:
            continue
        if proposal.strain_with_twin is None:
            cuts.append(_cut([proposal], proposal.strain, proposal.strain_before, arrays))
        else:
            both = [proposal, proposals[proposal.twin]]
            cuts.append(_cut(both, proposal.strain_with_twin, proposal.strain_before, arrays))
    return cuts


def from_few_pieces(sets: Sequence[Cut], limits: Sequence[float]) -> list[Cut]:
    """Return cut sets by their number of pieces, without sets that have more pieces but about the same stretch.

    limits: see Cut.excess
    """
    kept: list[Cut] = []
    within = [each for each in sets if each.strain <= limits[-1]]
    for each in sorted(within or sets, key=lambda cut: (cut.num_pieces, cut.strain, cut.lengths[0])):
        # A set with narrow pieces does not replace a set without narrow pieces. The first set that the fabric allows is
        # kept even if it lowers the stretch little.
        others = [other for other in kept if each.is_narrow or not other.is_narrow]
        is_first = each.excess(limits) <= 0 < min((other.excess(limits) for other in others), default=math.inf)
        if is_first or each.strain < WORTH_PIECES * min((other.strain for other in others), default=math.inf):
            kept.append(each)
    # Among sets with equally many pieces, the set with the least stretch is last.
    return sorted(kept, key=lambda cut: (cut.num_pieces, -cut.strain))


def set_for(sets: Sequence[Cut], limits: Sequence[float]) -> int:
    """Return the index of the first set that the fabric allows, if possible without narrow pieces.

    If the fabric allows no set, return the index of the set that exceeds the limits least. limits: see Cut.excess
    """
    excesses = [each.excess(limits) for each in sets]
    within = [index for index, excess in enumerate(excesses) if excess <= 0]
    if within:
        return min(within, key=lambda index: (sets[index].is_narrow, index))
    return excesses.index(min(excesses))


def _steps_of(plan: list[DartProposal], arrays: MeshArrays, piece: int | None) -> list[Cut]:
    """Return the steps of a plan. Two mirror images are one step. piece: the piece to cut; None for any piece."""
    first = plan[0]
    # If any piece may be cut, the first cut may be in another piece than the most strained piece. Then strain_left, the
    # strain after this cut, is that of the most strained piece, which the cut does not change.
    before = first.strain_before if piece is not None else max(first.strain_before, first.strain_left)
    ends = [index + 1 for index, each in enumerate(plan) if each.twin is None or each.twin < index]
    return [_cut(plan[:end], plan[end - 1].strain_left, before, arrays) for end in ends]


def _cut(proposals: list[DartProposal], strain: float, before: float, arrays: MeshArrays) -> Cut:
    paths = [path for proposal in proposals for path in proposal.paths]
    pairs = [proposal.edges for proposal in proposals]
    edges = np.sort(np.concatenate(pairs), axis=1) if all(len(each) for each in pairs) else np.empty((0, 2), np.int32)
    new = edges[~are_among(edges, arrays.edges)]
    return Cut(
        edges=[(a, b) for a, b in edges.tolist()],
        diagonals=[(a, b) for a, b in new.tolist()],
        paths=paths,
        segments=segments_of(paths, arrays),
        piece=proposals[0].piece,
        lengths=[each.length for each in proposals],
        strain=strain,
        strain_before=before,
        num_pieces=proposals[0].num_pieces,
        is_bent=any(_has_corner(arrays.vertices[each]) for each in pairs if len(each)),
    )


def _has_corner(ends: np.ndarray) -> bool:
    """Return whether a line turns by more than 30 degrees at a vertex. ends (k,2,3): places of the ends of its edges,
    in order."""
    ways = ends[:, 1] - ends[:, 0]
    ways = ways / np.linalg.norm(ways, axis=1)[:, None]
    return bool((np.sum(ways[1:] * ways[:-1], axis=1) < CORNER).any())


WORDS = {"DARTS": ("dart", "darts"), "SEAMS": ("seam", "seams")}


def found_words(cuts: list[Cut]) -> str:
    """Return words for the number of rows: "5 suggestions", "2 sets of seams" or "2 ways to simplify"."""
    if cuts[0].is_first:
        return counted(len(cuts), "set of seams", "sets of seams")
    if cuts[0].cleared:
        return counted(len(cuts), "way to simplify", "ways to simplify")
    return counted(len(cuts), "suggestion")


def taken_words(kind: str, cut: Cut) -> str:
    """Return words for cuts that are marked together: "2 darts", "first seams", "first seams and 1 seam"."""
    if not cut.is_first:
        return counted(len(cut.lengths), *WORDS[kind])
    more = len(cut.lengths) - 1
    return f"first seams and {counted(more, *WORDS[kind])}" if more else "first seams"


def step_text(kind: str, cut: Cut, text: LengthText) -> str:
    """Return "2 darts: 12 → 5.0%, 270 mm" for cuts that are marked together. It fits a button in a narrow sidebar."""
    return f"{taken_words(kind, cut)}: {_shares(cut)}, {text.rough(sum(cut.lengths))}"


def row_text(kind: str, cut: Cut, target: Target | None, text: LengthText) -> str:
    """Return the text of a cut's button in the list. It fits a narrow sidebar."""
    if cut.cleared:
        return f"{counted(cut.num_pieces, 'piece')}, {percent_text(cut.strain)}, −{text.rough(cut.lengths[0])}"
    if target is None and cut.is_first:
        return f"{counted(cut.num_pieces, 'piece')}, {_shares(cut)}, {text.rough(cut.lengths[0])}"
    if target is None:
        return cut_text(cut, text)
    step = step_text(kind, cut, text).removeprefix("first seams and ")  # the row above names the first seams
    if step[0].isdigit() and cut.is_first:
        return f"and {step}"
    return step[0].upper() + step[1:]


def shortfall(kind: str, cuts: list[Cut], target: Target) -> str:
    """Return sentences that say how far the target is missed, and what may help; empty if it is reached."""
    last = cuts[-1]
    if last.strain <= target.strain:
        return ""
    if len(last.lengths) >= target.most:
        remedy = "Allow more cuts"
    elif target.length is not None:
        remedy = "Allow more length, because another cut may help"
    else:
        remedy = f"No other {WORDS[kind][0]} helps"
    return (
        f"A stretch of {percent_text(last.strain)} is left, more than your target of {percent_text(target.strain)}. "
        f"{remedy}."
    )


def cut_text(cut: Cut, text: LengthText) -> str:
    """Return the text of a cut in messages: "stretch 12 → 6.0%, 140 mm", with "2×140 mm" for mirror images.

    For a cut set, return "3 pieces, stretch 6.0%, seams 1.4 m". For seams to clear, return "4 pieces, stretch 5.0 →
    9.5%, 270 mm less seam".
    """
    if cut.cleared:
        return f"{counted(cut.num_pieces, 'piece')}, stretch {_shares(cut)}, {text.rough(cut.lengths[0])} less seam"
    if cut.is_first:
        return f"{counted(cut.num_pieces, 'piece')}, stretch {_shares(cut)}, seams {text.rough(cut.lengths[0])}"
    times = f"{len(cut.lengths)}×" if len(cut.lengths) > 1 else ""
    return f"stretch {_shares(cut)}, {times}{text.rough(cut.lengths[0])}"


def _shares(cut: Cut) -> str:
    before = "" if cut.is_first else f"{percent_text(cut.strain_before).removesuffix('%')} → "
    return f"{before}{percent_text(cut.strain)}"
