# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel that lists wires with their kinds and lengths, and the operators for the chosen wire."""

import math
from collections.abc import Sequence

import bpy
import numpy as np
from bpy.props import IntProperty, StringProperty

from ..blender.mesh import current_mesh, edge_vertices, read_selected_edges
from ..blender.objects import check_local, length_text
from ..blender.selection import (
    WORKING_MODES,
    hold_whole_file,
    in_object_mode,
    select_edges_in_edit_mode,
    select_elements,
)
from ..core import Elements, counted, wire_text
from ..issues import ObjectError, object_error
from ..properties import LEAST_EASE
from ..state.drawings import kept_drawing
from ..state.identities import WireSummary, editable_name, find_wires, listed_wires
from ..state.memory import stamp
from ..state.owners import model_of
from ..state.settings import in_percent, number
from ..ui.editing import OnMesh, OnModel, reporting_refusals
from ..ui.layout import SidebarPanel, draw_sentence, is_wide
from .ease import change_grain, change_wire, wire_at
from .mark_operators import WireKind


class WireOperator(OnModel):
    """Mixin of operators for one wire of the active model. The operators define act(), which is called in Object
    Mode."""

    bl_options = {"REGISTER", "UNDO"}
    modes = WORKING_MODES

    edge: IntProperty(name="Edge", description="Index of any edge of the wire", min=0, options={"HIDDEN"})

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        check_local(target, target.data)
        with in_object_mode(context):
            self.act(target)
        return {"FINISHED"}


class MESH_OT_wirewarp_change_wire(WireKind, WireOperator, bpy.types.Operator):
    """Change the name, the kind, the tolerance or the ease of this wire"""

    bl_idname = "mesh.wirewarp_change_wire"
    bl_label = "Change Wire"
    on_model = "change the wire"

    name: StringProperty(name="Name", description="Name of the wire. If it is empty, the wire keeps its present name")
    ease: number(
        "Ease",
        "How much longer than on the model to cut the wire, as a fraction. Below 0: shorter. "
        "If it is not set, the wire keeps its ease",
        (LEAST_EASE, 0.0, 1.0),
        soft_min=-0.5,
        precision=4,
        step=1,
    )
    ease_percent: number(
        "Ease",
        "How much longer than on the model to cut the wire, in percent. Below 0: shorter",
        (100 * LEAST_EASE, 0.0, 100.0),
        soft_min=-50.0,
        **in_percent("ease"),
    )

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        return self._ask(context)

    @reporting_refusals
    def _ask(self, context: bpy.types.Context) -> set[str]:
        wire = wire_at(context.active_object, self.edge)
        self.name = next(name for name, each in listed_wires(context.active_object) if self.edge in each.edges)
        if wire.tolerance == 0:
            self.kind = "RIGID"
        else:
            self.kind = "SUPER_ELASTIC" if math.isinf(wire.tolerance) else "ELASTIC"
        elastic = self.kind == "ELASTIC"
        self.tolerance = wire.tolerance if elastic else context.scene.wirewarp.tolerance_percent / 100
        self.ease = wire.ease
        return context.window_manager.invoke_props_dialog(self)

    def act(self, target: bpy.types.Object) -> None:
        change_wire(target, self.edge, self.name, self.chosen_tolerance(), self._ease())

    def _ease(self) -> float | None:
        return self.ease if self.properties.is_property_set("ease") else None

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        self.layout.prop(self, "name")
        self.draw_kind(self.layout)
        self.layout.prop(self, "ease_percent")


class MESH_OT_wirewarp_grain_wire(WireOperator, bpy.types.Operator):
    """Make this wire the grain wire, which is upright in the pieces that it crosses. Press again for no grain wire"""

    bl_idname = "mesh.wirewarp_grain_wire"
    bl_label = "Grain Wire"
    on_model = "choose the grain wire"

    def act(self, target: bpy.types.Object) -> None:
        change_grain(target, self.edge)
        target.data.update_tag()  # so that Auto notices the change
        hold_whole_file()


