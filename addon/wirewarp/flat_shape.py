# SPDX-License-Identifier: GPL-3.0-or-later
"""What stays as it is while whole flat pieces are moved and turned: by it an edit by hand is seen."""

import bpy
import numpy as np

from .flat_mesh import edge_lengths
from .foreach import read_attribute
from .pattern.flat_pieces import FlatPieces
from .pattern.outlines import outline_of, signed_areas
from .read_flat_pieces import read_flat_pieces
from .stored_numbers import read_numbers

FLAT_LENGTH = "flat_length"  # edge attribute
COUNTS, AREAS = "wirewarp_flat_counts", "wirewarp_flat_areas"  # of the flat mesh
# Of lengths in single precision, relative to the length and to the largest coordinate: pieces may have been moved.
LENGTH_ERROR, PLACE_ERROR = 1e-5, 1e-6


def remember_shape(mesh: bpy.types.Mesh, pieces: FlatPieces) -> None:
    """Of a flat mesh as it was laid out; pieces: all of it."""
    lengths = mesh.attributes.new(FLAT_LENGTH, "FLOAT", "EDGE")
    lengths.data.foreach_set("value", edge_lengths(pieces.vertices, pieces.edges).astype(np.float32))
    mesh[COUNTS] = _counts(mesh)
    mesh[AREAS] = _areas(pieces).tolist()


def has_kept_shape(mesh: bpy.types.Mesh) -> bool:
    """Whether no vertex, edge or face is gone or new, no edge longer or shorter, and no piece turned over.

    Of a mesh with the attributes of flat pieces.
    """
    laid_out, then = read_attribute(mesh, FLAT_LENGTH, "FLOAT", "EDGE"), read_numbers(mesh, AREAS)
    if laid_out is None or then is None or not np.array_equal(read_numbers(mesh, COUNTS), _counts(mesh)):
        return False
    pieces = read_flat_pieces(mesh, 1.0)
    now = _areas(pieces)
    size = float(np.abs(pieces.vertices).max(initial=0))
    if len(now) != len(then) or np.any(np.abs(now - then) > np.abs(then) + PLACE_ERROR * size**2):
        return False  # mirrored, the difference is twice the area
    difference = np.abs(edge_lengths(pieces.vertices, pieces.edges) - laid_out)
    return bool(np.all(difference <= LENGTH_ERROR * laid_out + PLACE_ERROR * size))


def _counts(mesh: bpy.types.Mesh) -> list[int]:
    return [len(mesh.vertices), len(mesh.edges), len(mesh.polygons)]


def _areas(pieces: FlatPieces) -> np.ndarray:
    """By piece."""
    return signed_areas(pieces.vertices, outline_of(pieces))
