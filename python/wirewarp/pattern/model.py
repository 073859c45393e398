# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the parts of a pattern piece, for every kind of file. Lengths are in millimeters, and y points upwards."""

import re
from collections.abc import Collection
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from .geometry import Motion

LineRole = Literal["cut", "inner_cut", "sew", "wire", "grain", "fold", "card leader", "name leader"]
PointRole = Literal["notch", "drill", "clip"]
TextRole = Literal["card", "line name"]
# These are the roles of lines that lead to texts beside a piece.
LEADERS: dict[TextRole, LineRole] = {"card": "card leader", "line name": "name leader"}
KINDS = {  # parts that a maker may leave out of a file, with the roles of their lines, points and texts
    "sew": ("sew",),
    "wires": ("wire",),
    "grain": ("grain",),
    "notches": ("notch", "clip", "drill"),
    "texts": ("card", "card leader"),
    "line names": ("line name", "name leader"),
}
NUMBERED = re.compile("^Seam (?=[0-9 /]+$)")


def short_name(seam: str) -> str:
    """Return "3" for "Seam 3". Return other names unchanged, even "Dart 3", because darts have their own numbers."""
    return NUMBERED.sub("", seam)


@dataclass(frozen=True)
class Line:
    role: LineRole
    points: np.ndarray  # (k,2)
    closed: bool = False  # a closed line does not repeat its first point
    name: str = ""  # name of the seam (such as "Seam 3"), fold or wire
    width: float | None = None  # stitching lines: width of the allowance
    seam: int | None = None  # stitching lines: index into the result's seams; None if nothing is sewn to it
    joins: str = ""  # stitching lines: names of the other pieces that are sewn to the line
    kind: str = ""  # wires: "rigid", "elastic" or "super_elastic"
    note: str = ""  # stitching lines: a note such as "12 mm longer, ease between notches"

    @property
    def path(self) -> np.ndarray:
        """Return the points from the start to the end of the line. A closed line ends with its first point again."""
        return np.concatenate([self.points, self.points[:1]]) if self.closed else self.points

    def placed(self, motion: Motion) -> "Line":
        return replace(self, points=motion.points(self.points))


@dataclass(frozen=True)
class Point:
    """A mark at one place: a notch or clip, which is cut from the cutting line inwards, or a drill hole."""

    role: PointRole
    at: np.ndarray  # (2,); notches and clips begin here, on the cutting line
    direction: np.ndarray = field(default_factory=lambda: np.zeros(2))  # (2,) unit vector into the piece
    depth: float = 0.0  # depth of notches and clips, diameter of holes
    pair: tuple[int, int] | None = None  # seam, and number along the seam; notches of a pair are sewn onto each other
    along: float | None = None  # for pairs: length from the start of the seam, on the stitching line of this side
    side: int | None = None  # for pairs: index of the side of the seam

    def placed(self, motion: Motion) -> "Point":
        return replace(self, at=motion.points(self.at), direction=motion.directions(self.direction))

    @property
    def stroke(self) -> np.ndarray:
        """Return the ends (2,2) of the cut of a notch or clip, from the cutting line inwards."""
        return np.array([self.at, self.at + self.depth * self.direction])


@dataclass(frozen=True)
class Text:
    lines: tuple[str, ...]
    center: np.ndarray  # (2,)
    height: float  # height of the letters in millimeters
    angle: float = 0.0  # degrees counterclockwise
    role: TextRole = "card"
    is_beside: bool = False  # whether the text is outside the piece, because the piece has no room for the text

    def placed(self, motion: Motion) -> "Text":
        return replace(self, center=motion.points(self.center), angle=motion.text_angle(self.angle))


@dataclass(frozen=True)
class PatternPiece:
    number: int  # from 1
    name: str
    lines: list[Line]
    points: list[Point]
    texts: list[Text]
    quantity: tuple[int, int] = (1, 0)  # number of copies as drawn, and number of mirrored copies
    material: str = ""
    on_fold: bool = False  # whether only half of the piece is drawn; the other half is beyond the fold
    area: float = 0.0  # square millimeters inside the stitching lines of the whole piece
    copied_names: tuple[str, ...] = ()  # names of other pieces with the same shape, which are not drawn
    deviation: float = 0.0  # millimeters: largest distance between a copy and its own flattened shape
    allowances: tuple[float, ...] = ()  # the different widths of its allowances in millimeters, except 0

    def of_role(self, *roles: str) -> list[Line]:
        return [line for line in self.lines if line.role in roles]

    @property
    def quantity_text(self) -> str:
        """Return the quantity as a text for makers, such as "Cut 2", "Cut 1 pair" or "Cut 2 and 1 mirrored"."""
        as_drawn, mirrored = self.quantity
        if mirrored == as_drawn:
            return "Cut 1 pair" if as_drawn == 1 else f"Cut {as_drawn} pairs"
        return "Cut " + " and ".join([str(as_drawn)] * (as_drawn > 0) + [f"{mirrored} mirrored"] * (mirrored > 0))

    @property
    def bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the lowest and the highest corner (2,) of the cutting lines. Texts beside the piece may be outside."""
        points = np.concatenate([line.points for line in self.of_role("cut")])
        return points.min(axis=0), points.max(axis=0)

    @property
    def size(self) -> np.ndarray:
        """Return width and height (2,) of the cutting lines: the room that the piece needs on the fabric."""
        low, high = self.bounds
        return high - low

    def with_only(self, roles: Collection[str]) -> "PatternPiece":
        return replace(
            self,
            lines=[line for line in self.lines if line.role in roles],
            points=[point for point in self.points if point.role in roles],
            texts=[text for text in self.texts if text.role in roles],
        )

    def without_texts_beside(self) -> "PatternPiece":
        """Return the piece without the texts beside it and without the lines that lead to these texts."""
        return replace(
            self,
            lines=[line for line in self.lines if line.role not in LEADERS.values()],
            texts=[text for text in self.texts if not text.is_beside],
        )

    def moved(self, offset: np.ndarray) -> "PatternPiece":
        return self.placed(Motion(offset))

    def placed(self, motion: Motion) -> "PatternPiece":
        return replace(
            self,
            lines=[line.placed(motion) for line in self.lines],
            points=[point.placed(motion) for point in self.points],
            texts=[text.placed(motion) for text in self.texts],
        )
