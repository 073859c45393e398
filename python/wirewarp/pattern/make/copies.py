# SPDX-License-Identifier: GPL-3.0-or-later
"""Leaves out what a mirror makes: one piece of each mirrored pair, and one half of a symmetric piece.

Notches are at the same places on seams that a mirror maps to each other; otherwise, a mirrored copy would not fit.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from ..model import PatternPiece
from .fold import ALONG, folded
from .mirror import ALIKE, Mirror, fold_of, mirrors_between
from .outline import Side
from .pieces import Laid
from .seams import SewnSide


@dataclass(frozen=True)
class Copies:
    """Mirrored pairs and folds by index of the piece."""

    # of the first piece of a pair: the second, and the mirror that maps it to the first
    pairs: dict[int, tuple[int, Mirror]]
    folds: dict[int, tuple[np.ndarray, Mirror]]  # the fold (2,2), and the mirror that maps the piece to itself

    @property
    def left_out(self) -> set[int]:
        """Return the pieces that are not drawn."""
        return {second for second, _ in self.pairs.values()}


def copies_of(laid: Sequence[Laid], pieces: Sequence[PatternPiece], pairs: bool, on_fold: bool) -> Copies:
    """Return the copies.

    pieces: those of laid, with their lines. A piece is in at most one pair, and not folded then.
    """
    found = Copies({}, {})

    def mirrors(first: int, second: int) -> Iterator[Mirror]:
        """Return the mirrors that keep the grain or reverse it."""
        for mirror in mirrors_between(pieces[first], pieces[second]):
            grain = mirror.direction(laid[second].grain)
            if abs(grain[0] * laid[first].grain[1] - grain[1] * laid[first].grain[0]) < ALONG:
                yield mirror

    for first, second in combinations(range(len(pieces)), 2) if pairs else ():
        if first not in found.left_out and second not in found.left_out and first not in found.pairs:
            mirror = next(mirrors(first, second), None)
            if mirror:
                found.pairs[first] = second, mirror
    for index, piece in enumerate(pieces) if on_fold else ():
        if piece.on_fold or index in found.left_out:
            continue
        folds = ((fold_of(piece, mirror), mirror) for mirror in mirrors(index, index))
        first_fold = next(((fold, mirror) for fold, mirror in folds if fold is not None), None)
        if first_fold:
            found.folds[index] = first_fold
    return found


@dataclass
class SeamGroup:
    """Seams whose notches are at the same places."""

    turned: dict[int, bool]  # by seam: whether places count from the other end than those of the first seam
    is_symmetric: bool = False  # a mirror maps a seam to itself, end for end


@dataclass(frozen=True)
class MirroredSides:
    """The sides of seams that mirrors map to each other."""

    groups: list[SeamGroup]
    images: dict[int, list[Side]] = field(default_factory=dict)  # by the id() of a side: its images

    def copies(self, side: Side) -> list[Side]:
        """Return the side, and all sides that it is drawn for, including images of images."""
        found = [side]
        for own in found:
            found += [image for image in self.images.get(id(own), ()) if all(image is not other for other in found)]
        return found


def mirrored_sides(copies: Copies, laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]]) -> MirroredSides:
    forward = {id(own.side): own.is_forward for sides in seams for own in sides}
    # by seam: its images, and whether they run in the other direction
    turns: dict[int, list[tuple[int, bool]]] = defaultdict(list)
    images: dict[int, list[Side]] = defaultdict(list)
    mirrors = [(first, second, mirror) for first, (second, mirror) in copies.pairs.items()]
    mirrors += [(index, index, mirror) for index, (_, mirror) in copies.folds.items()]
    for first, second, mirror in mirrors:
        for side, image in _matched(laid[first], laid[second], mirror):
            a, b = side.seam, image.seam
            if a is None or b is None:
                continue
            is_turned = forward[id(side)] == forward[id(image)]  # outlines run in the other direction in a mirror
            turns[a].append((b, is_turned))
            turns[b].append((a, is_turned))
            images[id(side)].append(image)
            images[id(image)].append(side)
    return MirroredSides(_groups(len(seams), turns), images)


def _matched(first: Laid, second: Laid, mirror: Mirror) -> list[tuple[Side, Side]]:
    """Return the sides of the first piece, and those of the second whose images match them."""
    images = [(side, mirror.image(side.points[::-1])) for loop in second.loops for side in loop]
    return [
        (side, other)
        for side in (side for loop in first.loops for side in loop)
        for other, image in images
        if len(image) == len(side.points) and np.abs(image - side.points).max() <= ALIKE
    ]


def _groups(count: int, turns: dict[int, list[tuple[int, bool]]]) -> list[SeamGroup]:
    groups: list[SeamGroup] = []
    met: set[int] = set()
    for start in range(count):
        if start in met:
            continue
        group, waiting = SeamGroup({start: False}), [start]
        while waiting:
            seam = waiting.pop()
            for other, is_turned in turns.get(seam, ()):
                wanted = group.turned[seam] != is_turned
                if other not in group.turned:
                    group.turned[other] = wanted
                    waiting.append(other)
                elif group.turned[other] != wanted:
                    group.is_symmetric = True
        met |= set(group.turned)
        groups.append(group)
    return groups


def drawn_once(pieces: Sequence[PatternPiece], copies: Copies) -> list[PatternPiece]:
    """Return the pieces without those that mirrors make. pieces: all of them, each to be cut once as drawn."""
    drawn = []
    for index, piece in enumerate(pieces):
        if index in copies.left_out:
            continue
        own = piece
        if index in copies.pairs:
            second, mirror = copies.pairs[index]
            own = replace(own, quantity=(1, 1), mirrored_name=pieces[second].name, deviation=mirror.deviation)
        if index in copies.folds:
            fold, mirror = copies.folds[index]
            own = replace(folded(own, fold), deviation=max(own.deviation, mirror.deviation))
        drawn.append(own)
    return drawn
