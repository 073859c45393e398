# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that joined wires brought along go into the list before the file is saved, for their meshes are not saved."""

import bpy
from bpy.app.handlers import persistent

from .wire_attributes import has_marks, wires_on
from .wire_names import update_names


@persistent
def _write_names(*_: object) -> None:
    for mesh in bpy.data.meshes:
        if mesh.library is None and not mesh.is_editmode and has_marks(mesh):
            update_names(mesh, wires_on(mesh))


def attach() -> None:
    bpy.app.handlers.save_pre.append(_write_names)


def detach() -> None:
    bpy.app.handlers.save_pre.remove(_write_names)
