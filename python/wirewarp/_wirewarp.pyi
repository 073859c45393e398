# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Final, Generic, Literal, TypeVar

import numpy as np
import numpy.typing as npt

from ._errors import FlattenError

__version__: str

class Cloth:
    def __init__(
        self,
        weft: float = 1.0,
        warp: float = 1.0,
        shear: float = 0.5,
        *,
        squeeze: float = 1.0,
        stretch: npt.ArrayLike = (0.0, 0.0),
        locking: float | None = None,
        limits: npt.ArrayLike | None = None,
    ) -> None: ...
    @staticmethod
    def preset(name: str) -> Cloth: ...
    @staticmethod
    def about(name: str) -> dict[str, str]: ...
    @staticmethod
    def presets() -> tuple[str, ...]: ...
    weft: Final[float]
    warp: Final[float]
    shear: Final[float]
    squeeze: Final[float]
    stretch: Final[tuple[float, float]]
    locking: Final[float | None]
    limits: Final[tuple[float, float] | None]
    def to_dict(self) -> dict[str, Any]: ...

class Options:
    method: Literal["wirewarping", "wirewarp++", "refined"]
    node_weight: Literal["length", "uniform"]
    inner: Literal["minimum", "least-norm"]
    fairness: float
    max_factorizations: int
    layout: Literal["packed", "row"]
    orientation: Literal["wire", "boundary", "up", "best", "grain"]
    grain: int
    @property
    def up(self) -> tuple[float, float, float]: ...
    @up.setter
    def up(self, value: npt.ArrayLike) -> None: ...
    gap: float
    mirror: bool
    @property
    def cloth(self) -> Cloth | None: ...
    @cloth.setter
    def cloth(self, value: Cloth | str | None) -> None: ...
    grain_angle: float
    thickness: float
    surface: Literal["inside", "middle", "outside"]
    def __init__(
        self,
        *,
        method: Literal["wirewarping", "wirewarp++", "refined"] = "refined",
        node_weight: Literal["length", "uniform"] = "length",
        inner: Literal["minimum", "least-norm"] = "minimum",
        fairness: float = 0.05,
        max_factorizations: int = 200,
        layout: Literal["packed", "row"] = "packed",
        orientation: Literal["wire", "boundary", "up", "best", "grain"] = "wire",
        grain: int = -1,
        up: npt.ArrayLike = (0.0, 0.0, 1.0),
        gap: float = 0.03,
        mirror: bool = False,
        cloth: Cloth | str | None = None,
        grain_angle: float = 0.0,
        thickness: float = 0.0,
        surface: Literal["inside", "middle", "outside"] = "inside",
    ) -> None: ...
    def to_dict(self) -> dict[str, Any]: ...

class Wire:
    def __init__(
        self,
        vertices: Sequence[int] | npt.NDArray[np.integer[Any]],
        tolerance: float = 0.0,
        name: str = "",
        ease: float = 0.0,
    ) -> None: ...
    vertices: Final[npt.NDArray[np.int32]]
    tolerance: Final[float]
    name: Final[str]
    ease: Final[float]
    def to_dict(self) -> dict[str, Any]: ...

class Ease:
    def __init__(self, half_edges: npt.ArrayLike, ratio: float) -> None: ...
    half_edges: Final[npt.NDArray[np.int32]]
    ratio: Final[float]
    def to_dict(self) -> dict[str, Any]: ...

class SurfacePath:
    def __init__(self, faces: npt.ArrayLike, coordinates: npt.ArrayLike) -> None: ...
    faces: Final[npt.NDArray[np.int32]]
    coordinates: Final[npt.NDArray[np.float64]]
    def to_dict(self) -> dict[str, Any]: ...

class CutSources:
    vertices: Final[npt.NDArray[np.int32]]
    vertex_weights: Final[npt.NDArray[np.float64]]
    faces: Final[npt.NDArray[np.int32]]
    corner_weights: Final[npt.NDArray[np.float64]]
    edge_paths: Final[npt.NDArray[np.int32]]
    divided_edges: Final[list[npt.NDArray[np.int32]]]
    def to_dict(self) -> dict[str, Any]: ...

