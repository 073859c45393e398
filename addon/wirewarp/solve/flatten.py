# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens the arrays of one object with the core library."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np

from ..core import (
    Cache,
    Cloth,
    Ease,
    FlattenError,
    FlattenResult,
    Issue,
    Job,
    LooserWire,
    Options,
    Piece,
    Wire,
    counted,
    start,
)
from ..issues import ObjectError
from .arrays import MeshArrays, NamedWire, triangle_areas
from .chains import are_among, find_edges, shortest_double
from .error_sentences import ErrorFacts, error_sentence
from .steps import Steps

EASE_AGAIN = "Mark the ease again with a value above -100%. 0 means no ease."
Result = TypeVar("Result")
_ending: list[Job] = []  # canceled jobs, which are kept because deleting a job would wait for its end


@dataclass(frozen=True)
class ClothChoice:
    """A fabric of the library, chosen by its name, or a custom fabric."""

    name: str  # name of a preset, or "custom"
    gives_across: float  # maximum stretch as a fraction; 0: that of the preset
    gives_along: float
    worn_across: float = 0.0  # negative ease: stretch when worn, as a fraction
    worn_along: float = 0.0
    weft: float | None = None  # stiffness of a custom fabric
    warp: float | None = None
    shear: float | None = None


LAYS_OUT = {"lays_out": True}


@dataclass(frozen=True)
class FlattenChoices:
    """The operator's settings, with the names of the core library's options."""

    method: str
    fairness: float
    node_weight: str
    cloth: ClothChoice | None
    thickness: float  # in Blender units
    surface: str
    layout: str = field(metadata=LAYS_OUT)
    orientation: str = field(metadata=LAYS_OUT)
    grain_angle: float = field(metadata=LAYS_OUT)
    spacing: float = field(metadata=LAYS_OUT)  # space between the cutting lines of pieces, in Blender units
    mirror: bool = field(metadata=LAYS_OUT)


# If one of these options of a report changes, all pieces need a new layout.
LAYOUT_OPTIONS = (*(each.name for each in fields(FlattenChoices) if each.metadata), "grain_wire")


def flatten_arrays(arrays: MeshArrays, choices: FlattenChoices, solved: Cache | None = None) -> Steps[FlattenResult]:
    """Flatten the mesh with the library, which also works between the steps.

    solved: cache of earlier pieces, so that unchanged pieces are not solved again
    Raises ObjectError if the library refuses the whole mesh.
    """
    try:
        arguments = library_arguments(arrays, choices)
        return (yield from result_of(start(arrays.vertices, arrays.triangles, **arguments, cache=solved)))
    except FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error


def library_arguments(arrays: MeshArrays, choices: FlattenChoices) -> dict[str, Any]:
    """Return the arguments that all calls of the library share, except the mesh. Raises ObjectError or FlattenError."""
    return {
        "seams": arrays.seams,
        "options": _library_options(used_choices(choices, arrays), arrays),
        **library_marks(arrays),
    }


def library_marks(arrays: MeshArrays) -> dict[str, Any]:
    """Return the wires and eases as arguments of the library. Raises ObjectError if one is invalid."""
    return {"wires": [_library_wire(wire) for wire in arrays.wires], "eases": _library_eases(arrays)}


def result_of(job: "Job[Result]") -> Steps[Result]:
    """Return the job's result. Closing the steps cancels the job. Raises the library's FlattenError."""
    try:
        while not job.is_done():
            yield job.progress()[1]
        return job.result()
    finally:
        _let_end(job)


def _let_end(job: Job) -> None:
    """Cancel the job without waiting for its end, because waiting takes seconds for half a million faces."""
    job.cancel()
    _ending[:] = [each for each in (*_ending, job) if not each.is_done()]


def drop_jobs(*_: object) -> None:
    """Wait until none of our jobs is running."""
    _ending.clear()


def _library_options(choices: FlattenChoices, arrays: MeshArrays) -> Options:
    """Return the library's options. The option `gap` is a share of the side of a square with the area of all
    pieces."""
    options = asdict(choices)
    side, gap = _side(arrays), gap_between(arrays, options.pop("spacing"))
    options |= {"gap": gap / side if side > 0 else 0.0, "grain": _grain_index(arrays)}
    if choices.cloth:
        options["cloth"] = library_cloth(choices.cloth)
    return Options(**options)


def library_cloth(cloth: ClothChoice) -> Cloth:
    """Return the library's cloth without its maximum stretch, because only the report needs the maximum stretch."""
    own = _without_stretch(cloth)
    worn = cloth.worn_across, cloth.worn_along
    return Cloth(own.weft, own.warp, own.shear, squeeze=own.squeeze, stretch=worn, locking=own.locking)


