# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of what is made of an object."""

import bpy

LONGEST = 255 if bpy.app.version >= (5, 0, 0) else 63  # bytes; Blender cuts what is longer


def name_with(name: str, ending: str) -> str:
    """The name, cut so that the ending fits behind it: by that users and scripts know what it is."""
    room = LONGEST - len(ending.encode())
    return name.encode()[:room].decode(errors="ignore") + ending
