# SPDX-License-Identifier: GPL-3.0-or-later
"""What stays as it is while whole flat pieces are moved and turned: by it an edit by hand is seen."""

import bpy
import numpy as np

from .flat_mesh import edge_lengths
from .foreach import read
from .pattern.outlines import signed_areas

FLAT_LENGTH = "flat_length"  # edge attribute
COUNTS, AREAS = "wirewarp_flat_counts", "wirewarp_flat_areas"  # of the flat mesh
# Of lengths in single precision, relative to the length and to the largest coordinate: pieces may have been moved.
LENGTH_ERROR, PLACE_ERROR = 1e-5, 1e-6


def remember_shape(mesh: bpy.types.Mesh) -> None:
    """Of a flat mesh as it was laid out, with its attribute of pieces."""
    lengths = mesh.attributes.new(FLAT_LENGTH, "FLOAT", "EDGE")
    lengths.data.foreach_set("value", _lengths(mesh).astype(np.float32))
    mesh[COUNTS] = _counts(mesh)
    mesh[AREAS] = _areas(mesh).tolist()


def has_kept_shape(mesh: bpy.types.Mesh) -> bool:
    """Whether no vertex, edge or face is gone or new, no edge longer or shorter, and no piece turned over."""
    lengths, counts, areas = mesh.attributes.get(FLAT_LENGTH), mesh.get(COUNTS), mesh.get(AREAS)
    if lengths is None or counts is None or areas is None or list(counts) != _counts(mesh):
        return False
    then, now = np.array(areas), _areas(mesh)
    size = float(np.abs(_places(mesh)).max())
    if len(now) != len(then) or np.any(np.abs(now - then) > np.abs(then) + PLACE_ERROR * size**2):
        return False  # mirrored, the difference is twice the area
    laid_out = read(lengths.data, "value", np.float32)
    return bool(np.all(np.abs(_lengths(mesh) - laid_out) <= LENGTH_ERROR * laid_out + PLACE_ERROR * size))


def _counts(mesh: bpy.types.Mesh) -> list[int]:
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons)]


def _places(mesh: bpy.types.Mesh) -> np.ndarray:
    return read(mesh.vertices, "co", np.float32, 3)[:, :2].astype(np.float64)


def _lengths(mesh: bpy.types.Mesh) -> np.ndarray:
    return edge_lengths(_places(mesh), read(mesh.edges, "vertices", np.int32, 2))


def _areas(mesh: bpy.types.Mesh) -> np.ndarray:
    """By piece."""
    pieces = read(mesh.attributes["piece"].data, "value", np.int32)
    loops, sizes = read(mesh.loops, "vertex_index", np.int32), read(mesh.polygons, "loop_total", np.int32)
    return signed_areas(_places(mesh), loops, sizes, pieces)
