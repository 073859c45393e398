# SPDX-License-Identifier: GPL-3.0-or-later
"""The suggested cut that is chosen, on the model, on its flat pieces and in their map: arrays, no GPU."""

import bpy
import numpy as np

from ..blender.attributes import find_values, has_attributes
from ..names import SOURCE_VERTEX
from ..solve.chains import edge_keys
from ..state.changes import has_changed
from ..state.owners import model_or_self
from ..state.reports import pieces_report
from ..state.suggestions import chosen_cut
from .failures import Failures
from .gather import gather_triangles, uv_places
from .objects import is_modified

SIDES = [0, 1, 1, 2, 2, 0]  # of a triangle: a cut may run across faces
NO_LINES = np.zeros((0, 3), dtype=np.float32)


def with_cut(failed: Failures | None, ends: np.ndarray) -> Failures | None:
    """What failed and would fix it, and the ends (2k,3) of the cut, which looks like that."""
    if not len(ends):
        return failed
    failed = failed or Failures({}, NO_LINES)
    proposed = np.concatenate([failed.lines.get("proposed", NO_LINES), ends])
    return Failures(failed.lines | {"proposed": proposed}, failed.triangles)


def suggested_lines(target: bpy.types.Object) -> np.ndarray:
    """(2k,3) on a model or on flat pieces; none where nothing is chosen. Of an object in Object Mode."""
    pairs = _pairs(target)
    if not pairs:
        return NO_LINES
    mesh, source = target.data, np.arange(len(target.data.vertices))
    if model_or_self(target) != target:
        if not has_attributes(mesh, SOURCE_VERTEX):
            return NO_LINES
        source = find_values(mesh, SOURCE_VERTEX)
    triangles = gather_triangles(mesh)
    sides = np.unique(np.sort(triangles.vertices[:, SIDES].reshape(-1, 2), axis=1), axis=0)
    return triangles.positions[sides[_are_among(source[sides], pairs)].ravel()]


def uv_suggested_lines(model: bpy.types.Object) -> np.ndarray:
    """(2k,3) in the map of the pieces. Of an object in Object Mode."""
    pairs = _pairs(model)
    if not pairs:
        return NO_LINES
    triangles = gather_triangles(model.data)
    is_cut = _are_among(triangles.vertices[:, SIDES].reshape(-1, 2), pairs)
    return uv_places(model.data)[triangles.corners[:, SIDES].reshape(-1, 2)[is_cut].ravel()]


def _pairs(target: bpy.types.Object) -> list[tuple[int, int]]:
    """The vertices of the model; none where these are not to be seen, as on the cage of what modifiers shape."""
    source = model_or_self(target)
    if source == target:
        is_seen = not is_modified(source)
    else:
        report = pieces_report(source)
        is_seen = report is not None and not report.with_modifiers and not has_changed(source, report.model_state)
    cut = chosen_cut(source) if is_seen else None
    return cut.edges if cut else []


def _are_among(sides: np.ndarray, pairs: list[tuple[int, int]]) -> np.ndarray:
    """(k,) bool, of sides (k,2)"""
    count = max(int(sides.max(initial=0)), int(np.max(pairs))) + 1
    return np.isin(edge_keys(sides, count), edge_keys(pairs, count))
