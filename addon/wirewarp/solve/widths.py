# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrowest width of the pieces that sets of seams make, from a run with these seams. No Blender in here."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from types import ModuleType

import numpy as np

from ..core import Cache, pattern
from .arrays import MeshArrays
from .chains import edge_keys, next_corners
from .flatten import FlattenChoices, flatten_arrays
from .steps import CanceledError, Steps, of_all, reported_as
from .suggest import Cut, from_few_pieces

SEARCH = 0.8  # share of the progress for the search


def with_widths(
    search: Steps[list[Cut]], library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, limit: float
) -> Steps[list[Cut]]:
    """Search, and return cut sets with their widths. If the measurement is canceled, the sets have no widths.

    limit: the maximum stretch of the fabric, which decides between cut sets. Other cuts stay as they are.
    """
    cuts = yield from reported_as(search, lambda share: SEARCH * share)
    if not cuts[0].is_set:
        return cuts
    try:
        sets = yield from reported_as(_measured(cuts, library, arrays, choices), _after_search)
    except CanceledError:
        sets = cuts
    return from_few_pieces(sets, limit) if cuts[0].is_first else sets


def _after_search(share: float) -> float:
    return SEARCH + (1 - SEARCH) * share


def _measured(
    cuts: Sequence[Cut], library: ModuleType, arrays: MeshArrays, choices: FlattenChoices
) -> Steps[list[Cut]]:
    found, solved = [], library.Cache()
    for index, cut in enumerate(cuts):
        steps = _narrowest(library, arrays, choices, cut, solved)
        width, is_narrow = yield from reported_as(steps, partial(of_all, index, len(cuts)))
        found.append(replace(cut, width=width, is_narrow=is_narrow))
    return found


def _narrowest(
    library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, cut: Cut, solved: Cache
) -> Steps[tuple[float | None, bool]]:
    """Return the narrowest width of the pieces that the set changes, and whether one has no room for its allowances.

    If there are such pieces, the width is theirs. It is in Blender units; None if no piece is flat.
    """
    count = len(arrays.vertices)
    is_cleared = np.isin(edge_keys(arrays.seams, count), edge_keys(cut.cleared, count))
    seams = np.concatenate([arrays.seams[~is_cleared], np.array(cut.edges, dtype=np.int32).reshape(-1, 2)])
    result = yield from flatten_arrays(library, replace(arrays, seams=seams), choices, solved)
    sides, allowances = _own_allowances(arrays)
    widths, without_room = [], []
    for piece in pattern.pieces_along(result.pieces, cut.cleared or cut.edges):
        widths.append(pattern.piece_width(piece))
        if not pattern.has_room(piece, arrays.default_allowance, sides, allowances):
            without_room.append(widths[-1])
        yield 1.0
    return min(without_room or widths, default=None), bool(without_room)


def _own_allowances(arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """Return sides (k,2) in the direction of their triangle, and their allowances (k,) in Blender units."""
    corners = np.flatnonzero(arrays.side_allowances)
    following = next_corners(arrays.polygon_sizes)[corners]
    ends = (following, corners) if arrays.mirrored else (corners, following)
    sides = np.column_stack([arrays.loop_vertices[each] for each in ends])
    return sides, np.maximum(arrays.side_allowances[corners], 0)
