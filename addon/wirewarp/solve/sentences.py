# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's sentences, said in the words of Blender's users."""

import re
from collections.abc import Sequence

import numpy as np

from ..words import LengthText, counted

NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
# "vertex 3", "faces 1, 2 and 12 more", "edge 3-7"; all numbers but the last, the last, whether it counts others.
LISTED = r"\b([Vv]ert(?:ex|ices)|[Ee]dges?|[Ff]aces?) ((?:\d+(?:-\d+)?(?:, | and ))*)(\d+(?:-\d+)?)( more)?\b"
PLURALS = {"vertex": "vertices", "edge": "edges", "face": "faces"}


def name_elements(sentence: str, triangle_polygons: np.ndarray, faces: Sequence[int], wire_names: list[str]) -> str:
    """The sentence with "face(s) 3, 4 and 12 more" in polygons instead of triangles, and wires by their names.

    faces: all polygons the sentence is about, from which "12 more" is counted anew.
    """

    def translate(match: re.Match) -> str:
        noun, listed, more = match.groups()
        numbers = [int(number) for number in re.findall(r"\d+", listed)]
        hidden = numbers.pop() if more else 0
        if noun.lower() == "wire":
            names = [f'"{wire_names[number]}"' for number in numbers]
        else:
            polygons = list(dict.fromkeys(int(triangle_polygons[number]) for number in numbers))
            hidden = len(set(faces) - set(polygons)) if more else 0
            names = [str(polygon) for polygon in polygons]
        return _list(noun, names + ([f"{hidden} more"] if hidden else []))

    # The library adds some wires' names itself, in brackets; they are swallowed, and never read as numbers.
    names = "|".join(map(re.escape, sorted(wire_names, key=len, reverse=True)))
    return re.sub(
        rf"\b([Ff]ace|[Ww]ire)s? (\d+(?:, \d+)*(?: and \d+)?)( more)?(?: \((?:{names})\))?", translate, sentence
    )


def count_faces(sentence: str, counts: Sequence[tuple[int, int]]) -> str:
    """The sentence with its "12 faces" or "12 triangles" in polygons.

    counts: (triangles, polygons) of all that may be counted in it. A number that is not one of those, or could be two
    of them, is said to be one of triangles.
    """

    def translate(match: re.Match) -> str:
        number, kind = int(match[1]), match[2] or ""
        polygons = {polygons for triangles, polygons in counts if triangles == number}
        count, noun = (polygons.pop(), "face") if len(polygons) == 1 else (number, "triangle")
        return counted(count, f"{kind}{noun}")

    return re.sub(r"\b(\d+) (flipped |overlapping )?(?:face|triangle)s?\b", translate, sentence)


def _list(noun: str, names: list[str]) -> str:
    if len(names) == 1:
        return f"{noun} {names[0]}"
    return f"{noun}s {', '.join(names[:-1])} and {names[-1]}"


def plain_sentence(sentence: str, units: LengthText) -> str:
    """Of an issue: a piece's name stands before its sentence, and a button shows the elements, which are counted."""
    parts = re.split(r'("[^"]*")', sentence)
    return "".join(part if part.startswith('"') else _plain(part, units) for part in parts)  # names stay as they are


def _plain(sentence: str, units: LengthText) -> str:
    sentence = re.sub(r"\b([Tt]he piece) around face \d+(?: \(\d+ (?:face|triangle)s?\))?", r"\1", sentence)
    sentence = re.sub(rf" \(a distortion of at least {NUMBER}\)", "", sentence)
    sentence = re.sub(rf"such as (?:along )?{LISTED}", "such as the proposed one", sentence)
    sentence = re.sub(r"\blong at vertex \d+", "long", sentence)
    sentence = re.sub(rf"\b{NUMBER} (?:units )?long\b", lambda match: f"{units.rough(float(match[1]))} long", sentence)
    sentence = re.sub(rf" long(?=(?:,| and) {NUMBER} \S+ long\b)", "", sentence)
    too_short = rf"\b(outline(s?), .*,) can hold no more than {NUMBER}% of its area in the plane"
    sentence = re.sub(too_short, _short, sentence)
    sentence = sentence.replace("not all finite and below 1e60 in magnitude", "not numbers, or far too large")
    return re.sub(LISTED, _counted, sentence)


def _short(match: re.Match) -> str:
    outlines, plural, _ = match.groups()
    return f"{outlines} {'are' if plural else 'is'} too short to lie around it"


def _counted(match: re.Match) -> str:
    noun, others, last, more = match.groups()
    singular = "vertex" if noun.lower() == "vertices" else noun.lower().removesuffix("s")
    count = len(re.findall(r", | and ", others)) + (int(last) if more else 1)
    text = f"{count} {PLURALS[singular]}" if count > 1 else f"one {singular}"
    return text[0].upper() + text[1:] if noun[0].isupper() else text
