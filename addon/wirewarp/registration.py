# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class by name, registered in order and unregistered in reverse."""

import bpy

from . import (
    auto_update,
    drop_helpers,
    keep_names,
    mesh_cache,
    operators,
    overlay,
    properties,
    report_store,
    solved_pieces,
    text_units,
    ui,
    window_run,
)

CLASSES = (*properties.CLASSES, *operators.CLASSES, *ui.CLASSES)


def register_classes() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister_classes() -> None:
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def register_ui() -> None:
    report_store.attach()
    keep_names.attach()
    drop_helpers.attach()
    mesh_cache.attach()
    overlay.attach()
    ui.tick.attach()
    ui.menus.attach()
    solved_pieces.attach()
    text_units.attach()
    window_run.attach()
    auto_update.attach()


def unregister_ui() -> None:
    auto_update.detach()
    window_run.detach()
    text_units.detach()
    solved_pieces.detach()
    ui.menus.detach()
    ui.tick.detach()
    overlay.detach()
    mesh_cache.detach()
    drop_helpers.detach()
    keep_names.detach()
    report_store.detach()
