# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the report as dataclasses. Names of fields are the keys of the JSON form.

- lengths and areas: in units of the model
- indices of elements: elements of the model
- missing numbers: None, for example without a layout
"""

import math
from dataclasses import dataclass, field
from typing import Any

Pairs = list[tuple[int, int]]  # edges as vertex pairs
ANY_FABRIC = 0.03  # a stretch that every fabric allows: the maximum stretch of woven cotton, the least of all presets
WAYS = ("across", "along")  # directions of a fabric: across and along the grain

METHOD_NAMES = {"refined": "Refined", "wirewarp++": "WireWarping++", "wirewarping": "WireWarping, all wires rigid"}


@dataclass(kw_only=True)
class Lengths:
    """The lengths of a line: on the model, and on each of its flat sides. A seam has several sides, other lines one."""

    length_3d: float | None
    length_2d: list[float | None]  # flat lengths, one per side
    length_asked: list[float | None]  # target lengths with ease, tolerance and fabric, one per side

    @property
    def difference(self) -> list[float | None]:
        """Return the flat length minus the length on the model, one per side."""
        model = self.length_3d
        return [None if flat is None or model is None else flat - model for flat in self.length_2d]

    @property
    def percent(self) -> list[float | None]:
        """Return the difference as a percentage of the length on the model, one per side."""
        return [
            100 * each / self.length_3d if self.length_3d and each is not None else None for each in self.difference
        ]

    def asked_ease(self, side: int = 0) -> float | None:
        """Return the target change of a side's length, as a fraction of the length on the model. Negative ease is below
        0."""
        asked = self.length_asked[side]
        return asked / self.length_3d - 1 if asked and self.length_3d else None


@dataclass(kw_only=True)
class WirePart(Lengths):
    """A part of a wire in one piece. A wire has several parts if it crosses outlines."""

    name: str
    wire: int  # index in Report.wires
    part: int | None  # index of the part; None for the whole wire
    kind: str
    tolerance: float  # as a fraction; inf for a free wire
    ease: float
    ok: bool
    at_limit: bool  # whether an elastic wire has changed by its whole tolerance


@dataclass(kw_only=True)
class Wire(WirePart):
    vertices: list[int]
    wire_id: int = 0  # id of the mark in Blender; 0 elsewhere
    marked_id: int = 0  # id on its edges in Blender; copies of a wire have the same id


@dataclass(kw_only=True)
class HelperWire(Lengths):
    """A free wire that WireWarp has added to the wires of the user."""

    variation: float | None


@dataclass(kw_only=True)
class Chain(Lengths):
    """A section of a piece's outline between two junctions."""

    seam: int | None  # index in Report.seams; None for an open edge, such as a hem
    vertices: list[int]
    ok: bool


@dataclass(kw_only=True)
class Seam(Lengths):
    index: int
    name: str
    seam_id: int = 0  # id of the seam in Blender; 0 elsewhere
    is_dart: bool
    pieces: list[int]  # index of the piece of each side
    edges: Pairs
    variation: float | None  # common change of all sides, as a fraction of the length on the model
    eases: list[float | None]  # additional change of each side, as a fraction
    mismatch: float | None
    ok: bool


@dataclass(kw_only=True)
class Ways:
    """Stretch across and along the grain, as fractions of the flat length. None means unknown."""

    across: float | None
    along: float | None


@dataclass(kw_only=True)
class Threads:
    """Strain of a fabric's threads in a piece. In 99% of the piece's area, the strain is at most these figures."""

    cloth: str  # name of the fabric in sentences
    across: float  # stretch of the threads across the grain, as a fraction
    along: float
    shear: float  # radians by which the angle between the threads differs from a right angle
    gives: Ways  # maximum stretch of the fabric
    worn: Ways  # intended stretch when worn, for which the pieces are already cut smaller

    @property
    def over(self) -> bool:
        """Return whether the fabric must stretch further than its limit in any direction."""
        return self.is_over("across") or self.is_over("along")

    @property
    def excess(self) -> float:
        """Return the needed stretch minus the limit, in the worse direction. The result is above 0 if `over` is
        true."""
        return max(map(self._excess, WAYS))

    @property
    def shown(self) -> float:
        """Return the figure to show: the stretch in the direction that exceeds its limit most. If neither direction
        exceeds its limit, return the larger stretch."""
        worse: float = getattr(self, max(WAYS, key=self._excess))
        return worse if self.over else max(self.across, self.along)

    def _excess(self, way: str) -> float:
        needed: float = getattr(self, way)
        return needed - self.limit(way)

    def is_over(self, way: str) -> bool:
        return self._excess(way) > 0

    def limit(self, way: str) -> float:
        """Return the maximum stretch in a direction, as a fraction. If it is unknown, return the built-in stretch
        combined with the stretch that every fabric allows."""
        known: float | None = getattr(self.gives, way)
        return known if known is not None else (1 + (getattr(self.worn, way) or 0.0)) * (1 + ANY_FABRIC) - 1


