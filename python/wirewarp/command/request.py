# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the request for one model, and the error for faulty input."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from ..pattern.nest.items import Grain
from ..pattern.units import INCH

MILLIMETERS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": INCH}
# Options.orientation also has the value "grain". It is missing here, because it needs a chosen wire.
Orientation = Literal["wire", "boundary", "up", "best"]
FROM_MODEL = ("uv", "sharp")
BLEND = ".blend"
READ_BY_TRIMESH = (".obj", ".ply", ".stl", ".gltf", ".glb")
SUFFIXES = (*READ_BY_TRIMESH, BLEND)


class InputError(Exception):
    """Raised for a fault of the input. str() is a sentence."""


@dataclass(frozen=True)
class MarkerRequest:
    """The arguments of Pattern.nested(). Lengths are in millimeters."""

    width: float
    length: float | None
    gap: float
    grain: Grain
    times: int
    seconds: float


@dataclass(frozen=True)
class MaterialRequest:
    """The material and the orientation of the pieces, as in Options. The thickness is in millimeters."""

    cloth: str  # a name for Cloth.preset, or "" for none
    orientation: Orientation
    stretch: tuple[float, float]  # across and along the grain, as fractions
    thickness: float
    surface: Literal["inside", "middle", "outside"]


@dataclass(frozen=True)
class ModelRequest:
    """One model, and all settings that change its flat pieces."""

    model: Path
    seams: str  # "uv", "sharp", a path, or "" for none
    wires: str  # a path, or "" for none
    unit: str
    material: MaterialRequest


@dataclass(frozen=True)
class CutRequest(ModelRequest):
    """A request for proposals of cuts. Lengths are in millimeters."""

    no_seam: str  # path of a file with lines along which no cut may run, or ""
    kind: Literal["dart", "seam", "fewer"]
    piece: int | None  # number of the piece, from 1; None for any piece
    count: int | None  # number of proposals; None for the library's default
    strain: float | None  # as a fraction; None for the library's default
    longest: float | None
    narrowest: float | None  # smallest width of the pieces of a set of seams; None for any width
    together: int | None  # largest number of cuts to make together; None if each cut is proposed alone


@dataclass(frozen=True)
class Request(ModelRequest):
    """A request to flatten a model and write files. Lengths are in millimeters."""

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
    blender: str  # the program to run for .blend files
    resume: bool
    repair: bool
    take_proposals: bool
    refusal: str = ""  # a sentence if this request conflicts with others

    @property
    def report_path(self) -> Path:
        return self.folder / f"{self.model.stem}.json"

    def pattern_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}.{kind}"

    @property
    def picture_path(self) -> Path:
        """Return the path. Its name is not NAME.png, because many models have a texture with that name."""
        return self.folder / f"{self.model.stem}-strain.png"

    def marker_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}-marker.{kind}"

    @property
    def all_paths(self) -> list[Path]:
        """Return the paths of all files that may be written, except the files of single objects in a .blend file. Only
        Blender knows these objects."""
        drawn = [path(kind) for kind in self.formats for path in (self.pattern_path, self.marker_path)]
        return [*drawn, self.picture_path, self.report_path]

    @property
    def line_files(self) -> list[Path]:
        return [Path(name) for name in self.lines if name not in ("", *FROM_MODEL)]

    @property
    def lines(self) -> tuple[str, str]:
        return self.seams, self.wires


AnyRequest = Request | CutRequest
