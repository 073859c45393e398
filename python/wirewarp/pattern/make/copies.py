# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws pieces of equal shape once, even if they are mirrored, and only half of each symmetric piece.

Seams that copies map to each other get notches at the same places, so that copies match.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, combinations

import numpy as np

from ..model import PatternPiece
from .fold import ALONG, folded
from .mirror import ALIKE, Congruence, congruences, fold_of
from .outline import Side
from .pieces import Laid
from .seams import SewnSide, fixed_starts, row_of


@dataclass(frozen=True)
class Copies:
    """Copies and folds, by the index of the drawn piece."""

    # These are the other pieces of equal shape, each with its map to the drawn piece.
    others: dict[int, list[tuple[int, Congruence]]]
    folds: dict[int, tuple[np.ndarray, Congruence]]  # the fold (2,2), and the reflection that maps the piece to itself
    # The keys are seams that are sewn along whole outlines. The values are the vertices of the model at which these
    # seams begin. Copies map these starts to each other.
    starts: dict[int, int]

    @property
    def left_out(self) -> set[int]:
        """Return the indices of the pieces that are not drawn, because a copy is drawn for them."""
        return {other for others in self.others.values() for other, _ in others}


def copies_of(laid: Sequence[Laid], pieces: Sequence[PatternPiece], pairs: bool, on_fold: bool) -> Copies:
    """Return the copies and folds to draw.

    - pieces: the pieces of `laid` with their lines
    - pairs: whether pieces of equal shape are drawn once
    - on_fold: whether symmetric pieces are drawn as halves
    """
    found = Copies({}, {}, fixed_starts(side for own in laid for loop in own.loops for side in loop))

    def maps(first: int, second: int, *, is_mirror: bool) -> Iterator[Congruence]:
        """Yield the maps from the second piece to the first that keep the grain, and then the maps that reverse the
        grain."""
        reversing: list[Congruence] = []
        for each in congruences(pieces[first], pieces[second], is_mirror=is_mirror):
            grain, own = each.direction(laid[second].grain), laid[first].grain
            if abs(grain[0] * own[1] - grain[1] * own[0]) < ALONG:
                if grain @ own > 0:
                    yield each
                else:
                    reversing.append(each)
        yield from reversing

    def fits(first: int, second: int, each: Congruence) -> bool:
        """Return whether the map takes seams to seams and their starts to starts. If it does, store the starts."""
        begun, sewn = dict(found.starts), set()
        for side, image, sources in _matched(laid[first], laid[second], each):
            if side.seam is None or image.seam is None:
                continue
            sewn |= {id(side), id(image)}
            if not side.is_closed:
                continue
            start = begun.setdefault(side.seam, int(side.sources[row_of(side, begun.get(side.seam))]))
            mapped = int(sources[row_of(side, start)])
            if begun.setdefault(image.seam, mapped) != mapped:
                return False
        if any(id(side) not in sewn for index in (first, second) for side in _sewn_sides(laid[index])):
            return False
        found.starts.update(begun)
        return True

    left_out: set[int] = set()
    # Pieces with a seam along a whole outline are tried last, because several maps often fit them. The maps of their
    # neighbors determine where this seam begins, and only one map fits this start.
    order = sorted(range(len(pieces)), key=lambda index: any(side.is_closed for side in _sewn_sides(laid[index])))
    for first, second in combinations(order, 2) if pairs else ():
        if first in left_out or second in left_out:
            continue
        found_maps = chain(maps(first, second, is_mirror=False), maps(first, second, is_mirror=True))
        first_map = next((each for each in found_maps if fits(first, second, each)), None)
        if first_map:
            found.others.setdefault(first, []).append((second, first_map))
            left_out.add(second)
    for index, piece in enumerate(pieces) if on_fold else ():
        if piece.on_fold or index in left_out:
            continue
        folds = ((fold_of(piece, mirror), mirror) for mirror in maps(index, index, is_mirror=True))
        first_fold = next(((fold, each) for fold, each in folds if fold is not None and fits(index, index, each)), None)
        if first_fold:
            found.folds[index] = first_fold
    return found


