# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrows from a seam to the side of it that is longer or shorter by an ease of its own."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..words import ease_text
from .lines import HEAD, Name

SHARE = 0.25  # of the line that is eased, an arrow's length
LONGEST = 0.12  # of the object's size
BEYOND = 2.2  # arrow's lengths from the edge to the middle of the text, which hides no arrow there


@dataclass(frozen=True)
class SideEases:
    """Edges, each as the face on the eased side runs along it."""

    vertices: np.ndarray  # (k,2) int32
    ends: np.ndarray  # (k,2,3)
    inward: np.ndarray  # (k,3) unit vectors in that face, away from the edge
    normals: np.ndarray  # (k,3) of that face
    ratios: np.ndarray  # (k,) float32
    pieces: np.ndarray  # (k,) int32, on flat pieces; 0 on the model
    size: float  # of the object


def ease_arrows(eases: SideEases) -> tuple[np.ndarray, list[Name]]:
    """The ends (2k,3) of the strokes of an arrow in the middle of each line, and its ease at the tip."""
    strokes, names = [np.empty((0, 3), dtype=np.float32)], []
    for rows in _lines(eases):
        lengths = np.linalg.norm(eases.ends[rows, 1] - eases.ends[rows, 0], axis=1)
        row = rows[int(np.searchsorted(np.cumsum(lengths), lengths.sum() / 2))]
        length = min(SHARE * lengths.sum(), LONGEST * eases.size)
        base, inward = eases.ends[row].mean(axis=0), eases.inward[row]
        tip, aside = base + length * inward, np.cross(eases.normals[row], inward)
        heads = [tip + HEAD * length * (side * aside - 1.5 * inward) for side in (-1, 1)]
        strokes.append(np.array([base, tip, tip, heads[0], tip, heads[1]], dtype=np.float32))
        text, reach = ease_text(float(eases.ratios[row])), float(lengths.sum() / 2)
        place = (base + BEYOND * length * inward)[None]
        names.append(Name((text,), place, eases.normals[row][None], reach, int(eases.pieces[row])))
    return np.concatenate(strokes), names


def _lines(eases: SideEases) -> Iterator[list[int]]:
    """Rows of one ratio, one after the other along the outline of the side."""
    begins = {(int(start), float(ratio)): row for row, (start, ratio) in enumerate(_keys(eases, 0))}
    after = [begins.get((int(end), float(ratio)), -1) for end, ratio in _keys(eases, 1)]
    waiting = dict.fromkeys([*sorted(set(range(len(after))) - set(after)), *range(len(after))])
    while waiting:
        row, line = next(iter(waiting)), []
        while row in waiting:
            del waiting[row]
            line.append(row)
            row = after[row]
        yield line


def _keys(eases: SideEases, end: int) -> Iterator[tuple[int, float]]:
    return zip(eases.vertices[:, end].tolist(), eases.ratios.tolist(), strict=True)
