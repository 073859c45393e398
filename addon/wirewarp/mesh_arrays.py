# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as arrays, with its seams, wires and regions. No Blender in here."""

from dataclasses import dataclass

import numpy as np

from .pieces.regions import FaceRegions
from .wire_chains import WireChain


@dataclass(frozen=True)
class NamedWire:
    name: str
    chain: WireChain  # with an id that no other wire has
    marked_id: int  # the id that its edges carry: a wire that was copied shares it with its copies


@dataclass(frozen=True)
class MeshArrays:
    """Indices are Blender's. Triangles are wound so that the surface is seen from outside, mirrored objects' too."""

    vertices: np.ndarray  # (n,3) float64, Blender units, the object's rotation, scale and shear applied
    triangles: np.ndarray  # (m,3) int32, as Blender shows the faces
    triangle_loops: np.ndarray  # (m,3) int32, the loop at each corner
    triangle_polygons: np.ndarray  # (m,) int32, ascending
    loop_vertices: np.ndarray  # (l,) int32
    polygon_starts: np.ndarray  # (f,) int32, first loop of each polygon
    polygon_sizes: np.ndarray  # (f,) int32
    edges: np.ndarray  # (e,2) int32
    seams: np.ndarray  # (k,2) int32
    outline: np.ndarray  # (k,2) int32, edges of one face
    wires: list[NamedWire]
    grain_wire: int  # id of the wire that stands upright in its pieces; 0: none was chosen
    piece_ids: np.ndarray  # (f,) int32, of the pieces that the polygons were in when last flattened; 0 none
    regions: FaceRegions
    loose_marks: int  # edges without a face that are marked as wires: they are left out
    mirrored: bool
