# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat pieces as one mesh.

The flat mesh has the source's own faces, quads and n-gons included, so that its edges are the source's edges and
nothing else. Measures taken per triangle are put together per face: energies add up, of ratios the worst counts.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..core import FlattenResult
from ..pattern.chains import EdgeMarks, edge_keys
from .arrays import MeshArrays, triangle_areas
from .flatten import has_layout
from .identity import PieceIdentity


@dataclass(frozen=True)
class FlatMesh:
    """Only what has a layout."""

    vertices: np.ndarray  # (p,2) float64, Blender units
    source_vertex: np.ndarray  # (p,) int32
    loop_vertices: np.ndarray  # (l,) int32
    face_starts: np.ndarray  # (f,) int32
    face_sizes: np.ndarray  # (f,) int32
    source_corner: np.ndarray  # (l,) int32, corner (loop) of the source
    source_face: np.ndarray  # (f,) int32, face of the source
    face_piece: np.ndarray  # (f,) int32, index of the piece
    piece_id: np.ndarray  # (f,) int32, by which the piece is known again in the next run
    failed: np.ndarray  # (f,) bool, the piece breaks a promise
    arap_energy: np.ndarray  # (f,) float32, Eq. (6)
    energy_density: np.ndarray  # (f,) float32, Eq. (6) by 3D area
    aspect_ratio: np.ndarray  # (f,) float32
    stretch: np.ndarray  # (f,) float32: 0.1 is cloth that the model stretches by 10%, in the mean of all directions


def flat_mesh(result: FlattenResult, arrays: MeshArrays, identities: Sequence[PieceIdentity]) -> FlatMesh:
    """The pieces of a FlattenResult side by side, as packed."""
    vertices, source_vertex, flat_triangles, piece_of_triangle, energy, ratio = _join_pieces(result, arrays)
    placed = has_layout(result.corner_uv)
    polygon_count = len(arrays.polygon_starts)
    kept = np.zeros(polygon_count, dtype=bool)
    kept[arrays.triangle_polygons[placed]] = True

    vertex_of_loop = np.full(len(arrays.loop_vertices), -1, dtype=np.int32)
    vertex_of_loop[arrays.triangle_loops[placed]] = flat_triangles[placed]
    sizes = arrays.polygon_sizes[kept]

    failed_piece = np.array([piece.error is not None for piece in result.pieces])
    first_triangle = np.searchsorted(arrays.triangle_polygons, np.arange(polygon_count))
    piece = piece_of_triangle[first_triangle][kept]
    source_corner = _loops_of(arrays, kept)
    face_energy = np.add.reduceat(energy, first_triangle)[kept]
    face_area = np.add.reduceat(triangle_areas(arrays.vertices, arrays.triangles), first_triangle)[kept]
    flat_area = np.add.reduceat(triangle_areas(_in_space(vertices), flat_triangles), first_triangle)[kept]
    return FlatMesh(
        vertices=vertices,
        source_vertex=source_vertex,
        loop_vertices=vertex_of_loop[source_corner],
        face_starts=(np.cumsum(sizes) - sizes).astype(np.int32),
        face_sizes=sizes,
        source_corner=source_corner.astype(np.int32),
        source_face=np.flatnonzero(kept).astype(np.int32),
        face_piece=piece,
        piece_id=np.array([identity.piece_id for identity in identities], dtype=np.int32)[piece],
        failed=failed_piece[piece],
        arap_energy=face_energy.astype(np.float32),
        energy_density=(face_energy / face_area).astype(np.float32),
        aspect_ratio=np.maximum.reduceat(ratio, first_triangle)[kept].astype(np.float32),
        stretch=(np.sqrt(face_area / np.maximum(flat_area, 1e-12 * face_area)) - 1).astype(np.float32),
    )


