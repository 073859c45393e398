# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrowest width of the pieces that sets of seams make, from a run with these seams. No Blender in here."""

from contextlib import closing
from dataclasses import replace
from types import ModuleType

import numpy as np

from ..core import pattern
from .arrays import MeshArrays
from .chains import edge_keys
from .flatten import FlattenChoices, library_arguments, result_of
from .steps import Steps
from .suggest import Cut


def with_widths(
    search: Steps[list[Cut]], library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, allowance: float
) -> Steps[list[Cut]]:
    """Search, and return sets with their widths, those that leave no room for two allowances after the others.

    allowance: in Blender units. Other cuts stay as they are.
    """
    with closing(search):
        cuts = yield from search
    if not cuts[0].is_set:
        return cuts
    found = []
    for cut in cuts:
        width = yield from _narrowest(library, arrays, choices, cut)
        found.append(replace(cut, width=width, is_narrow=width < 2 * allowance))
    return sorted(found, key=lambda cut: cut.is_narrow)


def _narrowest(library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, cut: Cut) -> Steps[float]:
    """Return the narrowest width of the pieces with a flat shape, in Blender units."""
    count = len(arrays.vertices)
    goes = np.isin(edge_keys(arrays.seams, count), edge_keys(cut.cleared, count))
    seams = np.concatenate([arrays.seams[~goes], np.array(cut.edges, dtype=np.int32).reshape(-1, 2)])
    arguments = library_arguments(library, arrays, choices) | {"seams": seams}
    result = yield from result_of(library.start(arrays.vertices, arrays.triangles, **arguments))
    widths = []
    for piece in result.pieces:
        is_new = cut.cleared or np.isin(piece.source_vertex, cut.edges).any()
        if is_new and not piece.error:
            widths.append(pattern.piece_width(piece))
            yield 1.0
    return min(widths)
