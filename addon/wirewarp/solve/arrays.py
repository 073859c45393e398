# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as arrays, with its seams, wires and regions."""

from dataclasses import dataclass

import numpy as np

from ..core import LengthText
from .chains import WireChain, next_corners

# A surface has an inside if the sum of its area vectors is at most this share of its area. On a closed surface, the sum
# is zero. A ball with a hole reaches the limit if 30% of its area is missing.
ALL_ROUND = 0.3
INWARD = (
    "Normals point inward, so pieces show their inside. In Edit Mode use Mesh > Normals > Recalculate Outside, then "
    "flatten again."
)


@dataclass(frozen=True)
class Region:
    name: str
    faces: np.ndarray  # (k,) int64, faces of FaceRegions.sample that are in the region


@dataclass(frozen=True)
class FaceRegions:
    sample: np.ndarray  # (s,) int64, faces whose regions were read
    groups: list[Region]
    materials: list[Region]


@dataclass(frozen=True)
class NamedWire:
    name: str
    chain: WireChain  # with an id that no other wire has
    marked_id: int  # id on its edges, which copies of a wire share


@dataclass(frozen=True)
class MeshArrays:
    """A mesh with Blender's indices. Triangles are counterclockwise seen from outside, even for mirrored objects."""

    vertices: np.ndarray  # (n,3) float64, Blender units, with the object's rotation, scale and shear applied
    triangles: np.ndarray  # (m,3) int32, as Blender shows the faces
    triangle_loops: np.ndarray  # (m,3) int32, the loop (corner of the mesh) at each corner of the triangle
    triangle_polygons: np.ndarray  # (m,) int32, the polygon of each triangle, ascending
    loop_vertices: np.ndarray  # (l,) int32, the vertex of each corner
    loop_edges: np.ndarray  # (l,) int32, the edge from each corner to the next corner of its polygon
    polygon_starts: np.ndarray  # (f,) int32, first loop of each polygon
    polygon_sizes: np.ndarray  # (f,) int32
    edges: np.ndarray  # (e,2) int32
    seam_edges: np.ndarray  # (k,) int32, indices of the edges that are seams
    seams: np.ndarray  # (k,2) int32, the vertices of seam_edges
    seam_ids: np.ndarray  # (k,) int32, id of the seam of each seam edge in the last run; 0 none
    outline: np.ndarray  # (o,2) int32, edges with one face
    wires: list[NamedWire]
    side_eases: np.ndarray  # (l,) float32, ease of the edge from each corner, on the side of the corner's face; 0: none
    grain_wire: int  # id of the wire that is upright in its pieces; 0: no wire was chosen
    piece_ids: np.ndarray  # (f,) int32, id of the piece of each polygon in the last run; 0: none
    regions: FaceRegions
    materials: np.ndarray  # (f,) int32, the material slot of each polygon
    uv_maps: dict[str, np.ndarray]  # (l,2) float32, the model's own maps by name
    own_map: str  # the map whose island borders can become seams; "": none
    allowance: float  # the widest allowance, in Blender units
    side_allowances: np.ndarray  # (l,) float32, as for side_eases, in Blender units; 0: default, below 0: none
    loose_marks: int  # number of edges that are marked as wires, but ignored because they have no face
    loose_eases: int  # number of edges with an ease that has no effect, because they are not wires
    mirrored: bool  # whether the object's matrix mirrors the mesh
    default_allowance: float = 0.0  # for sides without their own allowance, in Blender units
    lengths: LengthText = LengthText("", 1.0)  # format of lengths in sentences; no unit if the scene is unknown


