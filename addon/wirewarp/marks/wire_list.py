# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of wires: name, kind, length. A double click renames; the buttons below act on the chosen one."""

import bpy
import numpy as np

from ..blender.units import length_text
from ..issues import ObjectError
from ..state.drawings import kept_drawing
from ..state.memory import stamp
from ..state.owners import model_of
from ..state.wires import WireSummary, editable_name, listed_wires
from ..ui.layout import SidebarPanel, draw_sentence, is_wide
from ..words import counted, wire_text

ROWS = 5  # of the list, however many wires there are: what stands below stays where it is
SHOWN_UNLISTED = 3


def shown_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """As listed_wires; of a large mesh that is being edited not anew at every redraw, for that would be felt."""
    names = [(entry.wire_id, entry.name) for entry in target.data.wirewarp_names]
    made_of = stamp(target.data), target.data.is_editmode, names
    return kept_drawing(target, "wires", made_of, lambda: listed_wires(target))


class WIREWARP_UL_wires(bpy.types.UIList):
    """Entries of the mesh's list of names."""

    def draw_item(
        self,
        context: bpy.types.Context,
        layout: bpy.types.UILayout,
        mesh: bpy.types.Mesh,
        entry: bpy.types.PropertyGroup,
        _icon: int,
        _active_mesh: bpy.types.Mesh,
        _active_name: str,
        _index: int,
    ) -> None:
        line, wire = layout.row(align=True), _wire_of(context.active_object, entry)
        if wire is None:
            line.prop(entry, "name", text="", emboss=False, icon="BLANK1")
            return
        icon = "EMPTY_SINGLE_ARROW" if mesh.wirewarp_grain == entry.wire_id else "NONE"
        columns = line.split(factor=0.5 if is_wide(context) else 0.68)
        columns.prop(entry, "name", text="", emboss=False, icon=icon)
        figures = columns.row()
        figures.alignment = "RIGHT"
        figures.label(text=_figures(context, wire) if is_wide(context) else _rough_length(context, wire))

    def filter_items(
        self, context: bpy.types.Context, mesh: bpy.types.Mesh, entries_name: str
    ) -> tuple[list[int], list[int]]:
        """Wires that are gone are not shown."""
        entries, helper = getattr(mesh, entries_name), bpy.types.UI_UL_list
        there = [self.bitflag_filter_item * (_wire_of(context.active_object, entry) is not None) for entry in entries]
        if self.filter_name:
            named = helper.filter_items_by_name(self.filter_name, self.bitflag_filter_item, entries, "name")
            there = [a & b for a, b in zip(there, named, strict=True)]
        return there, helper.sort_items_by_name(entries, "name") if self.use_filter_sort_alpha else []


def _wire_of(target: bpy.types.Object, entry: bpy.types.PropertyGroup) -> WireSummary | None:
    """The wire that has this entry; None if it is gone."""
    try:
        wires = shown_wires(target)
    except ObjectError:
        return None
    return next((wire for _, wire in wires if wire.wire_id == entry.wire_id and not wire.shares_id), None)


def _figures(context: bpy.types.Context, wire: WireSummary) -> str:
    return f"{wire_text(wire.tolerance, wire.ease)}  {_length(context, wire)}"


def _length(context: bpy.types.Context, wire: WireSummary) -> str:
    return length_text(context.scene)(_true_length(context, wire))


def _rough_length(context: bpy.types.Context, wire: WireSummary) -> str:
    """To leave the name room."""
    return length_text(context.scene).rough(_true_length(context, wire))


def _true_length(context: bpy.types.Context, wire: WireSummary) -> float:
    linear = np.array(context.active_object.matrix_world, dtype=np.float64)[:3, :3]
    return wire.length(linear)


class VIEW3D_PT_wirewarp_wires(SidebarPanel, bpy.types.Panel):
    bl_label = "Wires"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and not model_of(active)  # the report has theirs

    def draw(self, context: bpy.types.Context) -> None:
        target = context.active_object
        mesh, layout = target.data, self.layout
        try:
            wires = shown_wires(target)
        except ObjectError as error:
            draw_sentence(context, layout, str(error), "ERROR")
            return
        if not wires:
            layout.label(text="No wires yet")
            return
        layout.template_list(
            "WIREWARP_UL_wires", "", mesh, "wirewarp_names", mesh, "wirewarp_active_wire", rows=ROWS, maxrows=ROWS
        )
        if mesh.wirewarp_active_wire < len(mesh.wirewarp_names):
            chosen = _wire_of(target, mesh.wirewarp_names[mesh.wirewarp_active_wire])
            if chosen:
                _draw_buttons(layout, mesh, chosen)
        _draw_unlisted(context, layout, [(name, wire) for name, wire in wires if not editable_name(mesh, wire)])


def _draw_buttons(layout: bpy.types.UILayout, mesh: bpy.types.Mesh, wire: WireSummary) -> None:
    row = layout.row(align=True)
    row.operator("mesh.wirewarp_select_wire", text="Select", icon="RESTRICT_SELECT_OFF").edge = wire.edges[0]
    row.operator("mesh.wirewarp_change_wire", text=wire_text(wire.tolerance, wire.ease)).edge = wire.edges[0]
    grain = row.row(align=True)
    is_grain = mesh.wirewarp_grain == wire.wire_id
    grain.operator(
        "mesh.wirewarp_grain_wire", text="Grain", icon="EMPTY_SINGLE_ARROW", depress=is_grain
    ).edge = wire.edges[0]


def _draw_unlisted(
    context: bpy.types.Context, layout: bpy.types.UILayout, wires: list[tuple[str, WireSummary]]
) -> None:
    """Wires that were copied, cut in two or joined have no entry before Mark or Flatten: a click changes them."""
    column = layout.column(align=True)
    for name, wire in wires[:SHOWN_UNLISTED]:
        button = column.operator("mesh.wirewarp_change_wire", text=f"{name}  {_figures(context, wire)}")
        button.edge = wire.edges[0]
    if len(wires) > SHOWN_UNLISTED:
        column.label(text=f"and {counted(len(wires) - SHOWN_UNLISTED, 'more wire')}")


CLASSES = (
    WIREWARP_UL_wires,
    VIEW3D_PT_wirewarp_wires,
)
