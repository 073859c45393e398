# SPDX-License-Identifier: GPL-3.0-or-later
"""Every class by name, registered in order and unregistered in reverse."""

import bpy

from . import mesh_cache, operators, overlay, properties, report_store, ui

CLASSES = (*properties.CLASSES, *operators.CLASSES, *ui.CLASSES)


def register_classes() -> None:
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister_classes() -> None:
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def register_ui() -> None:
    report_store.attach()
    mesh_cache.attach()
    overlay.attach()
    ui.tick.attach()
    bpy.types.VIEW3D_MT_edit_mesh_edges.append(ui.draw_edge_menu)
    bpy.types.VIEW3D_MT_edit_mesh_context_menu.append(ui.draw_context_menu)


def unregister_ui() -> None:
    bpy.types.VIEW3D_MT_edit_mesh_context_menu.remove(ui.draw_context_menu)
    bpy.types.VIEW3D_MT_edit_mesh_edges.remove(ui.draw_edge_menu)
    ui.tick.detach()
    overlay.detach()
    mesh_cache.detach()
    report_store.detach()