def maximum_stretch(cloth: ClothChoice) -> tuple[float | None, float | None]:
    """Return the maximum stretch across and along the grain as fractions, from the settings or else from the preset;
    None if unknown."""
    across, along = _without_stretch(cloth).limits or (None, None)
    return cloth.gives_across or across, cloth.gives_along or along


def known_stretch(cloth: ClothChoice | None) -> list[float]:
    """Return the known maximum stretches of the fabric as fractions, the smaller first; empty if they are unknown."""
    return sorted(limit for limit in maximum_stretch(cloth) if limit is not None) if cloth else []


def limits_of(cloth: ClothChoice | None) -> dict[str, Any]:
    if cloth is None:
        return {}
    return {"cloth": library_cloth(cloth), "limits": maximum_stretch(cloth), "fabric": cloth.name}


def _without_stretch(cloth: ClothChoice) -> Cloth:
    return Cloth(cloth.weft, cloth.warp, cloth.shear) if cloth.name == "custom" else Cloth.preset(cloth.name)


def gap_between(arrays: MeshArrays, spacing: float) -> float:
    """Return the gap between pieces that leaves `spacing` between their cutting lines, at most the library's maximum.
    All lengths are in Blender units."""
    return min(spacing + 2 * arrays.allowance, _side(arrays))


def _side(arrays: MeshArrays) -> float:
    """Return the side of a square with the area of all pieces."""
    return math.sqrt(float(triangle_areas(arrays.vertices, arrays.triangles).sum()))


def used_choices(choices: FlattenChoices, arrays: MeshArrays) -> FlattenChoices:
    """Return the choices with the orientation "up" instead of "grain" if the model has no grain wire."""
    if choices.orientation == "grain" and _grain_index(arrays) == -1:
        return replace(choices, orientation="up")
    return choices


def _grain_index(arrays: MeshArrays) -> int:
    """Return the index of the grain wire among the wires; -1 if there is none."""
    ids = [wire.chain.wire_id for wire in arrays.wires]
    return ids.index(arrays.grain_wire) if arrays.grain_wire in ids else -1


def _library_wire(wire: NamedWire) -> Wire:
    try:
        return Wire(wire.chain.vertices, tolerance=wire.chain.tolerance, name=wire.name, ease=wire.chain.ease)
    except FlattenError as error:  # the library's error does not contain the wire's name and edges
        edges = list(pairwise(wire.chain.vertices))
        is_ease = str(error.code) == "invalid_ease"
        remedy = EASE_AGAIN if is_ease else "Click it in the list of wires and choose Rigid, Elastic or Free."
        sentence = f'Wire "{wire.name}" has an invalid {"ease" if is_ease else "tolerance"}. {remedy}'
        raise ObjectError(Issue(str(error.code), sentence, edges=edges)) from error


def _library_eases(arrays: MeshArrays) -> list[Ease]:
    """Return the eases of single sides, one for all sides with the same ratio. Raises ObjectError if one is invalid."""
    half_edges, eases = eased_half_edges(arrays)
    ratios, number = np.unique(eases, return_inverse=True)
    return [_library_ease(half_edges[number == k], shortest_double(ratio)) for k, ratio in enumerate(ratios)]


