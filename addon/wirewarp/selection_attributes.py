# SPDX-License-Identifier: GPL-3.0-or-later
"""Which elements of a mesh are selected in Edit Mode, as Blender keeps it."""

import bpy


def deselect_all(mesh: bpy.types.Mesh) -> None:
    """Of a mesh in Object Mode. New elements are selected.

    The attributes themselves go: Blender 5.0 gives that of the edges of new meshes a wrong type, and crashes as soon as
    it is written or Edit Mode is entered.
    """
    for name in (".select_vert", ".select_edge", ".select_poly"):
        if attribute := mesh.attributes.get(name):
            mesh.attributes.remove(attribute)
