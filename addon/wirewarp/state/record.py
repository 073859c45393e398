# SPDX-License-Identifier: GPL-3.0-or-later
"""What a flat mesh remembers of its run: how the pieces were laid out, and by what it is seen that they changed."""

from dataclasses import asdict, dataclass, fields
from typing import Any

import bpy
import numpy as np

from ..blender.sealed import sealed, unsealed
from ..names import FLAT_RECORD
from ..solve.arrays import MeshArrays
from ..solve.flat_mesh import FlatMesh
from ..solve.flatten import LAYOUT_OPTIONS
from .flat_maps import map_values

UPRIGHT = np.array([0.0, 1.0])


@dataclass(frozen=True)
class FlatRecord:
    layout: dict[str, Any]  # the options that lay out otherwise when they change
    up: list[float]  # (3,) the direction in the model's own space that was up
    away: list[list[float]]  # places of pieces that have no shape just now, see solve.places.NONE_AWAY
    grain: list[list[float]]  # of each piece: its index, two vertices, and the grain seen from their line, see grains
    counts: list[int]  # numbers of vertices, edges and faces
    areas: list[float]  # signed area of each piece
    source_faces: int  # faces of the mesh that was flattened
    ranges: dict[str, list[float]]  # the smallest and the largest value of each map, by its attribute


def new_record(
    options: dict, up: np.ndarray, away: np.ndarray, upright: FlatMesh, placed: FlatMesh, arrays: MeshArrays
) -> FlatRecord:
    """upright: the pieces as laid out; placed: the same where they were put since."""
    return FlatRecord(
        layout=layout_of(options),
        up=up.tolist(),
        away=away.tolist(),
        grain=_grain_rows(upright),
        counts=[len(placed.vertices), len(placed.edges), len(placed.face_sizes)],
        areas=placed.piece_areas.tolist(),
        source_faces=len(arrays.polygon_starts),
        ranges={
            color_map.attribute: [float(values.min()), float(values.max())]
            for color_map, values in map_values(placed).items()
        },
    )


def layout_of(options: dict) -> dict[str, Any]:
    return {name: options[name] for name in LAYOUT_OPTIONS}


def write_record(mesh: bpy.types.Mesh, record: FlatRecord) -> None:
    mesh[FLAT_RECORD] = sealed(asdict(record))


def read_record(mesh: bpy.types.Mesh) -> FlatRecord | None:
    """Returns the record; None if the mesh has none as write_record wrote it."""
    found = unsealed(mesh.get(FLAT_RECORD))
    return FlatRecord(**found) if found and found.keys() == {each.name for each in fields(FlatRecord)} else None


def grains(mesh: bpy.types.Mesh, vertices: np.ndarray) -> dict[int, np.ndarray]:
    """Returns unit vectors (2,) along the grain of the pieces as they lie now, by index of the piece. vertices (n,2).

    The grain turns with its piece when the user turns that: it is kept by its angle from the line between two vertices.
    Pieces whose vertices are gone have none.
    """
    record, found = read_record(mesh), {}
    for piece, first, last, cosine, sine in record.grain if record else ():
        if first < len(vertices) and last < len(vertices):
            x, y = _unit(vertices[int(last)] - vertices[int(first)])
            found[int(piece)] = np.array([cosine * x - sine * y, sine * x + cosine * y])
    return found


def _grain_rows(flat: FlatMesh) -> list[list[float]]:
    """Returns for each piece the cosine and sine of the angle, counterclockwise, from a line in it to upright."""
    rows = []
    sums, begins = flat.vertices.sum(axis=1), np.flatnonzero(np.diff(flat.vertex_piece, prepend=-1))
    for begin, end in zip(begins.tolist(), [*begins[1:].tolist(), len(sums)], strict=True):
        piece, own = int(flat.vertex_piece[begin]), sums[begin:end]
        first, last = (begin + int(pick(own)) for pick in (np.argmin, np.argmax))
        along = _unit(flat.vertices[last] - flat.vertices[first])
        cosine, sine = along @ UPRIGHT, along[0] * UPRIGHT[1] - along[1] * UPRIGHT[0]
        rows.append([piece, first, last, float(cosine), float(sine)])
    return rows


def _unit(vector: np.ndarray) -> np.ndarray:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0 else UPRIGHT
