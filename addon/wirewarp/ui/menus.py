# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds our commands to Blender's menus, each under "WireWarp", because the search (F3) also uses the names of menus."""

from collections.abc import Callable

import bpy

from ..core import pattern
from ..state.owners import model_of


class VIEW3D_MT_wirewarp(bpy.types.Menu):
    """Flatten models, check their meshes, and export flat pieces"""

    bl_label = "WireWarp"

    def draw(self, _context: bpy.types.Context) -> None:
        layout = _asking_layout(self)
        layout.operator("object.wirewarp_flatten")
        layout.operator("object.wirewarp_check")
        layout.operator("view3d.wirewarp_frame")
        layout.operator("object.wirewarp_copy_report", text="Copy Report as CSV")
        layout.operator("object.wirewarp_export")
        layout.operator("object.wirewarp_sewing")


class VIEW3D_MT_wirewarp_edges(bpy.types.Menu):
    """Mark the selected edges, or the selected side on flat pieces"""

    bl_label = "WireWarp"

    def draw(self, context: bpy.types.Context) -> None:
        layout = _asking_layout(self)
        if model_of(context.active_object):
            layout.operator("mesh.wirewarp_ease", text="Mark Ease").sides = "ONE"
            _draw_marks_of_sides(layout)
            return
        layout.operator("mesh.wirewarp_mark", text="Mark Rigid Wire").kind = "RIGID"
        layout.operator("mesh.wirewarp_mark", text="Mark Elastic Wire").kind = "ELASTIC"
        layout.operator("mesh.wirewarp_mark", text="Mark Free Wire").kind = "SUPER_ELASTIC"
        layout.operator("mesh.wirewarp_clear")
        layout.operator("mesh.wirewarp_ease", text="Mark Ease").sides = "ALL"
        layout.operator("mesh.wirewarp_ease", text="Mark Ease of One Side").sides = "ONE"
        _draw_marks_of_sides(layout)
        layout.operator("mesh.wirewarp_select_wire").edge = -1
        layout.operator("mesh.wirewarp_seams_from_uv_islands")
        layout.operator("mesh.wirewarp_smooth_seam")


def _draw_marks_of_sides(layout: bpy.types.UILayout) -> None:
    layout.operator("mesh.wirewarp_ease", text="Clear Ease").sides = "NONE"
    layout.operator("mesh.wirewarp_allowance", text="Mark Allowance").kind = "WIDTH"
    layout.operator("mesh.wirewarp_allowance", text="Mark Hem").kind = "HEM"
    layout.operator("mesh.wirewarp_allowance", text="Mark Fold").kind = "FOLD"
    layout.operator("mesh.wirewarp_allowance", text="Default Allowance").kind = "DEFAULT"


def draw_edge_menu(menu: bpy.types.Menu, _context: bpy.types.Context) -> None:
    """Add our menu to the menu Edge (Ctrl+E)."""
    menu.layout.separator()
    menu.layout.menu(VIEW3D_MT_wirewarp_edges.__name__)


def draw_context_menu(menu: bpy.types.Menu, context: bpy.types.Context) -> None:
    """Add our menu to the context menu (right mouse button), if edges can be selected."""
    if context.tool_settings.mesh_select_mode[1]:
        draw_edge_menu(menu, context)


def draw_pieces_menu(menu: bpy.types.Menu, _context: bpy.types.Context) -> None:
    """Add our menu to the menu Object, and in Edit Mode to the menu UV."""
    menu.layout.separator()
    menu.layout.menu(VIEW3D_MT_wirewarp.__name__)


def draw_export_entry(menu: bpy.types.Menu, _context: bpy.types.Context) -> None:
    _asking_layout(menu).operator("object.wirewarp_export", text=f"WireWarp Pattern ({', '.join(pattern.FORMATS)})")


def _asking_layout(menu: bpy.types.Menu) -> bpy.types.UILayout:
    """Return the menu's layout, after making it invoke operators. Otherwise, operators may run without their dialog."""
    menu.layout.operator_context = "INVOKE_DEFAULT"
    return menu.layout


ADDED = {
    "VIEW3D_MT_edit_mesh_edges": draw_edge_menu,
    "VIEW3D_MT_edit_mesh_context_menu": draw_context_menu,
    "VIEW3D_MT_object": draw_pieces_menu,
    "VIEW3D_MT_uv_map": draw_pieces_menu,
    "TOPBAR_MT_file_export": draw_export_entry,
}


def attach() -> Callable[[], None]:
    for name, draw in ADDED.items():
        getattr(bpy.types, name).append(draw)
    return _detach


def _detach() -> None:
    for name, draw in ADDED.items():
        getattr(bpy.types, name).remove(draw)
