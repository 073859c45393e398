# SPDX-License-Identifier: GPL-3.0-or-later
"""Unwraps every sample with Blender's own methods:

blender --background --factory-startup --python-exit-code 1 --python results/unwrap_in_blender.py -- OUTPUT.npz

OUTPUT: UVs (m, 3, 2) at the corners of triangles by SAMPLE/METHOD, in islands of arbitrary size
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "blend_samples")]

from model_in_blender import add_model, read_uv  # noqa: E402 (the folders must be on the path first)
from shapes import Shape, all_shapes  # noqa: E402


def triangle_loops(shape: Shape) -> np.ndarray:
    """Return the loops (m, 3) at the corners of shape.triangles().

    The loops of a mesh in Blender are the corners of its faces, in order.
    """
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
        for method in ("ANGLE_BASED", "CONFORMAL"):
            mesh = add_model(shape.vertices, shape.faces, shape.seams)
            bpy.ops.uv.unwrap(method=method)
            unwraps[f"{shape.name}/{method}"] = read_uv(mesh)[triangle_loops(shape)]
    output.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(output, **unwraps)


main()
