# SPDX-License-Identifier: GPL-3.0-or-later
"""Check and Repair: what is wrong with the mesh of a model, by kind; each kind is shown, and repaired on request."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..blender.faults import FAULTS, Elements, Fault, find_faults, repair_faults
from ..blender.modes import WORKING_MODES, in_object_mode
from ..blender.objects import check_local
from ..blender.selection import select_elements
from ..state.owners import check_not_edited, model_or_self
from ..ui import window_run
from ..ui.editing import reporting_refusals

KINDS = [(fault.kind, fault.many.capitalize(), f"All {fault.many} of the model") for fault in FAULTS]
NOT_UNASKED = "INTERIOR"  # walls inside may be wanted, and some look like faces of the shell
WIDTH = 340  # of the dialog, in Blender's own pixels


def _chosen_by_default(fault: Fault) -> object:
    return BoolProperty(
        name=f"{fault.verb} {fault.many}".capitalize(),
        description=f"Whether to repair the {fault.many} of the model",
        default=fault.kind != NOT_UNASKED,
    )


class Repairs:
    """A switch for each kind of fault, by its name in small letters. Mixed into operators."""

    __annotations__ = {fault.kind.lower(): _chosen_by_default(fault) for fault in FAULTS}  # noqa: RUF012


class OnFaultyModel:
    """Mixed into operators."""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        is_mesh = active is not None and active.type == "MESH"
        return is_mesh and context.mode in WORKING_MODES and not window_run.is_running()


class OBJECT_OT_wirewarp_check(OnFaultyModel, Repairs, bpy.types.Operator):
    """List what is wrong with the mesh, and repair the kinds that you choose"""

    bl_idname = "object.wirewarp_check"
    bl_label = "Check and Repair"
    bl_options = {"REGISTER", "UNDO"}

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        source = model_or_self(context.active_object)
        with in_object_mode(context):
            self._counts = _counts(source)
        if not self._counts:
            self.report({"INFO"}, f'No faults found in the mesh of "{source.name}"')
            return {"CANCELLED"}
        return context.window_manager.invoke_props_dialog(self, width=WIDTH)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        source = model_or_self(context.active_object)
        check_local(source, source.data)
        if context.mode == "EDIT_MESH" and source.mode != "EDIT":
            bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would bring back the edited meshes only
        with in_object_mode(context):
            check_not_edited(source)
            self._counts = _counts(source)
            kinds = [fault.kind for fault in FAULTS if getattr(self, fault.kind.lower())]
            repaired = repair_faults(source.data, kinds)
        done = [f"{fault.text(repaired[fault.kind])} {fault.done}" for fault in FAULTS if fault.kind in repaired]
        if done:
            self.report({"INFO"}, f"{'; '.join(done)}. Flatten again.")
        else:
            self.report({"INFO"}, f'Nothing was repaired in the mesh of "{source.name}"')
        # With faults left, the kinds can be chosen anew in Adjust Last Operation.
        return {"FINISHED"} if self._counts else {"CANCELLED"}

    def draw(self, _context: bpy.types.Context) -> None:
        """What was found, in the dialog and in Adjust Last Operation."""
        column = self.layout.column(align=True)
        for fault in FAULTS:
            if fault.kind not in self._counts:
                continue
            row, text = column.row(align=True), fault.text(self._counts[fault.kind])
            row.prop(self, fault.kind.lower(), text=f"{fault.verb}: {text}")
            row.operator("object.wirewarp_show_fault", text="", icon="RESTRICT_SELECT_OFF").kind = fault.kind


class OBJECT_OT_wirewarp_show_fault(OnFaultyModel, bpy.types.Operator):
    """Select and show these elements in Edit Mode"""

    bl_idname = "object.wirewarp_show_fault"
    bl_label = "Show Fault"
    bl_options = {"INTERNAL", "UNDO"}

    kind: EnumProperty(name="Kind", description="Which fault to show", items=KINDS)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        source = model_or_self(context.active_object)
        with in_object_mode(context):
            found = find_faults(source.data).get(self.kind)
        if found is None:
            self.report({"INFO"}, "There are none any more")
            return {"CANCELLED"}
        select_elements(context, source, found.vertices, found.edges, found.faces)
        return {"FINISHED"}


def _counts(source: bpy.types.Object) -> dict[str, int]:
    return {kind: _count(found) for kind, found in find_faults(source.data).items()}


def _count(found: Elements) -> int:
    return len(found.vertices) + len(found.edges) + len(found.faces)


CLASSES = (OBJECT_OT_wirewarp_check, OBJECT_OT_wirewarp_show_fault)