class MESH_OT_wirewarp_select_wire(OnMesh, bpy.types.Operator):
    """Select this wire's edges in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_wire"
    bl_label = "Select Whole Wires"
    bl_options = {"REGISTER", "UNDO"}
    modes = WORKING_MODES

    edge: IntProperty(
        name="Edge",
        description="Index of any edge of the wire, or -1 for the wires of all selected edges",
        min=-1,
        default=-1,
        options={"HIDDEN"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return cls.__doc__ if properties.edge >= 0 else "Extend the selection to whole wires"

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        if self.edge >= 0:
            select_elements(context, target, Elements(edges=_ends(target, wire_at(target, self.edge).edges)))
        elif context.mode == "EDIT_MESH":
            targets = list(context.objects_in_mode_unique_data)
            wires = _selected_wires(targets)
            bpy.ops.mesh.select_mode(type="EDGE")
            for each, edges in zip(targets, wires, strict=True):
                select_edges_in_edit_mode(each.data, edges)
        else:
            select_elements(context, target, Elements(edges=_selected_wires([target])[0]))
        return {"FINISHED"}


def _selected_wires(targets: Sequence[bpy.types.Object]) -> list[list[tuple[int, int]]]:
    """Return, for each object, the edges of the wires that have a selected edge, as vertex pairs. Raises ObjectError if
    no wire has a selected edge."""
    found = []
    for target in targets:
        with current_mesh(target) as mesh:
            selected = read_selected_edges(mesh)
        rows = [row for wire in find_wires(target) if selected[wire.edges].any() for row in wire.edges]
        found.append(_ends(target, rows))
    if not any(found):
        raise object_error("no_wire", "No selected edge is a wire. Select an edge of the wire first.")
    return found


def _ends(target: bpy.types.Object, rows: list[int]) -> list[tuple[int, int]]:
    with current_mesh(target) as mesh:
        return [(a, b) for a, b in edge_vertices(mesh)[rows].tolist()]


ROWS = 5  # fixed number of rows, so that the buttons below do not move
SHOWN_UNLISTED = 3  # wires shown below the list; with a line for the other wires, fewer than ROWS


def shown_wires(target: bpy.types.Object) -> list[tuple[str, WireSummary]]:
    """Return the result of listed_wires, kept until the mesh changes, because reading a large mesh is slow."""
    names = [(entry.wire_id, entry.name) for entry in target.data.wirewarp_names]
    made_of = stamp(target.data), target.data.is_editmode, names
    return kept_drawing(target, "wires", made_of, lambda: listed_wires(target))


class WIREWARP_UL_wires(bpy.types.UIList):
    """List of wires, with one row for each entry of the mesh's list of names"""

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
        columns = line.split(factor=0.5) if is_wide(context) else line
        columns.prop(entry, "name", text="", emboss=False, icon=icon)
        if not is_wide(context):  # the row has no room for lengths; the length of the chosen wire is below the list
            return
        figures = columns.row()
        figures.alignment = "RIGHT"
        figures.label(text=_figures(context, wire))

    def filter_items(
        self, context: bpy.types.Context, mesh: bpy.types.Mesh, entries_name: str
    ) -> tuple[list[int], list[int]]:
        """Hide the entries of removed wires."""
        entries, helper = getattr(mesh, entries_name), bpy.types.UI_UL_list
        there = [self.bitflag_filter_item * (_wire_of(context.active_object, entry) is not None) for entry in entries]
        if self.filter_name:
            named = helper.filter_items_by_name(self.filter_name, self.bitflag_filter_item, entries, "name")
            there = [a & b for a, b in zip(there, named, strict=True)]
        return there, helper.sort_items_by_name(entries, "name") if self.use_filter_sort_alpha else []


def _wire_of(target: bpy.types.Object, entry: bpy.types.PropertyGroup) -> WireSummary | None:
    """Return the wire of this entry; None if the wire was removed, or if the marks cannot be read."""
    try:
        wires = shown_wires(target)
    except ObjectError:
        return None
    return next((wire for _, wire in wires if wire.wire_id == entry.wire_id and not wire.shares_id), None)


def _figures(context: bpy.types.Context, wire: WireSummary) -> str:
    length = wire.length(np.array(context.active_object.matrix_world, dtype=np.float64)[:3, :3])
    return f"{wire_text(wire.tolerance, wire.ease)}  {length_text(context.scene)(length)}"


class VIEW3D_PT_wirewarp_wires(OnMesh, SidebarPanel, bpy.types.Panel):
    bl_label = "Wires"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return super().poll(context) and not model_of(context.active_object)  # the report lists the wires of pieces

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
                if not is_wide(context):
                    layout.label(text=_figures(context, chosen))
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
    """Draw the wires without an entry in the list, for example after meshes were copied, cut or joined. The dialog of a
    wire's button adds the entry."""
    column = layout.column(align=True)
    for name, wire in wires[:SHOWN_UNLISTED]:
        button = column.operator("mesh.wirewarp_change_wire", text=f"{name}  {_figures(context, wire)}")
        button.edge = wire.edges[0]
    if len(wires) > SHOWN_UNLISTED:
        column.label(text=f"and {counted(len(wires) - SHOWN_UNLISTED, 'more wire')}")
