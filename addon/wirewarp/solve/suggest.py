# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts that the core library proposes, as edges to mark, and in words. No Blender in here."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np

from ..core import DartProposal, Job, LengthText, counted, percent_text
from ..issues import ObjectError
from ..names import NO_SEAM
from .arrays import MeshArrays
from .chains import edge_keys
from .flatten import FlattenChoices, issue_of_error, library_arguments, polygons_across, result_of
from .steps import Steps

PAINTED = f' Nor may a seam run where "{NO_SEAM}" is painted.'
Pairs = list[tuple[int, int]]  # vertices


@dataclass(frozen=True)
class NoSeam:
    """What the user has painted."""

    faces: np.ndarray  # (f,) bool, of the mesh
    vertices: np.ndarray  # (n,) bool

    def is_same(self, other: "NoSeam") -> bool:
        return np.array_equal(self.faces, other.faces) and np.array_equal(self.vertices, other.vertices)


@dataclass(frozen=True)
class Target:
    """What cuts that are taken together are to reach."""

    strain: float  # as Cut.strain
    most: int  # cuts; a set of first cuts counts as one
    length: float | None  # of all of them on the model, Blender units; None for any


@dataclass(frozen=True)
class Cut:
    """A dart, a seam, a mirrored pair of them, or a cut set; and the effect of marking it.

    For a target, it includes all cuts from the first to one of them.
    """

    edges: Pairs
    diagonals: Pairs  # those of them that are none of the mesh yet, but lie across a face of four corners
    piece: int  # as flattening numbers them
    lengths: list[float]  # of each of them on the model, of a set in all, Blender units
    strain: float  # what 99% of the piece (of the worst part) must stretch or ease less than, when cut so
    strain_before: float  # infinite before first cuts
    num_pieces: int  # that the first of them divides the piece into: of a set of first cuts, all of it

    @property
    def is_first(self) -> bool:
        """Without it the piece has no flat shape."""
        return math.isinf(self.strain_before)


def suggest_cuts(
    library: ModuleType,
    arrays: MeshArrays,
    choices: FlattenChoices,
    kind: str,
    piece: int | None,
    no_seam: NoSeam,
    target: Target | None,
) -> Steps[list[Cut]]:
    """The best first; with a target each with all before it. kind: DARTS or SEAMS; piece: None for any.

    Sets of first cuts go from few pieces to little stretch.

    Raises ObjectError, also where there is nothing to gain.
    """
    try:
        shared = library_arguments(library, arrays, choices)
        across = diagonals(arrays)
        barred = np.concatenate([_barred_edges(arrays, no_seam), _barred_diagonals(across, arrays, no_seam)])
        arguments = {"vertices": arrays.vertices, "faces": arrays.triangles, **shared, "piece": piece}
        job = _start(library, kind, target, arguments | {"no_seam": barred})
        proposals, new = (yield from result_of(job)), {tuple(pair) for pair in across.tolist()}
        if target is not None:
            return _steps_of(proposals, new, piece)
        cuts = _with_mirror_images(proposals, new)
        return from_few_pieces(cuts) if cuts[0].is_first else cuts
    except library.FlattenError as error:
        issue = issue_of_error(error, arrays)
        if issue.code == "no_proposal" and (no_seam.faces.any() or no_seam.vertices.any()):
            issue = replace(issue, sentence=issue.sentence + PAINTED)
        raise ObjectError(issue) from error


def _start(
    library: ModuleType, kind: str, target: Target | None, arguments: dict[str, Any]
) -> "Job[list[DartProposal]]":
    if target is None:
        return (library.start_darts if kind == "DARTS" else library.start_seams)(**arguments)
    limits = {"strain": target.strain, "most": target.most, "total_length": target.length}
    return library.start_plan(**arguments, **limits, kind="dart" if kind == "DARTS" else "seam", twins=True)


