# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures as attributes and as colors: on the flat mesh always, on the model if the user wants them there."""

from typing import NamedTuple

import bpy
import numpy as np

from ..blender.attributes import check_room
from ..solve.arrays import MeshArrays
from ..solve.flat_mesh import FlatMesh
from ..solve.maps import ARAP_ENERGY, ASPECT_RATIO, COLOR_MAPS, LENGTH_VARIATION, NO_LAYOUT, STRETCH, ModelMaps

PREFIX = "wirewarp_"  # of the model's attributes, among which are the user's own
RANGE = "wirewarp_range_"  # on the flat mesh, before the name of each map: its smallest and its largest value
VALUES = {"arap_energy": "FACE", "aspect_ratio": "FACE", "stretch": "FACE", "length_variation": "EDGE"}
ON_MODEL = {  # the attributes there, with type and domain
    **{PREFIX + name: ("FLOAT", domain) for name, domain in VALUES.items()},
    **{PREFIX + each.attribute: ("FLOAT_COLOR", "CORNER") for each in COLOR_MAPS},
}


class Corners(NamedTuple):
    """Of a mesh, as known without asking Blender again."""

    face: np.ndarray  # (l,) the face of each corner
    vertex: np.ndarray  # (l,)
    edges: np.ndarray  # (e,2)


def check_map_room(target: bpy.types.Object) -> None:
    """Raises ObjectError where the maps cannot be written to the object's mesh."""
    for name, (data_type, domain) in ON_MODEL.items():
        check_room(target, name, data_type, domain, "a map of the option Model Maps")


def write_flat_maps(mesh: bpy.types.Mesh, flat: FlatMesh, edges: np.ndarray, variation: np.ndarray) -> None:
    """On a mesh that has none of these attributes. edges: all of its; variation: their E_L."""
    corners = Corners(np.repeat(np.arange(len(flat.polygon_sizes)), flat.polygon_sizes), flat.loop_vertices, edges)
    _write_values(mesh, "", flat, variation)
    _write_colors(mesh, "", flat, variation, corners, np.ones(len(mesh.polygons), dtype=bool))
    values = {ASPECT_RATIO: flat.aspect_ratio, STRETCH: flat.stretch, ARAP_ENERGY: flat.energy_density}
    for color_map, measured in (values | {LENGTH_VARIATION: variation}).items():
        mesh[f"{RANGE}{color_map.attribute}"] = [float(measured.min()), float(measured.max())]
    _show(mesh, COLOR_MAPS[0].attribute)


def write_model_maps(mesh: bpy.types.Mesh, maps: ModelMaps, arrays: MeshArrays) -> None:
    """Replaces those of an earlier run. Colors of the user's own that are shown stay the shown ones."""
    remove_model_maps(mesh)
    own = mesh.color_attributes.active_color
    shown = own.name if own else PREFIX + COLOR_MAPS[0].attribute
    _write_values(mesh, PREFIX, maps, maps.length_variation)
    faces = np.repeat(np.arange(len(arrays.polygon_sizes)), arrays.polygon_sizes)
    corners = Corners(faces, arrays.loop_vertices, arrays.edges)
    _write_colors(mesh, PREFIX, maps, maps.length_variation, corners, maps.placed)
    _show(mesh, shown)


def remove_model_maps(mesh: bpy.types.Mesh) -> None:
    """What only has the name of one stays: it is not ours."""
    for name, kind in ON_MODEL.items():
        attribute = mesh.attributes.get(name)
        if attribute and (attribute.data_type, attribute.domain) == kind:
            mesh.attributes.remove(attribute)


def _write_values(mesh: bpy.types.Mesh, prefix: str, maps: FlatMesh | ModelMaps, variation: np.ndarray) -> None:
    for name, domain in VALUES.items():
        values = variation if name == "length_variation" else getattr(maps, name)
        mesh.attributes.new(prefix + name, "FLOAT", domain).data.foreach_set("value", values)


def _write_colors(
    mesh: bpy.types.Mesh,
    prefix: str,
    maps: FlatMesh | ModelMaps,
    variation: np.ndarray,
    corners: Corners,
    placed: np.ndarray,
) -> None:
    """variation of the edges; placed (f,) bool: faces with a layout."""
    ends = corners.edges.ravel()
    edges_at = np.maximum(np.bincount(ends, minlength=len(mesh.vertices)), 1)
    at_vertex = np.bincount(ends, np.repeat(variation, 2), minlength=len(mesh.vertices)) / edges_at  # their mean
    unplaced = np.flatnonzero(~placed[corners.face])
    # A color of four float32 has the size of one complex number: to take these is far faster than to take rows. All
    # maps use the same memory, for new memory is slower still.
    taken = np.empty(len(corners.face), dtype=np.complex128)
    colors = taken.view(np.float32).reshape(-1, 4)
    for color_map, values, at_corner in (
        (ASPECT_RATIO, maps.aspect_ratio, corners.face),
        (STRETCH, maps.stretch, corners.face),
        (ARAP_ENERGY, maps.energy_density, corners.face),
        (LENGTH_VARIATION, at_vertex, corners.vertex),
    ):
        own = color_map.colors(values).view(np.complex128).ravel()
        np.take(own, at_corner, out=taken, mode="clip")  # with the default mode it would use memory of its own
        colors[unplaced] = NO_LAYOUT
        attribute = mesh.color_attributes.new(prefix + color_map.attribute, "FLOAT_COLOR", "CORNER")
        attribute.data.foreach_set("color", colors.ravel())


def _show(mesh: bpy.types.Mesh, name: str) -> None:
    shown = mesh.color_attributes.find(name)
    mesh.color_attributes.active_color_index = mesh.color_attributes.render_color_index = shown
