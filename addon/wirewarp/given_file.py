# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths as users and scripts give them to operators."""

from pathlib import Path

import bpy

# Options of a property that takes them; before 4.5 Blender asks for none.
OPTIONS = {"SKIP_SAVE", "PATH_SUPPORTS_BLEND_RELATIVE"} if bpy.app.version >= (4, 5, 0) else {"SKIP_SAVE"}


def given_file(path: str) -> Path:
    """With "//" for the folder of the Blender file. Raises OSError where there is none."""
    if path.startswith("//") and not bpy.data.filepath:
        raise OSError('"//" is the folder of the Blender file, which has not been saved yet')
    return Path(bpy.path.abspath(path))