def area_vectors(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the area vectors (3,m) of triangles (m,3) of vertices (n,3). Each is along its triangle's normal, with the
    area as its length."""
    x, y, z = (np.ascontiguousarray(column)[triangles] for column in vertices.T)  # (m,3), one per corner
    ux, uy, uz = (each[:, 1] - each[:, 0] for each in (x, y, z))
    vx, vy, vz = (each[:, 2] - each[:, 0] for each in (x, y, z))
    return np.array([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]) / 2


def triangle_areas(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Return the areas (m,) of triangles (m,3) of vertices (n,3)."""
    x, y, z = area_vectors(vertices, triangles)
    return np.sqrt(x * x + y * y + z * z)


def edge_lengths(points: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Return the lengths of edges (k,2) between points (n,2) or (n,3). Coordinates are gathered one by one, because
    gathering short rows is slow."""
    a, b = edges.T
    columns = (np.ascontiguousarray(column) for column in points.T)
    return np.sqrt(sum((column[a] - column[b]) ** 2 for column in columns))


def faces_inward(arrays: MeshArrays) -> bool:
    """Return whether the faces of a model with an inside, such as a bodice, a sleeve or a ball, point inward."""
    vectors = area_vectors(arrays.vertices, arrays.triangles)
    areas = np.linalg.norm(vectors, axis=0)
    if len(areas) == 0 or np.linalg.norm(vectors.sum(axis=1)) > ALL_ROUND * areas.sum():
        return False
    centers = arrays.vertices[arrays.triangles].mean(axis=1)
    middle = (centers.min(axis=0) + centers.max(axis=0)) / 2
    return bool(np.sum((centers - middle).T * vectors) < 0)


TOGETHER = 1e-4  # share of the UV square's side: closer corners count as one, as in Blender's islands


def new_seams(arrays: MeshArrays) -> np.ndarray:
    """Return the edges (k,) that are borders of islands in the model's own UV map and not seams yet; empty without a
    map."""
    if not arrays.own_map:
        return np.empty(0, dtype=np.int32)
    following, uv = next_corners(arrays.polygon_sizes), arrays.uv_maps[arrays.own_map]
    borders = island_borders(arrays.loop_edges, arrays.loop_vertices, following, uv, len(arrays.edges))
    return np.setdiff1d(np.flatnonzero(borders), arrays.seam_edges).astype(np.int32)


def island_borders(
    loop_edges: np.ndarray, loop_vertices: np.ndarray, next_loops: np.ndarray, uv: np.ndarray, edge_count: int
) -> np.ndarray:
    """Return a mask (e,) of the edges whose two faces are not side by side in the map.

    loop_edges, loop_vertices, next_loops (l,): edge, vertex and next corner of each corner
    uv (l,2): places of the corners in the map
    """
    turned = loop_vertices > loop_vertices[next_loops]
    ends = np.column_stack([uv, uv[next_loops]])  # (l,4): both ends of the edge in the map, on the side of this face
    ends[turned] = ends[turned][:, [2, 3, 0, 1]]  # from the vertex with the lower index to the other vertex
    lowest, highest = np.full((edge_count, 4), np.inf), np.full((edge_count, 4), -np.inf)
    np.minimum.at(lowest, loop_edges, ends)
    np.maximum.at(highest, loop_edges, ends)
    return (highest - lowest > TOGETHER).any(axis=1)


def with_split_quads(corners: np.ndarray, starts: np.ndarray, sizes: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return the triangles (m,3) with quads split by Blender's rule, so that all modes lead to the same pieces.

    Blender 3.4 splits some bent quads differently if it has stored their normals.

    corners (m,3): corners of Blender's triangles, in the order of the faces
    starts, sizes (f,): first corner and number of corners of each face
    places (l,3): places of the corners
    """
    quads = np.flatnonzero(sizes == 4)
    if not len(quads):
        return corners
    first = starts[quads].astype(np.int32)
    second, third, fourth = (places[first + k].astype(np.float64) - places[first] for k in (1, 2, 3))
    # Split from second to fourth corner if both triangles would otherwise be on the same side of the diagonal.
    across = np.sum(np.cross(second, third) * np.cross(fourth, third), axis=1) > 0
    rows = (np.cumsum(sizes - 2) - (sizes - 2))[quads]
    split = corners.copy()
    split[rows] = first[:, None] + np.where(across[:, None], [0, 1, 3], [0, 1, 2]).astype(np.int32)
    split[rows + 1] = first[:, None] + np.where(across[:, None], [1, 2, 3], [0, 2, 3]).astype(np.int32)
    return split
