# SPDX-License-Identifier: GPL-3.0-or-later
"""UV maps: of the source mesh the layer "WireWarp" with its pieces; of the flat mesh that and the source's own."""

import bpy
import numpy as np

from ..blender.attributes import check_free
from ..blender.mesh import write_uv as write_layer
from ..issues import object_error
from ..names import UV_LAYER, UV_SCALE
from ..solve.arrays import MeshArrays
from ..solve.flat_mesh import FlatMesh

MAX_UV_LAYERS = 8


def check_uv_room(target: bpy.types.Object) -> None:
    """Raises ObjectError where there is no room for our layer."""
    mesh = target.data
    if UV_LAYER in mesh.uv_layers:
        return
    check_free(target, UV_LAYER, "the map of the pieces")
    if len(mesh.uv_layers) >= MAX_UV_LAYERS:
        raise object_error(
            "no_uv_room",
            f'Mesh "{mesh.name}" already has {MAX_UV_LAYERS} UV maps, and Blender allows no more: '
            "delete one under Object Data > UV Maps.",
        )


def write_uv(mesh: bpy.types.Mesh, flat: FlatMesh, corner_count: int) -> float:
    """Writes the pieces as they were packed into the unit square. Faces without a layout go to (0,0).

    Returns the scale, Blender units in one UV unit; it is kept on the mesh, too.
    """
    places, scale = _in_unit_square(flat.vertices)
    layer = mesh.uv_layers.get(UV_LAYER) or mesh.uv_layers.new(name=UV_LAYER, do_init=False)
    of_corners = np.zeros((corner_count, 2), dtype=np.float32)
    _pairs(of_corners)[flat.source_corner] = _pairs(places)[flat.loop_vertices]
    write_layer(layer, of_corners)
    mesh.uv_layers.active = layer
    mesh[UV_SCALE] = scale
    return scale


def _in_unit_square(vertices: np.ndarray) -> tuple[np.ndarray, float]:
    """float32 of vertices (p,2), and the side of the square that became the unit."""
    low, high = ([pick(column) for column in vertices.T] for pick in (np.min, np.max))
    scale = float(np.subtract(high, low).max()) or 1.0
    return ((vertices - low) / scale).astype(np.float32), scale


def _pairs(places: np.ndarray) -> np.ndarray:
    """(k,) of rows (k,2) of float32: one complex number each, for these are far faster to take than rows."""
    return places.view(np.complex64)[:, 0]


def write_flat_maps(mesh: bpy.types.Mesh, flat: FlatMesh, arrays: MeshArrays) -> None:
    """On a flat mesh without maps: the source's own, by which a print is checked, and the pieces as they lie."""
    for name, places in list(arrays.uv_maps.items())[: MAX_UV_LAYERS - 1]:
        _write_new(mesh, name, _pairs(places)[flat.source_corner])
    places, _ = _in_unit_square(flat.vertices)
    _write_new(mesh, UV_LAYER, _pairs(places)[flat.loop_vertices])
    mesh.uv_layers.active = mesh.uv_layers[0]  # the source's first, where it has one


def _write_new(mesh: bpy.types.Mesh, name: str, pairs: np.ndarray) -> None:
    write_layer(mesh.uv_layers.new(name=name, do_init=False), pairs.view(np.float32).reshape(-1, 2))
