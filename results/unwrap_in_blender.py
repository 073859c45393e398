# SPDX-License-Identifier: GPL-3.0-or-later
"""Unwraps every sample with Blender's own methods, for write_page.py to measure; needs no add-on:

blender --background --factory-startup --python-exit-code 1 --python results/unwrap_in_blender.py -- OUTPUT.npz

The file has an array (m, 3, 2) "SAMPLE/METHOD" each: the UVs at the corners of the sample's triangles, as Blender left
them: in the unit square, every island at a size of its own choice.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "blend_samples"))

from shapes import Shape, all_shapes  # noqa: E402 (the folder must be on the path first)


def add_mesh(shape: Shape) -> bpy.types.Mesh:
    """The sample as the only object, active, with its seams marked."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    mesh = bpy.data.meshes.new(shape.name)
    mesh.from_pydata(shape.vertices.tolist(), [], shape.faces)
    seams = {frozenset(pair) for pair in shape.seams.tolist()}
    for edge in mesh.edges:
        edge.use_seam = frozenset(edge.vertices) in seams
    model = bpy.data.objects.new(shape.name, mesh)
    bpy.context.scene.collection.objects.link(model)
    bpy.context.view_layer.objects.active = model
    model.select_set(True)
    return mesh


def unwrap(mesh: bpy.types.Mesh, method: str) -> np.ndarray:
    """(loops, 2) UVs."""
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.unwrap(method=method)
    bpy.ops.object.mode_set(mode="OBJECT")
    uv = np.empty(2 * len(mesh.loops), dtype=np.float32)
    mesh.uv_layers.active.data.foreach_get("uv", uv)
    return uv.reshape(-1, 2).astype(float)


def triangle_loops(shape: Shape) -> np.ndarray:
    """(m, 3) the loops at the corners of shape.triangles(); a mesh has its faces' corners as loops, one by one."""
    starts = np.cumsum([0, *map(len, shape.faces[:-1])])
    triangles = [
        (start, start + k, start + k + 1)
        for start, face in zip(starts, shape.faces, strict=True)
        for k in range(1, len(face) - 1)
    ]
    return np.array(triangles)


def main() -> None:
    output = Path(sys.argv[sys.argv.index("--") + 1])
    unwraps = {}
    for shape in all_shapes():
        mesh = add_mesh(shape)
        for method in ("ANGLE_BASED", "CONFORMAL"):
            unwraps[f"{shape.name}/{method}"] = unwrap(mesh, method)[triangle_loops(shape)]
    output.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(output, **unwraps)


main()
