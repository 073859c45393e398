# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts that the core library proposes, as edges to mark. No Blender in here."""

from dataclasses import dataclass, replace
from types import ModuleType

import numpy as np

from ..core import DartProposal
from ..issues import ObjectError
from ..names import NO_SEAM
from ..pattern.chains import edge_keys
from .arrays import MeshArrays
from .flatten import FlattenChoices, issue_of_error, library_arguments, result_of
from .steps import Steps

PAINTED = f' Nor may a seam run where "{NO_SEAM}" is painted.'
Pairs = list[tuple[int, int]]  # vertices


@dataclass(frozen=True)
class Cut:
    """A dart or a seam, or two that are mirror images of each other, and what marking them does."""

    edges: Pairs  # of the mesh
    piece: int  # as flattening numbers them
    lengths: list[float]  # of each of them on the model, Blender units
    strain: float  # what 99% of the piece must stretch or ease less than, when cut so, as a share
    strain_before: float


def suggest_cuts(
    library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, kind: str, piece: int | None, no_seam: np.ndarray
) -> Steps[list[Cut]]:
    """The best first. kind: DARTS or SEAMS; piece: None for any; no_seam (k,2): edges along which none is to run.

    Raises ObjectError, also where there is nothing to gain.
    """
    start = library.start_darts if kind == "DARTS" else library.start_seams
    try:
        arguments = library_arguments(library, arrays, choices)
        barred = np.concatenate([diagonals(arrays), no_seam])
        job = start(arrays.vertices, arrays.triangles, **arguments, piece=piece, no_seam=barred)
        return _with_twins((yield from result_of(job)))
    except library.FlattenError as error:
        issue = issue_of_error(error, arrays)
        if issue.code == "no_proposal" and len(no_seam):
            issue = replace(issue, sentence=issue.sentence + PAINTED)
        raise ObjectError(issue) from error


def diagonals(arrays: MeshArrays) -> np.ndarray:
    """(k,2) the sides of triangles that are no edges of the mesh, and cannot be marked."""
    count = len(arrays.vertices)
    sides = np.sort(arrays.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return np.unique(sides[~np.isin(edge_keys(sides, count), edge_keys(arrays.edges, count))], axis=0)


def _with_twins(proposals: list[DartProposal]) -> list[Cut]:
    """Mirror images as one cut, where they help together."""
    cuts = []
    for index, proposal in enumerate(proposals):
        if proposal.strain_with_twin is None:
            cuts.append(_cut([proposal], proposal.strain))
        elif proposal.twin > index:
            cuts.append(_cut([proposal, proposals[proposal.twin]], proposal.strain_with_twin))
    return cuts


def _cut(proposals: list[DartProposal], strain: float) -> Cut:
    edges = [(int(a), int(b)) for proposal in proposals for a, b in proposal.edges]
    first = proposals[0]
    return Cut(edges, first.piece, [each.length for each in proposals], strain, first.strain_before)
