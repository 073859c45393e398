# SPDX-License-Identifier: GPL-3.0-or-later
"""An object in Object Mode to plain arrays in world scale."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

import bpy
import numpy as np

from .foreach import read
from .issues import object_error
from .marking import own_ids
from .mesh_arrays import MeshArrays, NamedWire
from .mesh_topology import (
    corner_edges,
    corner_vertices,
    edge_vertices,
    face_sizes,
    face_starts,
    read_seams,
    triangle_corners,
)
from .pieces.attribute import read_piece_ids
from .pieces.face_regions import face_regions
from .wire_attributes import read_marks
from .wire_chains import WireChain, chains_of_marks
from .wire_names import chain_names

LARGEST = 1e18  # Blender units


def object_to_arrays(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph | None) -> MeshArrays:
    """The object's base mesh, or with a depsgraph the mesh that its modifiers make. Raises ObjectError."""
    linear = linear_part(source)
    if depsgraph is None:
        return _mesh_to_arrays(source.data, source, linear)
    with evaluated_mesh(source, depsgraph) as mesh:
        return _mesh_to_arrays(mesh, source, linear)


def _check_size(source: bpy.types.Object, vertices: np.ndarray) -> None:
    """Areas must be numbers in single precision. What is no number at all the core names by its vertex."""
    if LARGEST < np.abs(vertices).max(initial=0) < np.inf:
        raise object_error(
            "too_large",
            f'"{source.name}" is more than {LARGEST:.0e} Blender units wide, too large for true areas: scale it down.',
        )


def linear_part(source: bpy.types.Object) -> np.ndarray:
    """Rotation, scale and shear of the object, (3,3). Raises ObjectError if it squashes the mesh flat."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    lengths = np.linalg.norm(linear, axis=0)
    if not np.isfinite(linear).all() or lengths.min() == 0 or abs(np.linalg.det(linear / lengths)) < 1e-6:
        raise object_error(
            "zero_scale",
            f'"{source.name}" is scaled to zero along an axis, so its faces have no true size: '
            "set its scale (N panel > Item) to something else.",
        )
    return linear


def metric(source: bpy.types.Object) -> np.ndarray:
    """What the object's matrix does to lengths, and whether it mirrors: the same for all rotations."""
    linear = np.array(source.matrix_world, dtype=np.float64)[:3, :3]
    return np.append((linear.T @ linear).ravel(), np.linalg.det(linear))


def faces_at_edges(mesh: bpy.types.Mesh) -> np.ndarray:
    """(e,) how many faces each edge has."""
    return np.bincount(corner_edges(mesh), minlength=len(mesh.edges))


def next_loops(mesh: bpy.types.Mesh) -> np.ndarray:
    """(l,) int32, the next corner of its face for each corner."""
    starts, sizes = face_starts(mesh), face_sizes(mesh)
    following = np.arange(1, len(mesh.loops) + 1, dtype=np.int32)
    following[starts + sizes - 1] = starts
    return following


def element_counts(mesh: bpy.types.Mesh) -> dict[str, int]:
    """By which a report sees that its mesh has changed since."""
    return {"vertices": len(mesh.vertices), "edges": len(mesh.edges), "faces": len(mesh.polygons)}


@contextmanager
def evaluated_mesh(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Iterator[bpy.types.Mesh]:
    evaluated = source.evaluated_get(depsgraph)
    try:
        yield evaluated.to_mesh(preserve_all_data_layers=True, depsgraph=depsgraph)
    finally:
        evaluated.to_mesh_clear()


def _mesh_to_arrays(mesh: bpy.types.Mesh, source: bpy.types.Object, linear: np.ndarray) -> MeshArrays:
    mirrored = bool(np.linalg.det(linear) < 0)
    mesh.calc_loop_triangles()
    # A mirrored object's faces still look outward in Blender, but their corners run the other way round.
    loops = triangle_corners(mesh)
    if mirrored:
        loops = np.ascontiguousarray(loops[:, ::-1])
    loop_vertices = corner_vertices(mesh)
    vertices = read(mesh.vertices, "co", np.float32, 3).astype(np.float64) @ linear.T
    _check_size(source, vertices)
    edges = edge_vertices(mesh)
    sizes = face_sizes(mesh)
    face_count = faces_at_edges(mesh)
    in_face = face_count > 0
    marks = read_marks(mesh)
    return MeshArrays(
        vertices=vertices,
        triangles=loop_vertices[loops],
        triangle_loops=loops,
        # Blender keeps the triangles in the order of their polygons: n - 2 of each.
        triangle_polygons=np.repeat(np.arange(len(sizes), dtype=np.int32), sizes - 2),
        loop_vertices=loop_vertices,
        polygon_starts=face_starts(mesh),
        polygon_sizes=sizes,
        edges=edges,
        seams=edges[read_seams(mesh) & in_face],  # a loose edge cuts nothing
        outline=edges[face_count == 1],
        wires=_name_wires(
            source.data, chains_of_marks(edges, np.where(in_face, marks.wire_ids, 0), marks.tolerances, vertices)
        ),
        grain_wire=source.data.wirewarp_grain,
        piece_ids=read_piece_ids(mesh),
        regions=face_regions(source, mesh),
        loose_marks=int(np.count_nonzero(marks.wire_ids[~in_face])),
        mirrored=mirrored,
    )


def _name_wires(named: bpy.types.Mesh, chains: list[WireChain]) -> list[NamedWire]:
    """Each with a name and an id of its own."""
    ids = [chain.wire_id for chain in chains]
    return [
        NamedWire(name, replace(chain, wire_id=own), chain.wire_id)
        for name, own, chain in zip(chain_names(named, ids), own_ids(ids), chains, strict=True)
    ]
