# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes DXF of AutoCAD release 12, which every reader supports: group codes and values on alternate lines."""

import re
import unicodedata
from collections.abc import Iterable
from typing import Any

import numpy as np


def plain_text(text: str) -> str:
    """Return the text in ASCII, without accents, and with a question mark for each letter that ASCII lacks."""
    letters = unicodedata.normalize("NFKD", text.replace("ß", "ss"))
    kept = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return re.sub(r"[^\x20-\x7e]", "?", kept)


def escaped_text(text: str) -> str:
    r"""Return the text in ASCII, without accents, and with AutoCAD's escapes such as \U+8896 for other letters."""
    escaped = [f"\\U+{ord(letter):04X}" if ord(letter) < 0x10000 else "?" for letter in text]
    plain = [plain_text(letter) for letter in text]
    return "".join(
        code if "?" in kept and letter != "?" else kept for letter, kept, code in zip(text, plain, escaped, strict=True)
    )


def block_names(names: list[str], longest: int) -> list[str]:
    """Return unique block names of at most `longest` capitals, digits and underscores. If no letter of the third
    piece's name can be used, its block is PIECE_3."""
    found: list[str] = []
    for number, name in enumerate(names, start=1):
        plain = re.sub(r"[^A-Z0-9]+", "_", plain_text(name).upper()).strip("_")[:longest] or f"PIECE_{number}"
        free, again = plain, 2
        while free in found:
            free, again = f"{plain[: longest - 1 - len(str(again))]}_{again}", again + 1
        found.append(free)
    return found


class Tags:
    """Entities of a file or of a block. decimals: decimals of coordinates; scale: units of the file in a millimeter."""

    def __init__(self, decimals: int, scale: float = 1.0) -> None:
        self._lines: list[str] = []
        self._decimals, self._scale = decimals, scale

    def add(self, *pairs: tuple[int, Any]) -> None:
        for code, value in pairs:
            self._lines += [f"{code:3d}", str(value)]

    def add_all(self, other: "Tags") -> None:
        self._lines += other._lines

    def number(self, millimeters: float) -> str:
        return f"{round(float(millimeters) * self._scale, self._decimals) + 0.0:.{self._decimals}f}"  # + 0.0 avoids -0

    def at(self, point: np.ndarray, first: int = 10, z: float | None = None) -> list[tuple[int, str]]:
        """Return the pairs (group code, value) of a point (2,). first: group code of x."""
        pairs = [(first, self.number(point[0])), (first + 10, self.number(point[1]))]
        return pairs if z is None else [*pairs, (first + 20, self.number(z))]

    def polyline(self, layer: str, points: np.ndarray, closed: bool, repeat: bool = False) -> None:
        """Add a polyline. repeat: whether a closed line repeats its first point at the end, for readers that ignore the
        closed flag."""
        corners = np.concatenate([points, points[:1]]) if closed and repeat else points
        self.add((0, "POLYLINE"), (8, layer), (66, 1), (70, int(closed)), *self.at(np.zeros(2), z=0.0))
        for corner in corners:
            self.add((0, "VERTEX"), (8, layer), *self.at(corner))
        self.add((0, "SEQEND"), (8, layer))

    def line(self, layer: str, points: np.ndarray) -> None:
        self.add((0, "LINE"), (8, layer), *self.at(points[0]), *self.at(points[1], 11))

    def text(self, layer: str, text: str, at: np.ndarray, height: float, angle: float = 0.0) -> None:
        turned = [(50, f"{angle:.2f}")] if angle else []
        self.add((0, "TEXT"), (8, layer), *self.at(at), (40, self.number(height)), (1, text), *turned)

    def data(self) -> str:
        return "\n".join(self._lines) + "\n"


def section(name: str, content: Iterable[Tags], decimals: int = 4) -> Tags:
    tags = Tags(decimals)
    tags.add((0, "SECTION"), (2, name))
    for each in content:
        tags.add_all(each)
    tags.add((0, "ENDSEC"))
    return tags
