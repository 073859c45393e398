# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces that break a promise are red in the viewport, so that nobody cuts them by mistake."""

import bpy
import numpy as np

MATERIAL = "WireWarp Failed Piece"
RED = (0.8, 0.02, 0.02, 1.0)


def show_failed(mesh: bpy.types.Mesh, failed: np.ndarray) -> None:
    """Gives the faces (f,) bool our material; it is taken off the mesh if there are none. Others' slots stay."""
    slot = next((i for i, material in enumerate(mesh.materials) if material and material.name == MATERIAL), -1)
    if not failed.any():
        if slot >= 0:
            mesh.materials.pop(index=slot)
        return
    if slot < 0:
        if not mesh.materials:
            mesh.materials.append(None)  # of the good pieces
        slot = len(mesh.materials)
        mesh.materials.append(bpy.data.materials.get(MATERIAL) or _new_material())
    mesh.polygons.foreach_set("material_index", np.where(failed, slot, 0).astype(np.int32))


def _new_material() -> bpy.types.Material:
    material = bpy.data.materials.new(MATERIAL)
    material.diffuse_color = RED
    return material
