# SPDX-License-Identifier: GPL-3.0-or-later
"""WireWarp: flat pieces with exact seam and wire lengths. addon/README.md is the map of the packages in here."""

from . import core, properties, registration

bl_info = {
    "name": "WireWarp",
    "description": "Flat patterns with exact seam and wire lengths",
    "author": "WireWarp contributors",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > WireWarp",
    "category": "Mesh",
}
# Blender deletes bl_info from extensions once they are imported.
VERSION = ".".join(map(str, bl_info["version"]))


def register() -> None:
    core.load(VERSION)
    registration.register_classes()
    properties.attach()
    registration.register_ui()


def unregister() -> None:
    registration.unregister_ui()
    properties.detach()
    registration.unregister_classes()
