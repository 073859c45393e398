# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds sets of seams, and seams that a model does not need, and measures whether the pieces of a set suit the fabric
and are wide enough.
"""

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

import numpy as np

from ..core import Cache, FlattenError, cut_mesh, make_report, pattern, percent_text, start, start_simplify
from ..issues import ObjectError, object_error
from .arrays import MeshArrays
from .chains import are_among, next_corners
from .cut_faces import segments_along
from .flatten import (
    FlattenChoices,
    issue_of_error,
    known_stretch,
    library_arguments,
    library_marks,
    limits_of,
    result_of,
)
from .steps import CanceledError, Steps, of_all, reported_as
from .suggest import Cut, NoSeam, SearchOptions, from_few_pieces, suggest_cuts

LIMITS = (0.05, 0.1, 0.2)  # accepted stretches as fractions, from stiff woven fabric to plush and knits


def limits_up_to(stretches: Sequence[float]) -> list[float]:
    """Return the accepted stretches in ascending order: the fabric's maximum stretches, and all LIMITS below the larger
    of these. stretches: the maximum stretches; empty if unknown, which gives all LIMITS."""
    return sorted({*(limit for limit in LIMITS if not stretches or limit < max(stretches)), *stretches})


def fewer_seams(arrays: MeshArrays, choices: FlattenChoices, limits: Sequence[float], remedy: str) -> Steps[list[Cut]]:
    """Return sets of seams to clear, one for each limit that allows fewer seams than the next lower limit.

    limits: accepted stretches in ascending order; the sets have the opposite order
    remedy: last sentence of the ObjectError if every seam is needed
    If the search is canceled, the sets found so far are returned.
    """
    if len(arrays.seams) == 0:
        raise object_error("no_seams", "The model has no seams to simplify. Mark seams, or press Suggest Seams.")
    seams, cleared, length, before = arrays.seams, arrays.seams[:0], 0.0, math.inf
    found: list[Cut] = []
    try:
        arguments = library_arguments(arrays, choices)
        for index, limit in enumerate(limits):
            arguments |= {"seams": seams, "strain": limit}
            job = start_simplify(arrays.vertices, arrays.triangles, **arguments)
            try:
                fewer = yield from reported_as(result_of(job), partial(of_all, index, len(limits)))
            except CanceledError:
                if not found:
                    raise
                break
            if not math.isfinite(fewer.strain):
                sentence = "A piece has no flat shape. Flatten, and fix the failed pieces before you simplify seams."
                raise object_error("no_flat_shape", sentence)
            before = fewer.strain_before if index == 0 else before
            if len(fewer.opened) == 0:
                continue
            seams, cleared = fewer.edges, np.concatenate([cleared, fewer.opened])
            length += fewer.length_before - fewer.length
            found.append(_row(arrays, cleared, length, fewer.strain, before, fewer.num_pieces))
    except FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error
    if not found:
        needed = f"Every seam is needed for a stretch of {percent_text(limits[-1])} or less."
        raise object_error("no_proposal", f"{needed} {remedy}")
    return found[::-1]


def _row(arrays: MeshArrays, cleared: np.ndarray, length: float, strain: float, before: float, num_pieces: int) -> Cut:
    return Cut(
        edges=[],
        diagonals=[],
        paths=[],
        segments=segments_along(cleared, arrays),
        piece=0,
        lengths=[length],
        strain=strain,
        strain_before=before,
        num_pieces=num_pieces,
        cleared=[(min(pair), max(pair)) for pair in cleared.tolist()],
    )


def within_fabric(search: Steps[list[Cut]], limits: Sequence[float], remedy: str) -> Steps[list[Cut]]:
    """Search, and return the sets that the fabric allows. Raises ObjectError if there are none.

    Raises CanceledError if the search is canceled before a set is known to be allowed.
    search: steps of with_measures(); limits: see Cut.excess; remedy: see fewer_seams
    """
    cuts = yield from search
    allowed = [cut for cut in cuts if cut.excess(limits) <= 0]
    if not allowed and any(cut.threads is None for cut in cuts):
        raise CanceledError
    if not allowed:
        raise object_error("no_proposal", f"Every seam is needed for this fabric. {remedy}")
    return allowed


def first_sets(
    arrays: MeshArrays, choices: FlattenChoices, options: SearchOptions, no_seam: NoSeam
) -> Steps[list[Cut]]:
    """Return cut sets for a fabric with a known maximum stretch, or other cuts if no piece needs a set."""
    cloth = choices.cloth
    # The search without the fabric takes a fraction of the time, and with_measures() uses the fabric afterward. With
    # negative ease, the fabric is used in the search, because without it, the shapes of the pieces would differ
    # too much.
    if cloth is not None and not (cloth.worn_across or cloth.worn_along):
        cuts = yield from suggest_cuts(arrays, replace(choices, cloth=None), options, no_seam)
        if cuts[0].is_set:
            return cuts
    return (yield from suggest_cuts(arrays, choices, options, no_seam))


SEARCH = 0.8  # share of the progress bar for the search, which takes most of the time; the sets are measured after it


def with_measures(
    search: Steps[list[Cut]], arrays: MeshArrays, choices: FlattenChoices, limits: Sequence[float]
) -> Steps[list[Cut]]:
    """Search, and return cut sets with their widths and threads, without sets that have failed pieces.

    Cuts that are not sets are returned unchanged.
    limits: maximum stretches of the fabric, the smaller direction first
    """
    cuts = yield from reported_as(search, lambda share: SEARCH * share)
    if not cuts[0].is_set:
        return cuts
    measured: list[Cut] = []
    with suppress(CanceledError):  # sets that were not measured have no width and no threads
        yield from reported_as(_measure(cuts, measured, arrays, choices), lambda share: SEARCH + (1 - SEARCH) * share)
    sets = [cut for cut in [*measured, *cuts[len(measured) :]] if math.isfinite(cut.strain)]
    if not sets:
        sentence = "Each set of seams that was found has a piece that fails with this fabric. Choose another fabric."
        raise object_error("no_proposal", sentence)
    return from_few_pieces(sets, limits) if cuts[0].is_first else sets


def _measure(cuts: Sequence[Cut], measured: list[Cut], arrays: MeshArrays, choices: FlattenChoices) -> Steps[None]:
    """Measure these sets one by one, and add them to the list `measured`."""
    solved = Cache()
    for index, cut in enumerate(cuts):
        steps = _measured_set(arrays, choices, cut, solved)
        measured.append((yield from reported_as(steps, partial(of_all, index, len(cuts)))))


def _measured_set(arrays: MeshArrays, choices: FlattenChoices, cut: Cut, solved: Cache) -> Steps[Cut]:
    """Return the set with the least width of the pieces that it changes, and whether a piece is too narrow.

    If the fabric's maximum stretch is known, the set also gets its strain and threads.
    """
    arguments = library_arguments(arrays, choices)
    sides, allowances = _own_allowances(arrays)
    if cut.cleared:
        vertices, faces, changed = arrays.vertices, arrays.triangles, np.array(cut.cleared)
        arguments["seams"] = arrays.seams[~are_among(arrays.seams, changed)]
    else:
        # The lines of a set do not divide edges of seams and wires, and vertices keep their numbers. The arguments
        # for seams and wires therefore stay valid.
        vertices, faces, changed, _ = cut_mesh(arrays.vertices, arrays.triangles, cut.paths)
        arguments["seams"] = np.concatenate([arrays.seams, changed])
    result = yield from result_of(start(vertices, faces, **arguments, cache=solved))
    pieces = result.pieces
    own = pattern.pieces_along(pieces, changed)
    widths, without_room = [], []
    for piece in (piece for piece in own if not piece.error):
        widths.append(pattern.piece_width(piece))
        if not pattern.has_room(piece, arrays.default_allowance, sides, allowances):
            without_room.append(widths[-1])
        yield 1.0
    # If pieces have no room for their allowances, only their widths count.
    cut = replace(cut, width=min(without_room or widths, default=None), is_narrow=bool(without_room))
    if not known_stretch(choices.cloth):
        return cut
    report = make_report(result, vertices, faces, **library_marks(arrays), **limits_of(choices.cloth))
    reports = zip(pieces, report.pieces, strict=True)
    own_reports = [each for piece, each in reports if any(piece is other for other in own)]
    threads = [each.threads for each in own_reports if each.ok and each.threads]
    if len(threads) < len(own_reports):  # a piece fails with this fabric
        return replace(cut, strain=math.inf)
    # For seams to clear, the strain of the search is already that of the whole model with the fabric.
    strain = cut.strain if cut.cleared else max(each.needed for each in own_reports)
    return replace(cut, strain=strain, threads=max(threads, key=lambda each: each.excess))


def _own_allowances(arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """Return the sides of edges with marked allowances, as vertices (k,2) in the direction of their triangle, and these
    allowances (k,) in Blender units."""
    corners = np.flatnonzero(arrays.side_allowances)
    following = next_corners(arrays.polygon_sizes)[corners]
    ends = (following, corners) if arrays.mirrored else (corners, following)
    sides = np.column_stack([arrays.loop_vertices[each] for each in ends])
    return sides, np.maximum(arrays.side_allowances[corners], 0)
