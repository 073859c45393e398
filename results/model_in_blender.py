# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds a model to unwrap and reads its UV map, for scripts that Blender runs."""

from collections.abc import Sequence

import bpy
import numpy as np


def add_model(vertices: np.ndarray, faces: Sequence[Sequence[int]], seams: np.ndarray) -> bpy.types.Mesh:
    """Make a new file with this model only. The model is active and in Edit Mode, with all faces selected."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("Model")
    mesh.from_pydata(vertices.tolist(), [], faces)
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    keys = np.sort(ends.reshape(-1, 2), axis=1) @ [len(vertices), 1]
    mesh.edges.foreach_set("use_seam", np.isin(keys, np.sort(seams.reshape(-1, 2), axis=1) @ [len(vertices), 1]))
    model = bpy.data.objects.new("Model", mesh)
    bpy.context.scene.collection.objects.link(model)
    bpy.context.view_layer.objects.active = model
    model.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    return mesh


def read_uv(mesh: bpy.types.Mesh) -> np.ndarray:
    """Leave Edit Mode, and return the UVs (loops, 2)."""
    bpy.ops.object.mode_set(mode="OBJECT")
    uv = np.empty(2 * len(mesh.loops), dtype=np.float32)
    mesh.uv_layers.active.data.foreach_get("uv", uv)
    return uv.reshape(-1, 2).astype(float)
