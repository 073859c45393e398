# SPDX-License-Identifier: GPL-3.0-or-later
"""Unwraps a surface with Blender, in a Python with bpy:

PYTHONPATH=results python bench/unwrap_in_blender.py INPUT.npz METHOD OUTPUT.npz

INPUT: vertices, faces, seams
OUTPUT: corner_uv (m, 3, 2), seconds, megabytes
"""

import sys

import bpy
import numpy as np
from model_in_blender import add_model, read_uv
from peak_memory import cost_of


def main() -> None:
    surface, method, output = sys.argv[1:]
    found = np.load(surface)
    mesh = add_model(found["vertices"], found["faces"].tolist(), found["seams"])
    _, seconds, megabytes = cost_of(lambda: bpy.ops.uv.unwrap(method=method, margin=0.001))
    np.savez(output, corner_uv=read_uv(mesh).reshape(-1, 3, 2), seconds=seconds, megabytes=megabytes)


main()
