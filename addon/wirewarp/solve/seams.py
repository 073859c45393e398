# SPDX-License-Identifier: GPL-3.0-or-later
"""Which seam is which: the ids and names of the seams of a result, and which of them are darts.

A seam is numbered once. It is known again by the ids on the edges of the model, whatever its place in the result has
become, and a number that was given is never given again.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core import FlattenResult, SeamReport
from .arrays import MeshArrays, edge_lengths
from .chains import edge_keys
from .identity import assign_ids

GIVEN = re.compile(r"(?:Seam|Dart) (\d+)")  # a name of ours, that the user has not changed


@dataclass(frozen=True)
class KnownSeams:
    """What is known before a run."""

    ids: np.ndarray  # (k,) int32, one per seam edge of the model; 0 on edges that were in no seam yet
    names: Mapping[int, str]  # of all seams there ever were, by id


@dataclass(frozen=True)
class SeamIdentity:
    seam_id: int  # random, 31 bits
    name: str  # no other seam of the object has it
    is_dart: bool


def identify_seams(result: FlattenResult, arrays: MeshArrays, known: KnownSeams) -> list[SeamIdentity]:
    """Of each seam of a FlattenResult, in their order."""
    seam_of_edge, lengths = _seam_of_edge(result.seams, arrays), edge_lengths(arrays.vertices, arrays.seams)
    inside = seam_of_edge >= 0
    taken = {*known.names, *known.ids.tolist()}
    ids = assign_ids(seam_of_edge[inside], known.ids[inside], lengths[inside], len(result.seams), taken)
    ends = _ends_at(arrays)
    names = dict(known.names)
    number = max([len(names), *(int(match[1]) for match in map(GIVEN.fullmatch, names.values()) if match)])
    identities = []
    for seam_id, seam in zip(ids, result.seams, strict=True):
        is_dart = _is_dart(seam, ends)
        kind, given = "Dart" if is_dart else "Seam", GIVEN.fullmatch(names.get(seam_id, ""))
        if not names.get(seam_id):  # new, or the user has cleared its name
            number += 1
            names[seam_id] = f"{kind} {number}"
        elif given:
            names[seam_id] = f"{kind} {given[1]}"
        identities.append(SeamIdentity(seam_id, names[seam_id], is_dart))
    return identities


def ids_by_edge(result: FlattenResult, arrays: MeshArrays, identities: Sequence[SeamIdentity]) -> np.ndarray:
    """(k,) int32, for the seam edges of the model."""
    seam_of_edge = _seam_of_edge(result.seams, arrays)
    ids = np.array([identity.seam_id for identity in identities] + [0], dtype=np.int32)
    return ids[seam_of_edge]


def _seam_of_edge(seams: Sequence[SeamReport], arrays: MeshArrays) -> np.ndarray:
    """(k,) index of the seam that each seam edge of the model is in, -1 where it is in none."""
    count = len(arrays.vertices)
    keys = [edge_keys(seam.edges, count) for seam in seams]
    own = edge_keys(arrays.seams, count)
    found = np.full(len(own), -1, dtype=np.int64)
    if not keys or not len(own):
        return found
    listed, index = np.concatenate(keys), np.repeat(np.arange(len(keys)), [len(each) for each in keys])
    order = np.argsort(own)
    place = np.searchsorted(own[order], listed).clip(max=len(own) - 1)
    is_own = own[order[place]] == listed
    found[order[place[is_own]]] = index[is_own]
    return found


def _ends_at(arrays: MeshArrays) -> np.ndarray:
    """(n,) how many edges of seams and outlines there are at each vertex."""
    edges = np.concatenate([arrays.seams, arrays.outline])
    unique = np.unique(np.sort(edges, axis=1), axis=0)  # an edge of the outline may be marked as a seam, too
    return np.bincount(unique.ravel(), minlength=len(arrays.vertices))


def _is_dart(seam: SeamReport, edges_at: np.ndarray) -> bool:
    """Both sides in one piece, and an end inside it."""
    if len(set(seam.pieces)) > 1:
        return False
    vertices, counts = np.unique(np.asarray(seam.edges), return_counts=True)
    return bool(np.any((counts == 1) & (edges_at[vertices] == 1)))