def _sewn_sides(laid: Laid) -> list[Side]:
    return [side for loop in laid.loops for side in loop if side.seam is not None]


@dataclass
class SeamGroup:
    """Seams that copies map to each other, and that have notches at the same places."""

    turned: dict[int, bool]  # by seam: whether places are measured from its end instead of its start
    is_symmetric: bool = False  # whether copies map a seam to itself with its ends exchanged


@dataclass(frozen=True)
class CopiedSides:
    """The sides of seams that copies map to each other."""

    groups: list[SeamGroup]
    images: dict[int, list[Side]] = field(default_factory=dict)  # images of each side, by the id() of the side

    def copies(self, side: Side) -> list[Side]:
        """Return the side and all sides that are drawn as this side, including images of images."""
        found = [side]
        for own in found:
            found += [image for image in self.images.get(id(own), ()) if all(image is not other for other in found)]
        return found


def copied_sides(copies: Copies, laid: Sequence[Laid], seams: Sequence[Sequence[SewnSide]]) -> CopiedSides:
    forward = {id(own.side): own.is_forward for sides in seams for own in sides}
    # The keys are seams. The values are the seams to which copies map the key, and whether the image is reversed.
    turns: dict[int, list[tuple[int, bool]]] = defaultdict(list)
    images: dict[int, list[Side]] = defaultdict(list)
    maps = [(first, second, each) for first, others in copies.others.items() for second, each in others]
    maps += [(index, index, mirror) for index, (_, mirror) in copies.folds.items()]
    for first, second, each in maps:
        for side, image, _ in _matched(laid[first], laid[second], each):
            a, b = side.seam, image.seam
            if a is None or b is None:
                continue
            # A reflection reverses the direction of outlines, so it exchanges the ends of their seams.
            is_turned = (forward[id(side)] == forward[id(image)]) == each.is_mirror
            turns[a].append((b, is_turned))
            turns[b].append((a, is_turned))
            images[id(side)].append(image)
            images[id(image)].append(side)
    return CopiedSides(_groups(len(seams), turns), images)


def _matched(first: Laid, second: Laid, found: Congruence) -> list[tuple[Side, Side, np.ndarray]]:
    """Return the matches of sides of the first piece with images of sides of the second piece.

    A match has both sides, and the second side's vertices (k,) in the order of the first side.
    """
    matched = []
    for side in (side for loop in first.loops for side in loop):
        for other in (side for loop in second.loops for side in loop):
            if len(other.points) != len(side.points) or other.is_closed != side.is_closed:
                continue
            image = found.of_outline(other.points)
            sources = other.sources[::-1] if found.is_mirror else other.sources
            if side.is_closed:
                start = int(np.abs(image[:-1] - side.points[0]).sum(axis=1).argmin())
                image, sources = (np.concatenate([rows[start:-1], rows[: start + 1]]) for rows in (image, sources))
            if np.abs(image - side.points).max() <= ALIKE:
                matched.append((side, other, sources))
    return matched


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
    """Return the pieces to draw, with their quantities and folds. pieces: all pieces, each to be cut once as drawn."""
    left_out, drawn = copies.left_out, []
    for index, piece in enumerate(pieces):
        if index in left_out:
            continue
        others = copies.others.get(index, [])
        mirrored = sum(each.is_mirror for _, each in others)
        own = replace(
            piece,
            quantity=(1 + len(others) - mirrored, mirrored),
            copied_names=tuple(pieces[other].name for other, _ in others),
            deviation=max([piece.deviation, *(each.deviation for _, each in others)]),
        )
        if index in copies.folds:
            fold, mirror = copies.folds[index]
            own = replace(folded(own, fold), deviation=max(own.deviation, mirror.deviation))
        drawn.append(own)
    return drawn
