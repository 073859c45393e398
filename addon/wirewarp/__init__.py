# SPDX-License-Identifier: GPL-3.0-or-later
"""WireWarp: flat pieces with exact seam and wire lengths. addon/README.md is the map of its packages."""

from collections.abc import Callable

import bpy

from . import core, without_library

bl_info = {
    "name": "WireWarp",
    "description": "Flat patterns with exact seam and wire lengths",
    "author": "WireWarp contributors",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > WireWarp",
    "category": "Mesh",
}
# The version is read now, because Blender deletes bl_info from an extension after the import.
VERSION = ".".join(map(str, bl_info["version"]))


_unregister: Callable[[], None] | None = None


def register() -> None:
    """Load the library, then register the add-on. Without the library, register only a panel with the error and the
    operator Flatten, which shows the error, too."""
    global _unregister
    if hasattr(bpy.types, "OBJECT_OT_wirewarp_flatten"):
        raise RuntimeError("WireWarp is already enabled. Remove the extension or the add-on.")
    try:
        core.load(VERSION)
    except core.LibraryError as error:
        _unregister = without_library.register(str(error))
        return
    from . import registration  # imported only now: it needs numpy, and load() reports a missing numpy

    _unregister = registration.register()


def unregister() -> None:
    global _unregister
    take_back, _unregister = _unregister, None
    if take_back:
        take_back()
