# SPDX-License-Identifier: GPL-3.0-or-later
"""How far Blender's own unwrap is off on the samples, measured by WireWarp's code:

blender --background --factory-startup --python-exit-code 1 --addons wirewarp_addon \\
    --python blend_samples/compare_unwrap.py

Each sample is unwrapped by both methods of Blender 3.4; every island is then scaled to its area on the model.
"""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

import bpy
import numpy as np
from wirewarp_addon import core

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from shapes import Shape, all_shapes  # noqa: E402 (the folder must be on the path first)


def unwrap(shape: Shape, method: str) -> np.ndarray:
    """(m, 3, 2) UVs at the corners of shape.triangles()."""
    bpy.ops.wm.open_mainfile(filepath=str(FOLDER / f"{shape.name.lower().replace(' ', '_')}.blend"))
    mesh = bpy.context.view_layer.objects.active.data
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.unwrap(method=method)
    bpy.ops.object.mode_set(mode="OBJECT")
    uv = np.empty(2 * len(mesh.loops), dtype=np.float32)
    mesh.uv_layers.active.data.foreach_get("uv", uv)
    corners = [
        (p.loop_start, p.loop_start + k, p.loop_start + k + 1)
        for p in mesh.polygons
        for k in range(1, p.loop_total - 1)
    ]
    return uv.reshape(-1, 2).astype(float)[np.array(corners)]


def measure_true_size(library: ModuleType, shape: Shape, corner_uv: np.ndarray) -> object:
    """The library's measures after every island was scaled to its area on the model."""
    wires = [library.Wire(wire.vertices, name=wire.name) for wire in shape.wires]
    arguments = {"seams": shape.seams, "wires": wires}
    pieces = library.measure(shape.vertices, shape.triangles(), corner_uv, **arguments).pieces
    scaled = corner_uv.copy()
    for piece in pieces:
        scaled[piece.source_face] *= np.sqrt(piece.metrics.area_3d / abs(piece.metrics.area_2d))
    return library.measure(shape.vertices, shape.triangles(), scaled, **arguments)


def wire_error(wire: object) -> float:
    return abs(wire.length_2d - wire.length_3d)


print(f"{'mm':20}{'method':14}{'seam sides differ by':>22}{'wire longer or shorter by':>40}")
for sample in all_shapes():
    for unwrap_method in ("ANGLE_BASED", "CONFORMAL"):
        result = measure_true_size(core.library(), sample, unwrap(sample, unwrap_method))
        mismatch = max((seam.mismatch for seam in result.seams), default=0.0)
        worst = max(result.wires, key=wire_error)
        wire_text = f"{1000 * wire_error(worst):.2f} ({worst.name})"
        print(f"{sample.name:20}{unwrap_method:14}{1000 * mismatch:22.2f}{wire_text:>40}")