@dataclass(kw_only=True)
class Piece:
    index: int
    name: str
    piece_id: int = 0  # id of the piece in Blender; 0 elsewhere
    ok: bool  # whether all guarantees are met
    has_layout: bool
    faces: int
    triangles: int
    area_3d: float | None
    area_2d: float | None
    arap_energy: float | None
    cloth_energy: float | None
    stretch: float | None  # stretch_figure() in strain.py; with a fabric, the larger of Threads.across and along
    aspect_ratio_max: float | None
    stretch_max: float | None  # largest stretch of a triangle
    stretch_faces: list[int]  # faces around the triangle with the largest stretch
    ease_max: float | None  # largest compression of a triangle
    ease_faces: list[int]  # faces around the triangle with the largest compression
    angle_deviation_rms: float | None
    angle_deviation_max: float | None
    flipped_faces: int
    overlapping_faces: int
    wires: list[WirePart]
    helper_wires: list[HelperWire]
    outline: list[Chain]
    threads: Threads | None
    termination: str
    message: str
    warnings: list[str]
    start: str
    inner_solves: int
    outer_iterations: int
    gradient_evaluations: int
    factorizations: int
    constraint_residual: float | None
    objective: float | None

    @property
    def is_strained(self) -> bool:
        """Return whether lengths are kept, but the piece needs too much stretch.

        The limit is the maximum stretch of the chosen fabric. If none is chosen, it is the stretch that every fabric
        allows.
        """
        return self.ok and (self.threads.over if self.threads else self.needed > ANY_FABRIC)

    @property
    def excess(self) -> float:
        """Return the needed stretch minus the limit of is_strained. Lists begin with the largest excess."""
        return self.threads.excess if self.threads else self.needed - ANY_FABRIC

    @property
    def shown(self) -> float:
        """Return the stretch that lists of pieces and the verdict show, as a fraction."""
        return self.threads.shown if self.threads else self.needed

    @property
    def needed(self) -> float:
        """Return `stretch`, or inf if the layout is missing or collapsed."""
        return math.inf if self.stretch is None else self.stretch


@dataclass(frozen=True, kw_only=True)
class LooserWire:
    """A proposed tolerance for a wire, so that all wires of the piece can have their lengths."""

    name: str
    tolerance: float
    edges: Pairs


@dataclass(frozen=True)
class Issue:
    """A fault in one sentence, with the faulty elements of the model.

    code: a wirewarp.ErrorCode, or a code of the program that makes the report.
    """

    code: str
    sentence: str
    piece: int | None = None
    vertices: list[int] = field(default_factory=list)
    edges: Pairs = field(default_factory=list)
    faces: list[int] = field(default_factory=list)
    wires: list[int] = field(default_factory=list)  # indices of the wires that the sentence names
    proposed_seams: Pairs = field(default_factory=list)  # edges; if these become seams, the piece can be flattened
    proposed_tolerances: list[LooserWire] = field(default_factory=list)
    both_sides: bool = False  # whether the proposal is for this piece and its mirror image

    @property
    def has_place(self) -> bool:
        return bool(self.vertices or self.edges or self.faces)


@dataclass(frozen=True)
class Hint(Issue):
    """A sentence on how to improve a good piece, with its place."""

    short: str = ""  # the sentence without its advice, for a list below the advice
    wire: int | None = None  # index in Report.wires of the wire whose name precedes the sentence


@dataclass(frozen=True)
class Note:
    text: str
    is_warning: bool = False
    piece: int | None = None  # index of the piece whose name precedes the text


@dataclass(kw_only=True)
class Report:
    """The report of one model."""

    object: str = ""  # the model's name
    meters: float = 1.0  # meters in a unit of the model
    method: str = ""  # "" if nothing was flattened
    pieces: list[Piece] = field(default_factory=list)
    seams: list[Seam] = field(default_factory=list)
    wires: list[Wire] = field(default_factory=list)
    issues: list[Issue] = field(default_factory=list)
    hints: list[Hint] = field(default_factory=list)
    notes: list[Note] = field(default_factory=list)
    reused_pieces: int = 0
    seconds: dict[str, Any] = field(default_factory=dict)

    @property
    def ok(self) -> bool:
        """Return whether all guarantees are met in all pieces."""
        return not self.issues

    @property
    def method_name(self) -> str:
        return METHOD_NAMES.get(self.method, "")
