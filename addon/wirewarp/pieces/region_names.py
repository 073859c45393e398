# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces named after the vertex group or material they are made of. No Blender in here."""

from collections.abc import Sequence

import numpy as np

from .regions import FaceRegions, Region


def region_names(piece_of_face: np.ndarray, piece_count: int, regions: FaceRegions) -> list[str | None]:
    """For each piece the region that most of its faces are in. None where there is none that tells pieces apart."""
    faces_in_piece = np.bincount(piece_of_face[regions.sample], minlength=piece_count)
    names: list[str | None] = [None] * piece_count
    for kind in (regions.materials, regions.groups):  # a group says more, and comes last
        for piece, name in _names_by(kind, piece_of_face, faces_in_piece):
            names[piece] = name
    return names


def _names_by(
    regions: Sequence[Region], piece_of_face: np.ndarray, faces_in_piece: np.ndarray
) -> list[tuple[int, str]]:
    """(piece, name); of several regions of one piece the one that the fewest other pieces are in."""
    if not regions:
        return []
    counts = np.array([np.bincount(piece_of_face[each.faces], minlength=len(faces_in_piece)) for each in regions])
    carried = 2 * counts > faces_in_piece  # (regions, pieces)
    pieces_in = carried.sum(axis=1)
    carried[pieces_in == len(faces_in_piece)] = False  # what all pieces have tells nothing
    best = np.argmin(np.where(carried, pieces_in[:, None], len(faces_in_piece) + 1), axis=0)
    return [(piece, regions[best[piece]].name) for piece in np.flatnonzero(carried.any(axis=0)).tolist()]