class WireReport:
    name: Final[str]
    wire_index: Final[int]
    part: Final[int]
    kind: Final[Literal["boundary", "rigid", "elastic", "super_elastic"]]
    tolerance: Final[float]
    length_3d: Final[float]
    length_2d: Final[float]
    variation: Final[float]
    max_edge_error: Final[float]
    vertices: Final[npt.NDArray[np.int32]]
    def to_dict(self) -> dict[str, Any]: ...

class HelperWire:
    length_3d: Final[float]
    length_2d: Final[float]
    variation: Final[float]
    points_3d: Final[npt.NDArray[np.float64]]
    points_2d: Final[npt.NDArray[np.float64]]
    def to_dict(self) -> dict[str, Any]: ...

class BoundaryReport:
    vertices: Final[npt.NDArray[np.int32]]
    length_3d: Final[float]
    length_2d: Final[float]
    max_edge_error: Final[float]
    seam: Final[int | None]
    def to_dict(self) -> dict[str, Any]: ...

class SeamReport:
    pieces: Final[tuple[int, ...]]
    edges: Final[npt.NDArray[np.int32]]
    length_3d: Final[float]
    length_2d: Final[tuple[float, ...]]
    variation: Final[float]
    eases: Final[tuple[float, ...]]
    mismatch: Final[float]
    def to_dict(self) -> dict[str, Any]: ...

class Metrics:
    arap_energy: Final[float]
    face_arap: Final[npt.NDArray[np.float64]]
    face_aspect_ratio: Final[npt.NDArray[np.float64]]
    cloth_energy: Final[float]
    face_weft_strain: Final[npt.NDArray[np.float64]]
    face_warp_strain: Final[npt.NDArray[np.float64]]
    face_shear_angle: Final[npt.NDArray[np.float64]]
    wire_edges: Final[npt.NDArray[np.int32]]
    edge_length_variation: Final[npt.NDArray[np.float64]]
    flipped_faces: Final[npt.NDArray[np.int32]]
    overlapping_faces: Final[npt.NDArray[np.int32]]
    angle_deviation_rms: Final[float]
    angle_deviation_max: Final[float]
    area_3d: Final[float]
    area_2d: Final[float]
    def to_dict(self) -> dict[str, Any]: ...

class PieceReport:
    termination: Final[Literal["converged", "stalled", "failed", "cancelled", "measured"]]
    message: Final[str]
    warnings: Final[list[str]]
    start: Final[str]
    inner_solves: Final[int]
    outer_iterations: Final[int]
    gradient_evaluations: Final[int]
    factorizations: Final[int]
    constraint_residual: Final[float]
    projected_gradient: Final[float]
    objective: Final[float]
    seconds: Final[dict[str, float]]
    def to_dict(self) -> dict[str, Any]: ...

class Piece:
    vertices: Final[npt.NDArray[np.float64]]
    faces: Final[npt.NDArray[np.int32]]
    source_vertex: Final[npt.NDArray[np.int32]]
    source_face: Final[npt.NDArray[np.int32]]
    wires: Final[list[WireReport]]
    boundaries: Final[list[BoundaryReport]]
    helper_wires: Final[list[HelperWire]]
    metrics: Final[Metrics]
    report: Final[PieceReport]
    error: Final[FlattenError | None]
    def to_dict(self) -> dict[str, Any]: ...

class FlattenResult:
    pieces: Final[list[Piece]]
    corner_uv: Final[npt.NDArray[np.float64]]
    seams: Final[list[SeamReport]]
    wires: Final[list[WireReport]]
    report: Final[dict[str, Any]]
    def to_dict(self) -> dict[str, Any]: ...

class DartProposal:
    piece: Final[int]
    edges: Final[npt.NDArray[np.int32]]
    paths: Final[list[SurfacePath]]
    length: Final[float]
    num_pieces: Final[int]
    energy: Final[float]
    energy_before: Final[float]
    strain: Final[float]
    strain_before: Final[float]
    twin: Final[int | None]
    energy_with_twin: Final[float | None]
    strain_with_twin: Final[float | None]
    strain_left: Final[float | None]
    def to_dict(self) -> dict[str, Any]: ...

