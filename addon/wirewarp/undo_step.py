# SPDX-License-Identifier: GPL-3.0-or-later
"""One undo step for all that an operator writes, from Edit Mode too."""

import bpy


def hold_whole_file() -> None:
    """Makes the operator's undo step one of the whole file. To be called while it writes.

    In Edit Mode Blender's steps hold the edited meshes only, and undo would leave the flat pieces behind. But whenever
    a data-block has come or gone since the whole file was last kept, Blender keeps it again, hidden, with the next
    such step; going back before that step brings back both. So one comes and goes.
    """
    bpy.data.meshes.remove(bpy.data.meshes.new("WireWarp"))
