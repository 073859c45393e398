# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's sentences number triangles and wires; people know Blender's faces and the wires' names. No Blender."""

import re
from collections.abc import Sequence

import numpy as np

from .words import counted


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
