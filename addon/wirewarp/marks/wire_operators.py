# SPDX-License-Identifier: GPL-3.0-or-later
"""The buttons beside one wire."""

import math

import bpy
from bpy.props import FloatProperty, IntProperty, StringProperty

from ..blender.mesh import current_mesh, edge_vertices, read_selected_edges
from ..blender.modes import hold_whole_file, in_object_mode
from ..blender.objects import check_local
from ..blender.selection import select_elements
from ..issues import ObjectError, object_error
from ..properties import LEAST_EASE
from ..state.wires import find_wires, listed_wires
from ..ui.editing import OnModel, reporting_refusals
from .change import change_grain, change_wire, wire_at
from .mark_operators import WireKind


class WireOperator(OnModel):
    """Acts on one wire of the active model, in Object Mode. Subclasses say how."""

    bl_options = {"REGISTER", "UNDO"}
    modes = frozenset({"OBJECT", "EDIT_MESH"})

    edge: IntProperty(name="Edge", description="Any edge of the wire, by its index", min=0, options={"HIDDEN"})

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

    name: StringProperty(name="Name", description="What the wire is called; left empty, it keeps its name")
    ease: FloatProperty(
        name="Ease",
        description="How much longer than on the model to cut the wire, as a fraction. Below 0: shorter. "
        "Left out, the wire keeps its own",
        min=LEAST_EASE,
        soft_min=-0.5,
        soft_max=1.0,
        precision=4,
        step=1,
    )
    ease_percent: FloatProperty(
        name="Ease",
        description="How much longer than on the model to cut the wire, in percent. Below 0: shorter",
        subtype="PERCENTAGE",
        min=100 * LEAST_EASE,
        soft_min=-50.0,
        soft_max=100.0,
        precision=2,
        get=lambda operator: 100 * operator.ease,
        set=lambda operator, percent: setattr(operator, "ease", percent / 100),
        options={"SKIP_SAVE"},
    )

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        try:
            self._start_from(context)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return context.window_manager.invoke_props_dialog(self)

    def _start_from(self, context: bpy.types.Context) -> None:
        """The settings are those of the wire as it is."""
        wire = wire_at(context.active_object, self.edge)
        self.name = next(name for name, each in listed_wires(context.active_object) if self.edge in each.edges)
        if wire.tolerance == 0:
            self.kind = "RIGID"
        else:
            self.kind = "SUPER_ELASTIC" if math.isinf(wire.tolerance) else "ELASTIC"
        elastic = self.kind == "ELASTIC"
        self.tolerance = wire.tolerance if elastic else context.scene.wirewarp.tolerance_percent / 100
        self.ease = wire.ease

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
    """Make this wire the grain wire, which is upright in the pieces that it crosses. Press again to undo"""

    bl_idname = "mesh.wirewarp_grain_wire"
    bl_label = "Grain Wire"
    on_model = "choose the grain wire"

    def act(self, target: bpy.types.Object) -> None:
        change_grain(target, self.edge)
        target.data.update_tag()  # for Auto
        hold_whole_file()


class MESH_OT_wirewarp_select_wire(bpy.types.Operator):
    """Select this wire's edges in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_wire"
    bl_label = "Select Whole Wires"
    bl_options = {"REGISTER", "UNDO"}

    edge: IntProperty(
        name="Edge",
        description="Any edge of the wire, by its index; -1: the wires of all selected edges",
        min=-1,
        default=-1,
        options={"HIDDEN"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        return cls.__doc__ if properties.edge >= 0 else "Grow the selection to whole wires"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        target = context.active_object
        rows = wire_at(target, self.edge).edges if self.edge >= 0 else self._rows_of_selected(target)
        with current_mesh(target) as mesh:
            edges = edge_vertices(mesh)[rows]
        select_elements(context, target, edges=edges)
        return {"FINISHED"}

    def _rows_of_selected(self, target: bpy.types.Object) -> list[int]:
        with current_mesh(target) as mesh:
            selected = read_selected_edges(mesh)
        found = [wire.edges for wire in find_wires(target) if selected[wire.edges].any()]
        if not found:
            raise object_error("no_wire", "No selected edge is a wire. Select an edge of the wire first.")
        return [row for rows in found for row in rows]


CLASSES = (MESH_OT_wirewarp_change_wire, MESH_OT_wirewarp_grain_wire, MESH_OT_wirewarp_select_wire)