def eased_half_edges(arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """Return the sides (k,2) that have their own ease, as vertices with the face on the left, and the eases (k,)."""
    corners = np.flatnonzero(arrays.side_eases)
    starts = arrays.loop_vertices[corners]
    ends = arrays.edges[arrays.loop_edges[corners]].sum(axis=1, dtype=np.int32) - starts
    return np.column_stack([ends, starts] if arrays.mirrored else [starts, ends]), arrays.side_eases[corners]


def _library_ease(half_edges: np.ndarray, ratio: float) -> Ease:
    try:
        return Ease(half_edges, ratio)
    except FlattenError as error:  # the library's error does not contain the edges
        edges = [tuple(pair) for pair in half_edges.tolist()]
        sentence = f"The ease of one side is invalid along {counted(len(edges), 'edge')}. {EASE_AGAIN}"
        raise ObjectError(Issue(str(error.code), sentence, edges=edges)) from error


def issue_of_piece(piece: Piece, index: int, arrays: MeshArrays) -> Issue:
    """Return the error of a failed piece as an issue, with all flipped and overlapping faces of the piece."""
    flipped = polygons_of(arrays, piece.metrics.flipped_faces)
    overlapping = polygons_of(arrays, piece.metrics.overlapping_faces)
    issue = issue_of_error(piece.error, arrays, len(flipped), len(overlapping))
    return replace(issue, piece=index, faces=sorted({*issue.faces, *flipped, *overlapping}))


def issue_of_error(
    error: FlattenError, arrays: MeshArrays, flipped: int = 0, overlapping: int = 0, piece: str = "the piece"
) -> Issue:
    """Return the library's error as an issue in the add-on's words. flipped, overlapping: numbers of such faces in the
    piece; piece: see ErrorFacts."""
    faces = polygons_of(arrays, error.faces)
    names = [wire.name for wire in arrays.wires]
    return Issue(
        code=str(error.code),
        sentence=error_sentence(ErrorFacts(error, len(faces), flipped, overlapping, names, arrays.lengths, piece)),
        vertices=[int(vertex) for vertex in error.vertices],
        edges=[(int(a), int(b)) for a, b in error.edges],
        faces=faces,
        wires=list(error.arguments.get("wires", [])),
        proposed_seams=seams_on_edges(error.proposed_seams, arrays),
        proposed_tolerances=looser_wires(error.proposed_tolerances, arrays),
    )


def polygons_of(arrays: MeshArrays, triangles: Sequence[int] | np.ndarray) -> list[int]:
    """Return the polygons that contain these triangles, each once."""
    return np.unique(arrays.triangle_polygons[np.asarray(triangles, dtype=np.int64)]).tolist()


def has_layout(corner_uv: np.ndarray) -> np.ndarray:
    """Return a mask (m,) of the triangles whose flat coordinates (m,3,2) are finite."""
    return np.isfinite(corner_uv.reshape(-1, 6) @ np.ones(6))  # a sum is finite only if its terms are finite


def has_cloth(result: FlattenResult) -> bool:
    """Return whether the result is for a fabric and has a layout."""
    return any(math.isfinite(piece.metrics.cloth_energy) for piece in result.pieces)


def seams_on_edges(proposed: Iterable[tuple[int, int]], arrays: MeshArrays) -> list[tuple[int, int]]:
    """Return the proposed vertex pairs as edges of the mesh, each once.

    A diagonal of a face is replaced with the shorter way around the face.
    """
    pairs = np.asarray(list(proposed), dtype=np.int64).reshape(-1, 2)
    is_edge = are_among(pairs, arrays.edges)
    edges = pairs[is_edge].tolist()
    for diagonal, polygon in zip(pairs[~is_edge], polygons_across(pairs[~is_edge], arrays), strict=True):
        edges += pairwise(_way_round(diagonal, polygon, arrays))
    return list(dict.fromkeys((min(pair), max(pair)) for pair in edges))


def polygons_across(diagonals: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    """Return the polygon (k,) that contains each diagonal. diagonals (k,2): pairs of vertices."""
    return arrays.triangle_polygons[find_edges(diagonals, arrays.triangles[:, [0, 1, 1, 2, 2, 0]]) // 3]


def _way_round(diagonal: np.ndarray, polygon: int, arrays: MeshArrays) -> list[int]:
    """Return the vertices along the shorter way around a polygon from one end of its diagonal to the other."""
    start = arrays.polygon_starts[polygon]
    corners = arrays.loop_vertices[start : start + arrays.polygon_sizes[polygon]].tolist()
    first, last = sorted(corners.index(vertex) for vertex in diagonal)
    ways = corners[first : last + 1], corners[last:] + corners[: first + 1]
    return min(ways, key=lambda way: np.linalg.norm(np.diff(arrays.vertices[way], axis=0), axis=1).sum())


def looser_wires(proposed: Iterable[tuple[int, float]], arrays: MeshArrays) -> list[LooserWire]:
    """Return the wires with their proposed tolerances. proposed: pairs of a wire's index and its tolerance."""
    return [
        LooserWire(name=wire.name, tolerance=round_up(tolerance), edges=list(pairwise(wire.chain.vertices)))
        for wire, tolerance in ((arrays.wires[index], tolerance) for index, tolerance in proposed)
    ]


def round_up(tolerance: float) -> float:
    """Return the tolerance, rounded up to the three digits that the panel shows, so that it is large enough. The
    infinite tolerance of free wires does not change."""
    if math.isinf(tolerance):
        return tolerance
    step = 10.0 ** (math.floor(math.log10(tolerance)) - 2)
    return float(f"{math.ceil(tolerance / step - 1e-9) * step:.3g}")
