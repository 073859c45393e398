# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one mesh from the flat pieces, with measures of their distortion.

The mesh has the source's faces, including quads and n-gons. Each face has the summed energy and the worst ratio of its
triangles.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..core import FlattenResult
from .arrays import MeshArrays, edge_lengths, triangle_areas
from .chains import EdgeMarks, find_edges, next_corners
from .flatten import FlattenChoices, has_cloth, has_layout
from .identity import PieceIdentity


def edge_length_variation(
    result: FlattenResult, arrays: MeshArrays, choices: FlattenChoices, flat: np.ndarray, places: np.ndarray
) -> np.ndarray:
    """Return the relative difference of the flat edges from their target lengths, (e,) float32.

    flat (e,2): edges as vectors
    places (e,2): piece of each edge, and its edge on the model
    """
    worn = (choices.cloth.worn_across, choices.cloth.worn_along) if choices.cloth else (0.0, 0.0)
    # Edges of outlines and wires have the library's value. Targets of other edges are their lengths on the model,
    # shortened by the fabric's negative ease.
    spatial = _model_lengths(result, arrays, choices)[places[:, 1]]
    variation = np.abs(np.linalg.norm(flat * np.add(worn, 1), axis=1) - spatial) / spatial
    keys, on_lines = _on_lines(result, arrays)
    own = places @ (len(arrays.edges), 1)
    place = np.searchsorted(keys, own).clip(max=len(keys) - 1)
    return np.where(keys[place] == own, on_lines[place], variation).astype(np.float32)