def diagonals(arrays: MeshArrays) -> np.ndarray:
    """(k,2) the sides of triangles that are no edges of the mesh, the lower vertex first."""
    count = len(arrays.vertices)
    sides = np.sort(arrays.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return np.unique(sides[~np.isin(edge_keys(sides, count), edge_keys(arrays.edges, count))], axis=0)


def _barred_edges(arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """Return edges (k,2) with both ends painted, or all faces: edges around painted faces are allowed."""
    counts = np.bincount(arrays.loop_edges, minlength=len(arrays.edges))
    painted = painted_at_edges(arrays, no_seam)
    return arrays.edges[((counts > 0) & (painted == counts)) | no_seam.vertices[arrays.edges].all(axis=1)]


def painted_at_edges(arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """(e,) how many painted faces each edge has."""
    face_of_loop = np.repeat(np.arange(len(arrays.polygon_sizes)), arrays.polygon_sizes)
    return np.bincount(arrays.loop_edges[no_seam.faces[face_of_loop]], minlength=len(arrays.edges))


def _barred_diagonals(across: np.ndarray, arrays: MeshArrays, no_seam: NoSeam) -> np.ndarray:
    """(k,2) of painted faces, and of those with more corners: cut in two they may be filled otherwise than now."""
    polygons = polygons_across(across, arrays)
    is_barred = (arrays.polygon_sizes[polygons] > 4) | no_seam.faces[polygons] | no_seam.vertices[across].all(axis=1)
    return across[is_barred]


def _with_mirror_images(proposals: list[DartProposal], across: set[tuple[int, int]]) -> list[Cut]:
    """In the library's order. Mirror images as one cut; one of them, where two are no better than one."""
    cuts = []
    for index, proposal in enumerate(proposals):
        if proposal.twin is not None and proposal.twin < index:
            continue
        if proposal.strain_with_twin is None:
            cuts.append(_cut([proposal], proposal.strain, proposal.strain_before, across))
        else:
            both = [proposal, proposals[proposal.twin]]
            cuts.append(_cut(both, proposal.strain_with_twin, proposal.strain_before, across))
    return cuts


def from_few_pieces(sets: Sequence[Cut]) -> list[Cut]:
    """Sets of first cuts in the order of their pieces, without those that stretch as far with more pieces."""
    kept: list[Cut] = []
    for each in sorted(sets, key=lambda cut: (cut.num_pieces, cut.strain, cut.lengths[0])):
        if not kept or each.strain < kept[-1].strain:
            kept.append(each)
    return kept


def set_for(sets: Sequence[Cut], limit: float) -> int:
    """Which set of first cuts to show: the fewest pieces within the maximum stretch, else the least stretch."""
    return next((index for index, each in enumerate(sets) if each.strain <= limit), len(sets) - 1)


def _steps_of(plan: list[DartProposal], across: set[tuple[int, int]], piece: int | None) -> list[Cut]:
    """Mirror images that are taken together are one step. piece: that was asked for."""
    first = plan[0]
    # Of any piece: another one, which stays as it is, may be strained more than what is cut first.
    before = first.strain_before if piece is not None else max(first.strain_before, first.strain_left)
    ends = [index + 1 for index, each in enumerate(plan) if each.twin is None or each.twin < index]
    return [_cut(plan[:end], plan[end - 1].strain_left, before, across) for end in ends]


def _cut(proposals: list[DartProposal], strain: float, before: float, across: set[tuple[int, int]]) -> Cut:
    edges = [(min(pair), max(pair)) for proposal in proposals for pair in proposal.edges.tolist()]
    new = [edge for edge in edges if edge in across]
    lengths, num_pieces = [each.length for each in proposals], proposals[0].num_pieces
    return Cut(edges, new, proposals[0].piece, lengths, strain, before, num_pieces)


WORDS = {"DARTS": ("dart", "darts"), "SEAMS": ("seam", "seams")}


def found_words(kind: str, cuts: list[Cut]) -> str:
    """ "1 dart", "3 seams", "2 sets of seams"."""
    if cuts[0].is_first:
        return counted(len(cuts), "set of seams", "sets of seams")
    return counted(sum(len(cut.lengths) for cut in cuts), *WORDS[kind])


def taken_words(kind: str, cut: Cut) -> str:
    """Of cuts that are taken together, "2 darts", "first seams", "first seams and 1 seam"."""
    if not cut.is_first:
        return counted(len(cut.lengths), *WORDS[kind])
    more = len(cut.lengths) - 1
    return f"first seams and {counted(more, *WORDS[kind])}" if more else "first seams"


def step_text(kind: str, cut: Cut, text: LengthText) -> str:
    """Of cuts that are taken together, "2 darts: 12 → 5.0%, 270 mm": it fits a button in a narrow sidebar."""
    return f"{taken_words(kind, cut)}: {_shares(cut)}, {text.rough(sum(cut.lengths))}"


def row_text(kind: str, cut: Cut, target: Target | None, text: LengthText) -> str:
    """In the list: a button in a narrow sidebar."""
    if target is None and cut.is_first:
        return f"{counted(cut.num_pieces, 'piece')}, {_shares(cut)}, {text.rough(cut.lengths[0])}"
    if target is None:
        return cut_text(cut, text)
    step = step_text(kind, cut, text)
    return step[0].upper() + step[1:]


def shortfall(kind: str, cuts: list[Cut], target: Target) -> str:
    """Why the target is not reached; empty where it is."""
    last = cuts[-1]
    if last.strain <= target.strain:
        return ""
    if len(last.lengths) >= target.most:
        remedy = "Allow more cuts"
    elif target.length is not None:
        remedy = "Allow more length, if any other cut helps"
    else:
        remedy = f"No other {WORDS[kind][0]} helps"
    return f"{percent_text(last.strain)} is left, more than your target of {percent_text(target.strain)}. {remedy}."


def cut_text(cut: Cut, text: LengthText) -> str:
    """ "stretch 12 → 6.0%, 140 mm", of mirror images "2×140 mm".

    Of first cuts "3 pieces, stretch 6.0%, seams 1.40 m".
    """
    if cut.is_first:
        return f"{counted(cut.num_pieces, 'piece')}, stretch {_shares(cut)}, seams {text.rough(cut.lengths[0])}"
    times = f"{len(cut.lengths)}×" if len(cut.lengths) > 1 else ""
    return f"stretch {_shares(cut)}, {times}{text.rough(cut.lengths[0])}"


def _shares(cut: Cut) -> str:
    before = "" if cut.is_first else f"{percent_text(cut.strain_before).removesuffix('%')} → "
    return f"{before}{percent_text(cut.strain)}"
