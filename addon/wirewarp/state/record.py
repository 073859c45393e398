# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes measures (as maps) and the record of the layout on a flat mesh, and reads the record."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any

import bpy
import numpy as np

from ..blender.attributes import sealed, unsealed
from ..names import FLAT_RECORD
from ..solve.arrays import MeshArrays
from ..solve.flat_mesh import FlatMesh
from ..solve.flatten import LAYOUT_OPTIONS
from ..solve.maps import ARAP_ENERGY, ASPECT_RATIO, COLOR_MAPS, LENGTH_VARIATION, SHEAR, STRETCH, WARP, WEFT, ColorMap

OF_THREADS = {WEFT: "weft_strain", WARP: "warp_strain", SHEAR: "shear_angle"}  # fields of solve.flat_mesh.Threads
VALUES = {"arap_energy": "FACE", "aspect_ratio": "FACE", "stretch": "FACE", "length_variation": "EDGE"}


def write_maps(mesh: bpy.types.Mesh, flat: FlatMesh) -> None:
    """Write the maps as new attributes of a mesh. The mesh must not have these attributes yet."""
    for name, domain in VALUES.items():
        mesh.attributes.new(name, "FLOAT", domain).data.foreach_set("value", getattr(flat, name))
    measures = map_values(flat)
    for color_map, name in OF_THREADS.items() if flat.threads else ():
        mesh.attributes.new(name, "FLOAT", "FACE").data.foreach_set("value", measures[color_map])
    _write_colors(mesh, flat, measures)
    shown = mesh.color_attributes.find(COLOR_MAPS[0].attribute)
    mesh.color_attributes.active_color_index = mesh.color_attributes.render_color_index = shown


def map_values(flat: FlatMesh) -> dict[ColorMap, np.ndarray]:
    """Return the values by map: (f,), or (e,) for the variation of lengths."""
    of_threads = {each: getattr(flat.threads, name) for each, name in OF_THREADS.items()} if flat.threads else {}
    measures = {ASPECT_RATIO: flat.aspect_ratio, STRETCH: flat.stretch, ARAP_ENERGY: flat.energy_density}
    return measures | of_threads | {LENGTH_VARIATION: flat.length_variation}


def _write_colors(mesh: bpy.types.Mesh, flat: FlatMesh, measures: Mapping[ColorMap, np.ndarray]) -> None:
    ends = flat.edges.ravel()
    edges_at = np.maximum(np.bincount(ends, minlength=len(mesh.vertices)), 1)
    sums = np.bincount(ends, np.repeat(flat.length_variation, 2), minlength=len(mesh.vertices))
    at_vertex = sums / edges_at  # the mean over the edges of the vertex
    face = np.repeat(np.arange(len(flat.face_sizes)), flat.face_sizes)  # face of each corner
    # A color of four float32 has the size of one complex number. Taking complex numbers is far faster than taking rows.
    # All maps use one array, because allocating new arrays would be slow, too.
    taken = np.empty(len(face), dtype=np.complex128)
    for color_map, values, at_corner in (
        *((color_map, values, face) for color_map, values in measures.items() if color_map != LENGTH_VARIATION),
        (LENGTH_VARIATION, at_vertex, flat.loop_vertices),
    ):
        own = color_map.colors(values).view(np.complex128).ravel()
        np.take(own, at_corner, out=taken, mode="clip")  # the default mode would allocate memory
        attribute = mesh.color_attributes.new(color_map.attribute, "FLOAT_COLOR", "CORNER")
        attribute.data.foreach_set("color", taken.view(np.float32))


UPRIGHT = np.array([0.0, 1.0])


@dataclass(frozen=True)
class FlatRecord:
    """Data about the layout of the flat pieces, stored on the flat mesh."""

    layout: dict[str, Any]  # options that change the layout
    up: list[float]  # (3,) upward direction in the model's own space when the pieces were laid out
    away: list[list[float]]  # places of pieces without a flat shape, see solve.places.NONE_AWAY
    grain: list[list[float]]  # a row for each piece, see _grain_rows()
    counts: list[int]  # numbers of vertices, edges and faces
    areas: list[float]  # signed area of each piece
    source_faces: int  # number of faces of the flattened mesh
    ranges: dict[str, list[float]]  # the smallest and the largest value of each map, by its attribute


def new_record(
    options: dict, up: np.ndarray, away: np.ndarray, upright: FlatMesh, placed: FlatMesh, arrays: MeshArrays
) -> FlatRecord:
    """Return the record of a layout. upright: the pieces as the library has laid them out; placed: the pieces in their
    final places."""
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
    """Return the record; None if the mesh has no record, or a record of another version."""
    found = unsealed(mesh.get(FLAT_RECORD))
    return FlatRecord(**found) if found and found.keys() == {each.name for each in fields(FlatRecord)} else None


def grains(mesh: bpy.types.Mesh, vertices: np.ndarray) -> dict[int, np.ndarray]:
    """Return unit vectors (2,) along the present grain, by index of the piece. vertices (n,2): places

    The grain is stored as an angle from the line between two vertices. Without these vertices, a piece has no grain.
    """
    record, found = read_record(mesh), {}
    for piece, first, last, cosine, sine in record.grain if record else ():
        if first < len(vertices) and last < len(vertices):
            x, y = _unit(vertices[int(last)] - vertices[int(first)])
            found[int(piece)] = np.array([cosine * x - sine * y, sine * x + cosine * y])
    return found


def _grain_rows(flat: FlatMesh) -> list[list[float]]:
    """Return a row for each piece: its index, two of its vertices, and cosine and sine of the counterclockwise angle
    from the line between these vertices to upright."""
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
