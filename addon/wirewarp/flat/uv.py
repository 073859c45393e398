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
from ..solve.flatten import has_layout

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


def write_uv(mesh: bpy.types.Mesh, corner_uv: np.ndarray, arrays: MeshArrays) -> float:
    """Writes corner_uv (m,3,2) in Blender units into the unit square. Faces without a layout go to (0,0).

    Returns the scale, Blender units in one UV unit; it is kept on the mesh, too.
    """
    loop_uv, scale = _loop_coordinates(corner_uv, arrays)
    layer = mesh.uv_layers.get(UV_LAYER) or mesh.uv_layers.new(name=UV_LAYER, do_init=False)
    write_layer(layer, loop_uv)
    mesh.uv_layers.active = layer
    mesh[UV_SCALE] = scale
    return scale


def _loop_coordinates(corner_uv: np.ndarray, arrays: MeshArrays) -> tuple[np.ndarray, float]:
    """UVs (l,2) float32 of all loops in the unit square, and the side of the square that became that."""
    placed = has_layout(corner_uv)
    uv = corner_uv if placed.all() else corner_uv[placed]
    low = np.array([uv[..., 0].min(), uv[..., 1].min()])
    scale = float(max(uv[..., 0].max() - low[0], uv[..., 1].max() - low[1]))
    uv = uv - low
    uv /= scale  # in its own place, for new memory is what takes the time
    np.clip(uv, 0, 1, out=uv)
    loops = arrays.triangle_loops if placed.all() else arrays.triangle_loops[placed]
    loop_uv = np.zeros((len(arrays.loop_vertices), 2), dtype=np.float32)
    # The corners that triangles of one quad share lie in one piece, so they write the same numbers. A pair of float32
    # has the size of one complex number: to put these is faster than to put rows.
    pairs = uv.reshape(-1, 2).astype(np.float32)
    loop_uv.view(np.complex64)[loops.ravel(), 0] = pairs.view(np.complex64)[:, 0]
    return loop_uv, scale


def write_flat_maps(mesh: bpy.types.Mesh, flat: FlatMesh, arrays: MeshArrays) -> None:
    """On a flat mesh without maps: the source's own, by which a print is checked, and the pieces as they lie."""
    for name, places in list(arrays.uv_maps.items())[: MAX_UV_LAYERS - 1]:
        write_layer(mesh.uv_layers.new(name=name, do_init=False), places[flat.source_corner])
    low = flat.vertices.min(axis=0)
    places = ((flat.vertices - low) / max(float((flat.vertices - low).max()), 1e-300)).astype(np.float32)
    own = mesh.uv_layers.new(name=UV_LAYER, do_init=False)
    write_layer(own, places[flat.loop_vertices])
    mesh.uv_layers.active = mesh.uv_layers[0]  # the source's first, where it has one
