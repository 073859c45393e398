# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mirror makes need not be drawn: one piece of each mirrored pair, and one half of a symmetric piece.

Notches stand at the same places on seams that a mirror lays onto each other, or a mirrored copy would not fit.
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
    """By index of the piece."""

    pairs: dict[int, tuple[int, Mirror]]  # of the first piece of a pair: the second, and what lays it onto the first
    folds: dict[int, tuple[np.ndarray, Mirror]]  # the fold (2,2), and what lays the piece onto itself

    @property
    def left_out(self) -> set[int]:
        """The pieces that are not drawn."""
        return {second for second, _ in self.pairs.values()}


def copies_of(laid: Sequence[Laid], pieces: Sequence[PatternPiece], pairs: bool, on_fold: bool) -> Copies:
    """pieces: those of laid, with their lines. Each is in one pair at most, and one with a fold is not folded again."""
    found = Copies({}, {})

    def mirrors(first: int, second: int) -> Iterator[Mirror]:
        """Those that keep the grain, or turn it end for end."""
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
    """Seams whose notches stand at the same places."""

    turned: dict[int, bool]  # by seam: whether places count from its other end than those of the first seam
    is_symmetric: bool = False  # a mirror lays a seam onto itself, end for end


@dataclass(frozen=True)
class MirroredSides:
    """What the mirrors do to the sides of seams."""

    groups: list[SeamGroup]
    images: dict[int, list[Side]] = field(default_factory=dict)  # by the id() of a side, those that are laid onto it

    def copies(self, side: Side) -> list[Side]:
        """The side, and all sides that it is drawn for: images of images, too."""
        found = [side]
        for own in found:
            found += [image for image in self.images.get(id(own), ()) if all(image is not other for other in found)]
        return found


def mirrored_sides(copies: Copies, laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]]) -> MirroredSides:
    forward = {id(own.side): own.is_forward for sides in seams for own in sides}
    turns: dict[int, list[tuple[int, bool]]] = defaultdict(list)  # by seam: others, and whether these run back
    images: dict[int, list[Side]] = defaultdict(list)
    mirrors = [(first, second, mirror) for first, (second, mirror) in copies.pairs.items()]
    mirrors += [(index, index, mirror) for index, (_, mirror) in copies.folds.items()]
    for first, second, mirror in mirrors:
        for side, image in _matched(laid[first], laid[second], mirror):
            a, b = side.seam, image.seam
            if a is None or b is None:
                continue
            is_turned = forward[id(side)] == forward[id(image)]  # outlines run the other way in a mirror
            turns[a].append((b, is_turned))
            turns[b].append((a, is_turned))
            images[id(side)].append(image)
            images[id(image)].append(side)
    return MirroredSides(_groups(len(seams), turns), images)


def _matched(first: Laid, second: Laid, mirror: Mirror) -> list[tuple[Side, Side]]:
    """The sides of the first piece, and those of the second whose images lie on them."""
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
    """Without what the mirrors make. pieces: all of them, each to be cut once as drawn."""
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