class SeamProposal:
    edges: Final[npt.NDArray[np.int32]]
    opened: Final[npt.NDArray[np.int32]]
    paths: Final[list[SurfacePath]]
    length: Final[float]
    length_before: Final[float]
    num_pieces: Final[int]
    num_pieces_before: Final[int]
    energy: Final[float]
    energy_before: Final[float]
    strain: Final[float]
    strain_before: Final[float]
    was_stopped: Final[bool]
    def to_dict(self) -> dict[str, Any]: ...

class Cache:
    def __init__(self) -> None: ...
    size: Final[int]
    def clear(self) -> None: ...

def error_descriptions() -> dict[str, tuple[str, str, str]]: ...

_Result = TypeVar("_Result")

class Job(Generic[_Result]):
    def progress(self) -> tuple[str, float]: ...
    def cancel(self) -> None: ...
    def is_done(self) -> bool: ...
    def result(self) -> _Result: ...

def start(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    cache: Cache | None = None,
    eases: Iterable[Ease] = (),
) -> Job[FlattenResult]: ...
def flatten(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    progress: Callable[[str, float], bool | None] | None = None,
    cache: Cache | None = None,
    eases: Iterable[Ease] = (),
) -> FlattenResult: ...
def measure(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    corner_uv: npt.ArrayLike,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    eases: Iterable[Ease] = (),
) -> FlattenResult: ...
def propose_darts(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    piece: int | None = None,
    count: int = 5,
    strain: float | None = None,
    longest: float | None = None,
    no_seam: npt.ArrayLike | None = None,
    smooth: bool = False,
    no_crossing: npt.ArrayLike | None = None,
    progress: Callable[[str, float], bool | None] | None = None,
) -> list[DartProposal]: ...
def propose_seams(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    piece: int | None = None,
    count: int = 5,
    strain: float | None = None,
    longest: float | None = None,
    no_seam: npt.ArrayLike | None = None,
    smooth: bool = False,
    no_crossing: npt.ArrayLike | None = None,
    narrowest: float = 0.0,
    progress: Callable[[str, float], bool | None] | None = None,
) -> list[DartProposal]: ...
def plan_cuts(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    kind: Literal["dart", "seam"] = "dart",
    strain: float = 0.05,
    most: int = 2,
    longest: float | None = None,
    total_length: float | None = None,
    piece: int | None = None,
    twins: bool = False,
    no_seam: npt.ArrayLike | None = None,
    progress: Callable[[str, float], bool | None] | None = None,
) -> list[DartProposal]: ...
def start_darts(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    piece: int | None = None,
    count: int = 5,
    strain: float | None = None,
    longest: float | None = None,
    no_seam: npt.ArrayLike | None = None,
    smooth: bool = False,
    no_crossing: npt.ArrayLike | None = None,
) -> Job[list[DartProposal]]: ...
def start_seams(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    piece: int | None = None,
    count: int = 5,
    strain: float | None = None,
    longest: float | None = None,
    no_seam: npt.ArrayLike | None = None,
    smooth: bool = False,
    no_crossing: npt.ArrayLike | None = None,
    narrowest: float = 0.0,
) -> Job[list[DartProposal]]: ...
def start_plan(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    kind: Literal["dart", "seam"] = "dart",
    strain: float = 0.05,
    most: int = 2,
    longest: float | None = None,
    total_length: float | None = None,
    piece: int | None = None,
    twins: bool = False,
    no_seam: npt.ArrayLike | None = None,
) -> Job[list[DartProposal]]: ...
def simplify_seams(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    strain: float = 0.05,
    progress: Callable[[str, float], bool | None] | None = None,
) -> SeamProposal: ...
def start_simplify(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    seams: npt.ArrayLike,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    strain: float = 0.05,
) -> Job[SeamProposal]: ...
def cut_mesh(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    paths: Iterable[SurfacePath],
    *,
    snap: float = 0.05,
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32], npt.NDArray[np.int32], CutSources]: ...
def straighten_path(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    path: npt.ArrayLike,
    *,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.float64]]: ...
