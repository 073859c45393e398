# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures as attributes and as colors on the flat mesh."""

from collections.abc import Mapping

import bpy
import numpy as np

from ..solve.flat_mesh import FlatMesh
from ..solve.maps import ARAP_ENERGY, ASPECT_RATIO, COLOR_MAPS, LENGTH_VARIATION, SHEAR, STRETCH, WARP, WEFT, ColorMap

OF_THREADS = {WEFT: "weft_strain", WARP: "warp_strain", SHEAR: "shear_angle"}  # of solve.flat_mesh.Threads
VALUES = {"arap_energy": "FACE", "aspect_ratio": "FACE", "stretch": "FACE", "length_variation": "EDGE"}


def write_maps(mesh: bpy.types.Mesh, flat: FlatMesh) -> None:
    """On a mesh that has none of these attributes."""
    for name, domain in VALUES.items():
        mesh.attributes.new(name, "FLOAT", domain).data.foreach_set("value", getattr(flat, name))
    measures = map_values(flat)
    for color_map, name in OF_THREADS.items() if flat.threads else ():
        mesh.attributes.new(name, "FLOAT", "FACE").data.foreach_set("value", measures[color_map])
    _write_colors(mesh, flat, measures)
    shown = mesh.color_attributes.find(COLOR_MAPS[0].attribute)
    mesh.color_attributes.active_color_index = mesh.color_attributes.render_color_index = shown


def map_values(flat: FlatMesh) -> dict[ColorMap, np.ndarray]:
    """(f,) by their map; (e,) for the variation of lengths."""
    of_threads = {each: getattr(flat.threads, name) for each, name in OF_THREADS.items()} if flat.threads else {}
    measures = {ASPECT_RATIO: flat.aspect_ratio, STRETCH: flat.stretch, ARAP_ENERGY: flat.energy_density}
    return measures | of_threads | {LENGTH_VARIATION: flat.length_variation}


def _write_colors(mesh: bpy.types.Mesh, flat: FlatMesh, measures: Mapping[ColorMap, np.ndarray]) -> None:
    """measures: as map_values returns them."""
    ends = flat.edges.ravel()
    edges_at = np.maximum(np.bincount(ends, minlength=len(mesh.vertices)), 1)
    sums = np.bincount(ends, np.repeat(flat.length_variation, 2), minlength=len(mesh.vertices))
    at_vertex = sums / edges_at  # the mean of its edges
    face = np.repeat(np.arange(len(flat.face_sizes)), flat.face_sizes)  # of each corner
    # A color of four float32 has the size of one complex number: to take these is far faster than to take rows. All
    # maps use the same memory, for new memory is slower still.
    taken = np.empty(len(face), dtype=np.complex128)
    for color_map, values, at_corner in (
        *((color_map, values, face) for color_map, values in measures.items() if color_map != LENGTH_VARIATION),
        (LENGTH_VARIATION, at_vertex, flat.loop_vertices),
    ):
        own = color_map.colors(values).view(np.complex128).ravel()
        np.take(own, at_corner, out=taken, mode="clip")  # with the default mode it would use memory of its own
        attribute = mesh.color_attributes.new(color_map.attribute, "FLOAT_COLOR", "CORNER")
        attribute.data.foreach_set("color", taken.view(np.float32))
