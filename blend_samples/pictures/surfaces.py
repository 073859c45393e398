# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the data that a picture needs from Blender meshes into arrays: a model and its flat pieces."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
import numpy as np


@dataclass(frozen=True)
class Model:
    """A modeled sample. Edges are vertex pairs."""

    vertices: np.ndarray  # (n, 3), Blender units
    normals: np.ndarray  # (n, 3), unit
    triangles: np.ndarray  # (m, 3); larger faces are divided at their first corner
    seams: np.ndarray  # (k, 2)
    outline: np.ndarray  # (k, 2), edges with one face
    wires: np.ndarray  # (k, 2)
    tolerances: np.ndarray  # (k,) tolerance at each edge of `wires`


@dataclass(frozen=True)
class Flat:
    """The flat pieces of a sample. The outline includes both sides of each seam."""

    vertices: np.ndarray  # (p, 3), Blender units, z 0
    source_vertex: np.ndarray  # (p,) vertex of the model for each vertex
    triangles: np.ndarray  # (m, 3), faces divided as in Model
    piece: np.ndarray  # (m,) number of the piece, from 0
    outline: np.ndarray  # (k, 2)
    wires: np.ndarray  # (k, 2)
    tolerances: np.ndarray  # (k,) tolerance at each edge of `wires`


def read_model(thing: bpy.types.Object) -> Model:
    """Return the data of a mesh with Blender's seams and the add-on's wires."""
    mesh = thing.data
    seam = np.empty(len(mesh.edges), dtype=bool)
    mesh.edges.foreach_get("use_seam", seam)
    edges = _edges(mesh)
    wire = _attribute(mesh, "wirewarp_wire", np.int32) != 0
    return Model(
        vertices=_vectors(mesh, "co"),
        normals=_vectors(mesh, "normal"),
        triangles=_triangles(mesh)[0],
        seams=edges[seam],
        outline=edges[_face_counts(mesh) == 1],
        wires=edges[wire],
        tolerances=_attribute(mesh, "wirewarp_tolerance", np.float32)[wire],
    )


def read_flat(thing: bpy.types.Object) -> Flat:
    """Return the data of the flat object that the add-on made from the model."""
    mesh = thing.data
    triangles, polygon = _triangles(mesh)
    edges = _edges(mesh)
    wire = _attribute(mesh, "wirewarp_wire", np.int32) != 0
    return Flat(
        vertices=_vectors(mesh, "co"),
        source_vertex=_attribute(mesh, "source_vertex", np.int32),
        triangles=triangles,
        piece=_attribute(mesh, "piece", np.int32)[polygon],
        outline=edges[_face_counts(mesh) == 1],
        wires=edges[wire],
        tolerances=_attribute(mesh, "wirewarp_tolerance", np.float32)[wire],
    )


def _attribute(mesh: bpy.types.Mesh, name: str, dtype: type) -> np.ndarray:
    data = mesh.attributes[name].data
    values = np.empty(len(data), dtype=dtype)
    data.foreach_get("value", values)
    return values


def _vectors(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    values = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get(name, values)
    return values.reshape(-1, 3).astype(float)


def _edges(mesh: bpy.types.Mesh) -> np.ndarray:
    pairs = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", pairs)
    return pairs.reshape(-1, 2)


def _face_counts(mesh: bpy.types.Mesh) -> np.ndarray:
    """Return the number (e,) of faces at each edge."""
    edge_of_corner = np.empty(len(mesh.loops), dtype=np.int32)
    mesh.loops.foreach_get("edge_index", edge_of_corner)
    return np.bincount(edge_of_corner, minlength=len(mesh.edges))


def _triangles(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners (m, 3) and the polygon (m,) of each triangle."""
    cut = [
        (polygon.index, face[0], face[k], face[k + 1])
        for polygon in mesh.polygons
        for face in [polygon.vertices]
        for k in range(1, len(face) - 1)
    ]
    table = np.array(cut)
    return table[:, 1:], table[:, 0]
