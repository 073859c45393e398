# SPDX-License-Identifier: GPL-3.0-or-later
"""Switches of the overlay in the sidebars of 3D views and UV editors."""

import bpy

from ..state.owners import model_or_self
from ..state.reports import last_report
from ..ui.layout import SidebarPanel


class VIEW3D_PT_wirewarp_overlay(SidebarPanel, bpy.types.Panel):
    bl_label = "Overlay"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        layout, settings = self.layout, context.scene.wirewarp
        layout.active = context.space_data.overlay.show_overlays
        _draw_lines(layout, settings)
        layout.label(text="Map")
        layout.prop(settings, "shown_map", text="")
        _draw_select_issues(layout, context)


class IMAGE_PT_wirewarp_overlay(bpy.types.Panel):
    bl_label = "Overlay"
    bl_space_type = "IMAGE_EDITOR"
    bl_region_type = "UI"
    bl_category = "WireWarp"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.space_data.mode == "UV"

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.active = context.space_data.overlay.show_overlays
        _draw_lines(self.layout, context.scene.wirewarp)
        _draw_select_issues(self.layout, context)


def _draw_lines(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    layout.prop(settings, "show_lines")
    row = layout.row()
    row.active = settings.show_lines
    row.prop(settings, "show_names")


def _draw_select_issues(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    active = context.active_object
    report = last_report(model_or_self(active)) if active and active.type == "MESH" else None
    if report and any(issue.has_place for issue in report.issues):
        layout.operator("mesh.wirewarp_select_issues", icon="RESTRICT_SELECT_OFF")
