# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class by name, registered in order and unregistered in reverse."""

import bpy

from . import operators, overlay, properties, ui
from .blender import cache
from .flat import reports
from .model import wire_names
from .run import auto_update, read, window_run

CLASSES = (*properties.CLASSES, *operators.CLASSES, *ui.CLASSES)
ATTACHED = (
    reports,
    wire_names,
    cache,
    overlay,
    ui.layout,
    ui.menus,
    read,
    window_run,
    auto_update,
)


def register_classes() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister_classes() -> None:
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def register_ui() -> None:
    for module in ATTACHED:
        module.attach()


def unregister_ui() -> None:
    for module in reversed(ATTACHED):
        module.detach()