def edge_length_variation(flat: FlatMesh, flat_edges: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    """|l2 - l3| / l3 (Eq. 5) of each flat edge (k,2), float32."""
    flat_length = edge_lengths(flat.vertices, flat_edges)
    length = edge_lengths(arrays.vertices, flat.source_vertex[flat_edges])
    return (np.abs(flat_length - length) / length).astype(np.float32)


def edge_lengths(points: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """(k,) between points (n,2) or (n,3); coordinate by coordinate, for rows of two or three are slow to gather."""
    a, b = edges.T
    columns = (np.ascontiguousarray(column) for column in points.T)
    return np.sqrt(sum((column[a] - column[b]) ** 2 for column in columns))


def _join_pieces(result: FlattenResult, arrays: MeshArrays) -> tuple[np.ndarray, ...]:
    """All pieces' vertices in one numbering, and per input triangle: its corners, piece, energy and aspect ratio."""
    count = len(arrays.triangles)
    flat_triangles = np.full((count, 3), -1, dtype=np.int32)
    piece_of_triangle = np.zeros(count, dtype=np.int32)
    energy, ratio = np.zeros(count), np.ones(count)
    vertices, source_vertex, offset = [np.empty((0, 2))], [np.empty(0, dtype=np.int32)], 0
    for index, piece in enumerate(result.pieces):
        piece_of_triangle[piece.source_face] = index
        if len(piece.vertices) == 0 or not np.isfinite(piece.vertices).all():
            continue
        flat_triangles[piece.source_face] = piece.faces + offset
        energy[piece.source_face] = piece.metrics.face_arap
        ratio[piece.source_face] = piece.metrics.face_aspect_ratio
        vertices.append(piece.vertices)
        source_vertex.append(piece.source_vertex)
        offset += len(piece.vertices)
    return (
        np.concatenate(vertices),
        np.concatenate(source_vertex).astype(np.int32),
        flat_triangles,
        piece_of_triangle,
        energy,
        ratio,
    )


def _loops_of(arrays: MeshArrays, kept: np.ndarray) -> np.ndarray:
    """The loops of the kept polygons, one polygon after the other; backwards where the object is mirrored."""
    sizes = arrays.polygon_sizes[kept]
    starts = np.repeat(arrays.polygon_starts[kept], sizes)
    step = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    return starts + (np.repeat(sizes, sizes) - 1 - step if arrays.mirrored else step)


def _in_space(points: np.ndarray) -> np.ndarray:
    return np.column_stack([points, np.zeros(len(points))])


@dataclass(frozen=True)
class FlatMarks:
    """Of the flat edges, by the edges of the model they come from."""

    seams: np.ndarray  # (e,) bool
    seam_ids: np.ndarray  # (e,) int32, 0 none
    wires: EdgeMarks


def flat_marks(flat: FlatMesh, flat_edges: np.ndarray, arrays: MeshArrays) -> FlatMarks:
    """flat_edges (e,2)"""
    count = len(arrays.vertices)
    keys = edge_keys(flat.source_vertex[flat_edges], count)
    return FlatMarks(*_seams_at(keys, arrays), _wires_at(keys, arrays))


def _seams_at(keys: np.ndarray, arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    if not len(arrays.seams):
        return np.zeros(len(keys), dtype=bool), np.zeros(len(keys), dtype=np.int32)
    own = edge_keys(arrays.seams, len(arrays.vertices))
    order = np.argsort(own)
    place = order[np.searchsorted(own[order], keys).clip(max=len(own) - 1)]
    is_seam = own[place] == keys
    return is_seam, np.where(is_seam, arrays.seam_ids[place], 0).astype(np.int32)


def _wires_at(keys: np.ndarray, arrays: MeshArrays) -> EdgeMarks:
    marks, count = EdgeMarks.none(len(keys)), len(arrays.vertices)
    if not arrays.wires:
        return marks

    chains = [wire.chain for wire in arrays.wires]
    wire_keys = np.concatenate([edge_keys(np.column_stack([c.vertices[:-1], c.vertices[1:]]), count) for c in chains])
    wire_of_key = np.repeat(np.arange(len(chains)), [len(chain.vertices) - 1 for chain in chains])
    order = np.argsort(wire_keys)
    place = np.searchsorted(wire_keys[order], keys).clip(max=len(order) - 1)
    on_wire = wire_keys[order[place]] == keys
    wire = wire_of_key[order[place[on_wire]]]
    marks.wire_ids[on_wire] = np.array([chain.wire_id for chain in chains], dtype=np.int32)[wire]
    marks.tolerances[on_wire] = np.array([chain.tolerance for chain in chains], dtype=np.float32)[wire]
    return marks
