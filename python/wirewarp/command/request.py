# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked for of one model."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from ..pattern.nest.items import Grain

MILLIMETERS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
Orientation = Literal["wire", "boundary", "up", "best"]  # as Options knows them
FROM_MODEL = ("uv", "sharp")


@dataclass(frozen=True)
class MarkerRequest:
    """What the pieces are cut from, in millimeters, and how; see Pattern.nested."""

    width: float
    length: float | None
    gap: float
    grain: Grain
    times: int
    seconds: float


@dataclass(frozen=True)
class MaterialRequest:
    """What the pieces are made of and how they lie on it; see Options. The thickness is in millimeters."""

    cloth: str  # of Cloth.preset, or "" for none
    orientation: Orientation
    stretch: tuple[float, float]  # across and along the grain, as shares
    thickness: float
    surface: Literal["inside", "middle", "outside"]


@dataclass(frozen=True)
class ModelRequest:
    """One model, and what its flat pieces depend on."""

    model: Path
    seams: str  # "uv", "sharp", a path, or "" for none
    wires: str  # a path, or "" for none
    unit: str
    material: MaterialRequest


@dataclass(frozen=True)
class CutRequest(ModelRequest):
    """Where to cut it. Lengths are in millimeters."""

    no_seam: str  # a path, or "" for none
    kind: Literal["dart", "seam"]
    piece: int | None  # from 1; None for any
    count: int | None  # None: as many as the library proposes
    strain: float | None  # None: as the library has it
    longest: float | None
    together: int | None  # cuts that are taken together at most; None: each is one by itself


@dataclass(frozen=True)
class Request(ModelRequest):
    """What is written of it, and where. Lengths are in millimeters."""

    folder: Path
    formats: tuple[str, ...]
    page: str | float
    allowance: float
    hem: float | None
    pairs: bool
    on_fold: bool
    imperial: bool
    marker: MarkerRequest | None
    picture: bool
    blender: str  # the program, for .blend files
    resume: bool
    repair: bool
    take_proposals: bool
    refusal: str = ""  # why it cannot be done beside the other requests

    @property
    def report_path(self) -> Path:
        return self.folder / f"{self.model.stem}.json"

    def pattern_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}.{kind}"

    @property
    def picture_path(self) -> Path:
        """Not NAME.png, which many models have as their texture."""
        return self.folder / f"{self.model.stem}-strain.png"

    def marker_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}-marker.{kind}"

    @property
    def all_paths(self) -> list[Path]:
        """What may be written, but for the names of several objects of Blender, which only the file has."""
        drawn = [path(kind) for kind in self.formats for path in (self.pattern_path, self.marker_path)]
        return [*drawn, self.picture_path, self.report_path]

    @property
    def line_files(self) -> list[Path]:
        """The files that seams and wires are read from."""
        return [Path(name) for name in self.lines if name not in ("", *FROM_MODEL)]

    @property
    def lines(self) -> tuple[str, str]:
        return self.seams, self.wires


AnyRequest = Request | CutRequest
