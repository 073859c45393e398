# SPDX-License-Identifier: GPL-3.0-or-later
"""Orders the letters of a line with several directions, by Unicode's bidirectional algorithm (UAX 9).

HarfBuzz needs runs of one direction. Explicit formatting characters are not interpreted, because names do not contain
them.
"""

import unicodedata
from collections.abc import Iterator, Sequence
from typing import TypeVar

STRONG, NUMBERS, SEPARATORS = ("L", "R", "AL"), ("EN", "AN"), ("ES", "CS")
T = TypeVar("T")


def levels(letters: Sequence[str]) -> list[int]:
    """Return the embedding level of each letter. Letters with even levels run from left to right, letters with odd
    levels from right to left."""
    kinds = [unicodedata.bidirectional(letter) for letter in letters]
    base = int(next((kind for kind in kinds if kind in STRONG), "L") != "L")
    outer = "LR"[base]
    weak = _weak(kinds, outer)
    _settle_brackets(letters, kinds, weak, outer)
    found = [base + _above(base, kind) for kind in _neutral(weak, outer)]
    for row in range(len(letters) - 1, -1, -1):  # rule L1: spaces at the end get the direction of the line
        if kinds[row] not in ("WS", "BN"):
            break
        found[row] = base
    return found


def in_visual_order(runs: Sequence[T], run_levels: Sequence[int]) -> list[T]:
    """Return the runs in their order from left to right. By rule L2, sequences of runs are reversed once for each
    level: from the highest level to 1, each sequence of runs with at least this level."""
    order = list(range(len(runs)))
    for level in range(max(run_levels, default=0), 0, -1):
        begin = None
        for place in range(len(order) + 1):
            if place < len(order) and run_levels[order[place]] >= level:
                begin = place if begin is None else begin
            elif begin is not None:
                order[begin:place] = order[begin:place][::-1]
                begin = None
    return [runs[number] for number in order]


def _above(base: int, kind: str) -> int:
    """Return the difference between the level of a letter and the level of its line, by rules I1 and I2."""
    if base == 0:
        return {"R": 1, "EN": 2, "AN": 2}.get(kind, 0)
    return int(kind != "R")


def _weak(kinds: Sequence[str], outer: str) -> list[str]:
    """Return the classes after rules W1 to W7, which resolve numbers and the signs that belong to numbers."""
    found = list(kinds)
    strong, before = outer, outer
    for row, kind in enumerate(kinds):
        kind = before if kind in ("NSM", "BN") else kind
        strong = kind if kind in STRONG else strong
        before = found[row] = "AN" if kind == "EN" and strong == "AL" else kind
    found = ["R" if kind == "AL" else kind for kind in found]
    for row in range(1, len(found) - 1):
        first, sign, last = found[row - 1 : row + 2]
        if sign in SEPARATORS and first == last and (first == "EN" or (first == "AN" and sign == "CS")):
            found[row] = first
    for begin, end in _spans(found, ("ET",)):
        if "EN" in found[max(begin - 1, 0) : begin] + found[end : end + 1]:
            found[begin:end] = ["EN"] * (end - begin)
    strong = outer
    for row, kind in enumerate(found):
        strong = kind if kind in STRONG else strong
        if kind == "EN" and strong == "L":
            found[row] = "L"
        elif kind in ("ET", *SEPARATORS):
            found[row] = "ON"
    return found


def _settle_brackets(letters: Sequence[str], kinds: Sequence[str], weak: list[str], outer: str) -> None:
    """Apply rule N0 to `weak`: both brackets of a pair get the direction of the letters inside or before the pair."""
    for begin, end in sorted(_bracket_pairs(letters, weak)):
        inside = {_direction(kind) for kind in weak[begin + 1 : end]}
        if outer in inside:
            direction = outer
        elif inside - {""}:
            direction = next((_direction(kind) for kind in weak[begin - 1 :: -1] if _direction(kind)), outer)
            direction = direction if begin else outer
        else:
            continue
        for place in (begin, end):
            weak[place] = direction
            for row in range(place + 1, len(kinds)):
                if kinds[row] != "NSM":
                    break
                weak[row] = direction


def _bracket_pairs(letters: Sequence[str], weak: Sequence[str]) -> Iterator[tuple[int, int]]:
    opened: list[tuple[int, str]] = []
    for row, letter in enumerate(letters):
        if weak[row] != "ON" or not unicodedata.mirrored(letter):
            continue
        if unicodedata.category(letter) == "Ps":
            opened.append((row, _closing(letter)))
        elif unicodedata.category(letter) == "Pe" and letter in (closing for _, closing in opened):
            while True:
                begin, closing = opened.pop()
                if closing == letter:
                    yield begin, row
                    break


def _closing(bracket: str) -> str:
    """Return the closing bracket, which Unicode lists one or two places after the opening bracket."""
    following = (chr(ord(bracket) + step) for step in (1, 2))
    return next((letter for letter in following if unicodedata.category(letter) == "Pe"), "")


def _neutral(weak: Sequence[str], outer: str) -> list[str]:
    """Return the classes after rules N1 and N2: spaces and signs get the direction of their neighbors if both neighbors
    have the same direction, otherwise the direction of the line."""
    found = list(weak)
    for begin, end in _spans(weak, ("B", "S", "WS", "ON")):
        before = _direction(found[begin - 1]) if begin else outer
        after = _direction(weak[end]) if end < len(weak) else outer
        found[begin:end] = [before if before == after else outer] * (end - begin)
    return found


def _direction(kind: str) -> str:
    return "R" if kind in NUMBERS else kind if kind in ("L", "R") else ""


def _spans(kinds: Sequence[str], wanted: Sequence[str]) -> Iterator[tuple[int, int]]:
    """Yield the start and the end of each run of the wanted classes."""
    begin = None
    for row in range(len(kinds) + 1):
        if row < len(kinds) and kinds[row] in wanted:
            begin = row if begin is None else begin
        elif begin is not None:
            yield begin, row
            begin = None
