# SPDX-License-Identifier: GPL-3.0-or-later
"""Removing an object of ours."""

import bpy


def remove_object(target: bpy.types.Object) -> None:
    """With its data, unless other objects, which may be the user's copies, use that too."""
    data = target.data
    bpy.data.objects.remove(target)
    if data.users == 0:
        bpy.data.batch_remove([data])