def _on_lines(result: FlattenResult, arrays: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """Return the ascending keys (piece and model edge) of the edges on wires and outlines, and their variations of
    length. If an edge has two sides in the piece, the larger variation is returned."""
    pieces = np.repeat(np.arange(len(result.pieces)), [len(piece.metrics.wire_edges) for piece in result.pieces])
    pairs = [np.reshape(piece.metrics.wire_edges, (-1, 2)) for piece in result.pieces]
    keys = pieces * len(arrays.edges) + find_edges(np.concatenate(pairs), arrays.edges)
    found, number = np.unique(keys, return_inverse=True)
    worst = np.zeros(len(found))
    np.maximum.at(worst, number, np.concatenate([piece.metrics.edge_length_variation for piece in result.pieces]))
    return found, worst


def _model_lengths(result: FlattenResult, arrays: MeshArrays, choices: FlattenChoices) -> np.ndarray:
    """Return the lengths (k,) of the model's edges; for thick materials, in the middle of the thickness."""
    lengths = edge_lengths(arrays.vertices, arrays.edges)
    if choices.thickness == 0 or choices.surface == "middle":
        return lengths
    weft, warp, shear = (each[:, None] for each in _threads_of_triangles(result))
    towards = -1 if choices.mirror else 1  # shear is measured from outside, and a mirrored layout shows the inside
    dx, dy = (np.roll(result.corner_uv, -1, axis=1) - result.corner_uv).transpose(2, 0, 1)  # (m,3), the sides
    # A flat edge (dx, dy) is a sum of two vectors on the model, one along each thread. Their lengths are `across` and
    # `along`, and the shear determines the angle between them.
    with np.errstate(invalid="ignore"):  # for triangles without a layout or without area
        across, along = (1 + weft) * dx, (1 + warp) * dy
        worn = np.sqrt(across**2 + along**2 + 2 * towards * np.sin(shear) * across * along).ravel()
    rows = find_edges(np.stack([arrays.triangles, np.roll(arrays.triangles, -1, axis=1)], axis=-1), arrays.edges)
    known = (rows >= 0) & np.isfinite(worn)
    lengths[rows[known]] = worn[known]
    return lengths


def _threads_of_triangles(result: FlattenResult) -> list[np.ndarray]:
    """Return weft strain, warp strain and shear angle (m,) of the triangles of all pieces."""
    return [_of_triangles(result, name) for name in ("face_weft_strain", "face_warp_strain", "face_shear_angle")]


def _of_triangles(result: FlattenResult, name: str) -> np.ndarray:
    """Return a measure (m,) of the triangles of all pieces. name: its field in the pieces' metrics."""
    values = np.full(len(result.corner_uv), np.nan)
    for piece in result.pieces:
        values[piece.source_face] = getattr(piece.metrics, name)
    return values


@dataclass(frozen=True)
class FlatMesh:
    """The pieces that have a layout, as one mesh."""

    vertices: np.ndarray  # (p,2) float64, Blender units
    source_vertex: np.ndarray  # (p,) int32, vertex of the source
    vertex_piece: np.ndarray  # (p,) int32, index of the piece, ascending
    edges: np.ndarray  # (e,2) int32
    source_edge: np.ndarray  # (e,) int32, edge of the source
    loop_vertices: np.ndarray  # (l,) int32, the vertex of each corner
    loop_edges: np.ndarray  # (l,) int32, the edge from each corner to the next corner of its face
    face_starts: np.ndarray  # (f,) int32, first corner of each face
    face_sizes: np.ndarray  # (f,) int32, number of corners of each face
    source_corner: np.ndarray  # (l,) int32, corner (loop) of the source
    side_eases: np.ndarray  # (l,) float32, as in MeshArrays
    source_face: np.ndarray  # (f,) int32, face of the source
    face_piece: np.ndarray  # (f,) int32, index of the piece
    piece_id: np.ndarray  # (f,) int32, the piece's id for the next run
    failed: np.ndarray  # (f,) bool, whether the piece failed
    arap_energy: np.ndarray  # (f,) float32, ARAP energy
    energy_density: np.ndarray  # (f,) float32, ARAP energy divided by the area on the model
    aspect_ratio: np.ndarray  # (f,) float32, of the worst triangle
    stretch: np.ndarray  # (f,) float32: mean of all directions, from the areas; 0.1 if the fabric is stretched by 10%
    length_variation: np.ndarray  # (e,) float32: 0.1 if an edge differs by 10% from its target length
    threads: "Threads | None"  # None without a fabric
    piece_areas: np.ndarray  # (n,) areas of the pieces by index; below 0 for a flipped piece


@dataclass(frozen=True)
class Threads:
    """Measures of threads for each face, (f,) float32, from its worst triangle."""

    weft_strain: np.ndarray  # 0.1: the threads across the grain are stretched by 10%
    warp_strain: np.ndarray
    shear_angle: np.ndarray  # radians by which the angle of the threads differs from a right angle, at least 0


def flat_mesh(
    result: FlattenResult, arrays: MeshArrays, identities: Sequence[PieceIdentity], choices: FlattenChoices
) -> FlatMesh:
    """Return the pieces of a FlattenResult as one mesh, in the places where the library has packed them."""
    vertices, source_vertex, vertex_piece, flat_triangles, piece_of_triangle = _join_pieces(result)
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
    loop_vertices = vertex_of_loop[source_corner]
    edges, loop_edges, source_edge = _edges(loop_vertices, source_corner, sizes, arrays)
    energy, ratio = (_of_triangles(result, name) for name in ("face_arap", "face_aspect_ratio"))
    face_energy = np.add.reduceat(energy, first_triangle)[kept]
    signed_areas = _signed_areas(vertices, flat_triangles)
    face_area = np.add.reduceat(_model_areas(result, arrays, signed_areas), first_triangle)[kept]
    flat_area = np.add.reduceat(np.abs(signed_areas), first_triangle)[kept]
    return FlatMesh(
        vertices=vertices,
        source_vertex=source_vertex,
        vertex_piece=vertex_piece,
        edges=edges,
        source_edge=source_edge,
        loop_vertices=loop_vertices,
        loop_edges=loop_edges,
        face_starts=(np.cumsum(sizes) - sizes).astype(np.int32),
        face_sizes=sizes,
        source_corner=source_corner.astype(np.int32),
        side_eases=arrays.side_eases[_edge_corners(source_corner, sizes, arrays)],
        source_face=np.flatnonzero(kept).astype(np.int32),
        face_piece=piece,
        piece_id=np.array([identity.piece_id for identity in identities], dtype=np.int32)[piece],
        failed=failed_piece[piece],
        arap_energy=face_energy.astype(np.float32),
        energy_density=(face_energy / face_area).astype(np.float32),
        aspect_ratio=np.maximum.reduceat(ratio, first_triangle)[kept].astype(np.float32),
        stretch=(np.sqrt(face_area / np.maximum(flat_area, 1e-12 * face_area)) - 1).astype(np.float32),
        length_variation=edge_length_variation(
            result,
            arrays,
            choices,
            vertices[edges[:, 1]] - vertices[edges[:, 0]],
            np.column_stack([vertex_piece[edges[:, 0]], source_edge]),
        ),
        threads=_threads(result, first_triangle, kept) if has_cloth(result) else None,
        piece_areas=np.bincount(piece_of_triangle[placed], signed_areas[placed]),
    )


def _threads(result: FlattenResult, first_triangle: np.ndarray, kept: np.ndarray) -> Threads:
    """Return the measures of the threads. first_triangle (f,): first triangle of each polygon of the model; kept (f,):
    mask of the polygons in the flat mesh."""
    measures = []
    for measure in _threads_of_triangles(result):
        values = np.where(np.isfinite(measure), measure, 0)
        most, least = (each.reduceat(values, first_triangle)[kept] for each in (np.maximum, np.minimum))
        measures.append(np.where(most >= -least, most, least).astype(np.float32))
    weft, warp, shear = measures
    return Threads(weft, warp, np.abs(shear))


def _join_pieces(result: FlattenResult) -> tuple[np.ndarray, ...]:
    """Return, for the vertices of all pieces, their places, their vertices on the model and their pieces. Also return,
    for each triangle of the model, its flat vertices and its piece."""
    count = len(result.corner_uv)
    flat_triangles = np.full((count, 3), -1, dtype=np.int32)
    piece_of_triangle = np.zeros(count, dtype=np.int32)
    vertices, source_vertex, offset = [np.empty((0, 2))], [np.empty(0, dtype=np.int32)], 0
    vertex_piece = [np.empty(0, dtype=np.int32)]
    for index, piece in enumerate(result.pieces):
        piece_of_triangle[piece.source_face] = index
        if len(piece.vertices) == 0 or not np.isfinite(piece.vertices).all():
            continue
        flat_triangles[piece.source_face] = piece.faces + offset
        vertices.append(piece.vertices)
        source_vertex.append(piece.source_vertex)
        vertex_piece.append(np.full(len(piece.vertices), index, dtype=np.int32))
        offset += len(piece.vertices)
    return (
        np.concatenate(vertices),
        np.concatenate(source_vertex).astype(np.int32),
        np.concatenate(vertex_piece),
        flat_triangles,
        piece_of_triangle,
    )


def _model_areas(result: FlattenResult, arrays: MeshArrays, flat: np.ndarray) -> np.ndarray:
    """Return the areas (m,) of the triangles on the model; for thick materials, in the middle of the thickness.

    flat (m,): flat areas. Of triangles without a flat area, the area in the mesh is returned.
    """
    weft, warp, shear = _threads_of_triangles(result)
    with np.errstate(invalid="ignore"):
        measured = np.abs(flat) * (1 + weft) * (1 + warp) * np.cos(shear)
    return np.where(np.isfinite(measured), measured, triangle_areas(arrays.vertices, arrays.triangles))


def _loops_of(arrays: MeshArrays, kept: np.ndarray) -> np.ndarray:
    """Return the corners of the kept polygons, one polygon after the other. For mirrored objects, the corners of each
    polygon are in reverse order."""
    sizes = arrays.polygon_sizes[kept]
    starts = np.repeat(arrays.polygon_starts[kept], sizes)
    step = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    return starts + (np.repeat(sizes, sizes) - 1 - step if arrays.mirrored else step)


def _edge_corners(source_corner: np.ndarray, sizes: np.ndarray, arrays: MeshArrays) -> np.ndarray:
    """Return, for each corner (l,), the corner at which its side begins on the source. If faces are reversed, this is
    the source of the corner at which the side ends on the flat mesh."""
    return source_corner[next_corners(sizes)] if arrays.mirrored else source_corner


def _edges(
    loop_vertices: np.ndarray, source_corner: np.ndarray, sizes: np.ndarray, arrays: MeshArrays
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the edges of the flat mesh, int32: ends (e,2), edge at each corner (l,), edge of the source (e,).

    Sides that have the same ends and come from the same source edge share an edge.
    """
    following = next_corners(sizes)
    source_edge = arrays.loop_edges[_edge_corners(source_corner, sizes, arrays)]
    ends = loop_vertices, loop_vertices[following]
    low, high = np.minimum(*ends), np.maximum(*ends)
    first = np.empty(len(arrays.edges), dtype=np.int64)
    first[source_edge] = np.arange(len(source_edge))  # any corner at which the edge begins
    first = first[source_edge]
    other = np.flatnonzero((low != low[first]) | (high != high[first]))  # corners on the other side of seams
    _, rows, inverse = np.unique(
        np.column_stack([source_edge, low, high])[other], axis=0, return_index=True, return_inverse=True
    )
    first[other] = other[rows][inverse.ravel()]
    is_first = np.zeros(len(first), dtype=bool)
    is_first[first] = True
    number = np.cumsum(is_first, dtype=np.int32) - 1
    return np.column_stack([low, high])[is_first], number[first], source_edge[is_first]


def _signed_areas(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the signed areas (m,) of triangles (m,3) of vertices (p,2)."""
    x, y = (np.ascontiguousarray(column)[triangles] for column in vertices.T)
    return ((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2


@dataclass(frozen=True)
class FlatMarks:
    seams: np.ndarray  # (e,) bool
    seam_ids: np.ndarray  # (e,) int32, 0 none
    wires: EdgeMarks


def flat_marks(source_edges: np.ndarray, arrays: MeshArrays) -> FlatMarks:
    """Return the marks of the flat edges. source_edges (e,): the model's edge of each flat edge."""
    seams, seam_ids = np.zeros(len(arrays.edges), dtype=bool), np.zeros(len(arrays.edges), dtype=np.int32)
    seams[arrays.seam_edges], seam_ids[arrays.seam_edges] = True, arrays.seam_ids
    marks = EdgeMarks.none(len(arrays.edges))
    for wire in arrays.wires:
        rows = wire.chain.edges
        marks.wire_ids[rows], marks.tolerances[rows] = wire.chain.wire_id, wire.chain.tolerance
        marks.eases[rows] = wire.chain.ease
    return FlatMarks(seams[source_edges], seam_ids[source_edges], marks.take(source_edges))
