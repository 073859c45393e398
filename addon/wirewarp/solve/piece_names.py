# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces named after the vertex group or material they are made of, or after the side of the model they lie on."""

from collections import Counter
from collections.abc import Sequence

import numpy as np

from .arrays import FaceRegions, Region

# By axis, towards minus and plus. As on a person who looks along -Y, Blender's front: the left hand is at +X.
SIDES = (("Right", "Left"), ("Front", "Back"), ("Bottom", "Top"))
HALVES = (("Right", "Left"), ("Front", "Back"), ("Lower", "Upper"))  # of two pieces on one side
FACES_ONE_WAY = 0.3  # of 1, a flat piece; one that winds around (a sleeve) is named by its place
BESIDE = 0.05  # of the model's size; one that winds around its middle (a ball) has no side
NO_SIDE = "Around"


def side_names(normals: np.ndarray, offsets: np.ndarray) -> list[str]:
    """ "Front", or "Front Left" beside "Front Right"; more pieces than two of one side are called the same.

    normals (p,3): the mean normal of each piece, of length 1 if it is flat. offsets (p,3): from the middle of the
    model to that of the piece, as a share of the model's size.
    """
    names = [_side(normal, offset) for normal, offset in zip(normals, offsets, strict=True)]
    for side in dict.fromkeys(names):
        pair = [index for index, name in enumerate(names) if name == side]
        if len(pair) == 2:
            halves = _halves(side, offsets[pair[1]] - offsets[pair[0]])
            for index, half in zip(pair, halves, strict=True):
                names[index] = f"{side} {half}".rstrip()
    return names


def _side(normal: np.ndarray, offset: np.ndarray) -> str:
    if np.linalg.norm(normal) < FACES_ONE_WAY and np.linalg.norm(offset) < BESIDE:
        return NO_SIDE
    direction = normal if np.linalg.norm(normal) >= FACES_ONE_WAY else offset
    axis = int(np.argmax(np.abs(direction)))
    return SIDES[axis][int(direction[axis] > 0)]


def _halves(side: str, apart: np.ndarray) -> tuple[str, str]:
    """How two pieces of one side differ, the second being this far from the first; "" if nothing."""
    axis = int(np.argmax(np.abs(apart)))
    if np.abs(apart[axis]) < BESIDE or side in SIDES[axis]:  # one lies in or behind the other
        return "", ""
    lower, upper = HALVES[axis]
    return (lower, upper) if apart[axis] > 0 else (upper, lower)


def numbered(wanted: Sequence[str], taken: Sequence[str]) -> list[str]:
    """The names wanted, each with a number where several want it or where it is taken already."""
    used, asked = set(taken), Counter(wanted)
    following: dict[str, int] = {}
    names = []
    for name in wanted:
        number = following.get(name, 2 if name in used else 1)
        if number == 1 and asked[name] == 1 and f"{name} 1" not in used:
            names.append(name)
        else:
            while f"{name} {number}" in used:
                number += 1
            names.append(f"{name} {number}")
            following[name] = number + 1
        used.add(names[-1])
    return names


def region_names(piece_of_face: np.ndarray, piece_count: int, regions: FaceRegions) -> list[str | None]:
    """For each piece the region that most of its faces are in. None if no region distinguishes pieces."""
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
    carried[pieces_in == len(faces_in_piece)] = False  # what all pieces have distinguishes none
    best = np.argmin(np.where(carried, pieces_in[:, None], len(faces_in_piece) + 1), axis=0)
    return [(piece, regions[best[piece]].name) for piece in np.flatnonzero(carried.any(axis=0)).tolist()]
