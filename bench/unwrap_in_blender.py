# SPDX-License-Identifier: GPL-3.0-or-later
"""Unwraps one surface by one of Blender's own methods; run by the Python that has the module bpy:

python bench/unwrap_in_blender.py INPUT.npz METHOD OUTPUT.npz

INPUT has vertices, faces (triangles) and seams; OUTPUT corner_uv (m, 3, 2), seconds and megabytes of bpy.ops.uv.unwrap.
"""

import sys

import bpy
import numpy as np
from peak_memory import cost_of


def add_model(vertices: np.ndarray, faces: np.ndarray, seams: np.ndarray) -> bpy.types.Mesh:
    """As the only object, active, in Edit Mode with all selected."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("Model")
    mesh.from_pydata(vertices.tolist(), [], faces.tolist())
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    keys = np.sort(ends.reshape(-1, 2), axis=1) @ [len(vertices), 1]
    is_seam = np.isin(keys, np.sort(seams, axis=1) @ [len(vertices), 1])
    mesh.edges.foreach_set("use_seam", is_seam)
    model = bpy.data.objects.new("Model", mesh)
    bpy.context.scene.collection.objects.link(model)
    bpy.context.view_layer.objects.active = model
    model.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    return mesh


def main() -> None:
    surface, method, output = sys.argv[1:]
    mesh = add_model(**np.load(surface))
    _, seconds, megabytes = cost_of(lambda: bpy.ops.uv.unwrap(method=method, margin=0.001))
    bpy.ops.object.mode_set(mode="OBJECT")
    uv = np.empty(2 * len(mesh.loops), dtype=np.float32)
    mesh.uv_layers.active.uv.foreach_get("vector", uv)
    np.savez(output, corner_uv=uv.astype(float).reshape(-1, 3, 2), seconds=seconds, megabytes=megabytes)


main()
