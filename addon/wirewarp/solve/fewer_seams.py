# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams that a model can do without, by the core library, as choices in words. No Blender in here."""

import math
from collections.abc import Sequence
from functools import partial
from types import ModuleType

import numpy as np

from ..core import percent_text
from ..issues import ObjectError, object_error
from .arrays import MeshArrays
from .cut_faces import segments_along
from .flatten import FlattenChoices, issue_of_error, library_arguments, result_of
from .steps import CanceledError, Steps, of_all, reported_as
from .suggest import Cut

LIMITS = (0.05, 0.1, 0.2)  # accepted stretches: woven fabric allows the first, plush and knits the last


def limits_up_to(most: float | None) -> list[float]:
    """Return the accepted stretches in ascending order. most: maximum stretch of the fabric; None if unknown."""
    return list(LIMITS) if most is None else [*(limit for limit in LIMITS if limit < most), most]


def fewer_seams(
    library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, limits: Sequence[float], remedy: str
) -> Steps[list[Cut]]:
    """Return sets of seams to clear: one for each limit that allows fewer seams than the limit below.

    limits: accepted stretches in ascending order; the sets are in the opposite order. If canceled, the sets found so
    far are returned. remedy: a sentence for the ObjectError if every seam is needed.
    """
    if len(arrays.seams) == 0:
        raise object_error("no_seams", "The model has no seams to simplify. Mark seams, or press Suggest Seams.")
    seams, cleared, length, before = arrays.seams, arrays.seams[:0], 0.0, math.inf
    found: list[Cut] = []
    try:
        arguments = library_arguments(library, arrays, choices)
        for index, limit in enumerate(limits):
            arguments |= {"seams": seams, "strain": limit}
            job = library.start_simplify(arrays.vertices, arrays.triangles, **arguments)
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
    except library.FlattenError as error:
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
