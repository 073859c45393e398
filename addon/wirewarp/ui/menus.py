# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking from the Edge menu (Ctrl+E) and the context menu of edge selection."""

import bpy


def draw_edge_menu(menu: bpy.types.Menu, _context: bpy.types.Context) -> None:
    layout = menu.layout
    layout.separator()
    layout.operator("mesh.wirewarp_mark", text="Mark Rigid Wire").kind = "RIGID"
    layout.operator("mesh.wirewarp_mark", text="Mark Elastic Wire").kind = "ELASTIC"
    layout.operator("mesh.wirewarp_mark", text="Mark Free Wire").kind = "SUPER_ELASTIC"
    layout.operator("mesh.wirewarp_clear")


def draw_context_menu(menu: bpy.types.Menu, context: bpy.types.Context) -> None:
    if context.tool_settings.mesh_select_mode[1]:
        draw_edge_menu(menu, context)
