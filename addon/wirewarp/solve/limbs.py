# SPDX-License-Identifier: GPL-3.0-or-later
"""Recognizes sleeves and trouser legs by their seams and places."""

from collections.abc import Sequence
from itertools import permutations

import numpy as np

from ..core import FlattenResult, SeamReport

SLEEVE, LEG = "Sleeve", "Leg"
# Lengths are shares of the model's size. For a suit of 1.7 m, the values in brackets are these lengths.
ALIKE = 0.05  # largest distance between a piece and the mirror image of its partner (9 cm)
AREAS_ALIKE = 1.3  # largest ratio of the areas of a piece and its partner, whose seams may be in different places
AT_MIDDLE = 0.03  # largest distance of a leg from the middle plane of the model (5 cm), because legs meet at the crotch
CLEARLY = 0.02  # least distance by which the open end is farther out or down than the joint (3 cm)


def limb_names(
    result: FlattenResult, are_darts: Sequence[bool], places: np.ndarray, offsets: np.ndarray, areas: np.ndarray
) -> list[str | None]:
    """Return "Sleeve" or "Leg" for each piece that is certainly a sleeve or a leg, otherwise None.

    Such a piece

    - is a tube: a seam joins it to itself.
    - has a mirror image, and no other mirrored tube, such as a cuff, is sewn to it.
    - is sewn to other pieces at one end, and open at the outer end (sleeve) or the lower end (leg).
    - reaches the middle plane of the model if it is a leg.
    - belongs to the only such pair of sleeves or of legs.

    places (n,3): vertices of the model, from its middle, as a share of its size
    offsets (p,3): middles of the pieces in these coordinates
    areas (p,): areas of the pieces
    """
    seams = list(zip(result.seams, are_darts, strict=True))
    tubes = {seam.pieces[0] for seam, is_dart in seams if not is_dart and not _is_to_others(seam)}
    pairs = [
        (left, right)
        for left, right in permutations(tubes, 2)
        if offsets[left, 0] > 0 and _are_mirrored(left, right, offsets, areas)
    ]
    alone = _not_sewn_to_pairs(pairs, result.seams)
    names: list[str | None] = [None] * len(offsets)
    for kind in (SLEEVE, LEG):
        own = [pair for pair in alone if all(_kind(result, piece, places) == kind for piece in pair)]
        if len(own) == 1:  # two pairs of sleeves would have the same names
            names[own[0][0]] = names[own[0][1]] = kind
    return names


def _not_sewn_to_pairs(pairs: list[tuple[int, int]], seams: Sequence[SeamReport]) -> list[tuple[int, int]]:
    """Return the pairs to which no piece of another pair is sewn."""
    paired = {piece for pair in pairs for piece in pair}
    sewn = [{piece for seam in seams if set(pair) & set(seam.pieces) for piece in seam.pieces} for pair in pairs]
    return [pair for pair, joined in zip(pairs, sewn, strict=True) if not paired & joined - set(pair)]


def _are_mirrored(piece: int, other: int, offsets: np.ndarray, areas: np.ndarray) -> bool:
    distance = np.linalg.norm(offsets[other] - offsets[piece] * [-1, 1, 1])
    ratio = areas[other] / areas[piece] if areas[piece] > 0 else np.inf
    return bool(distance < ALIKE and 1 / AREAS_ALIKE < ratio < AREAS_ALIKE)


def _kind(result: FlattenResult, piece: int, places: np.ndarray) -> str | None:
    open_ends, joined = [], []
    for chain in result.pieces[piece].boundaries:
        middle = places[chain.vertices].mean(axis=0)
        if chain.seam is None:
            open_ends.append(middle)
        elif _is_to_others(result.seams[chain.seam]):
            joined.append(middle)
    if not open_ends or not joined:
        return None
    joint = np.mean(joined, axis=0)
    down = joint[2] - min(end[2] for end in open_ends)
    out = max(abs(end[0]) for end in open_ends) - abs(joint[0])
    own = np.unique(result.pieces[piece].source_vertex)
    if np.abs(places[own, 0]).min() < AT_MIDDLE:
        return LEG if down > max(out, CLEARLY) else None
    return SLEEVE if out > CLEARLY else None


def _is_to_others(seam: SeamReport) -> bool:
    return len(set(seam.pieces)) > 1
