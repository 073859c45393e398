# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that apply suggestions and flatten again, and the operator Check and Repair."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ..blender.faults import FAULTS, Fault, find_faults, repair_faults
from ..blender.objects import check_local
from ..blender.selection import WORKING_MODES, in_object_mode, select_elements
from ..core import percent_text
from ..flatten.operators import FlattenSteps
from ..flatten.read import active_target, check_sources
from ..issues import object_error
from ..marks.mark import seams_from_uv
from ..properties import take_settings
from ..state.memory import read_anew
from ..state.owners import check_not_edited, model_or_self
from ..state.read_model import apply_modifiers, outline_change, subdivide
from ..state.reports import last_report
from ..state.suggestions import current_suggestions
from ..suggest.smooth import take_away, take_lines
from ..ui import window_run
from ..ui.editing import OnMesh, reporting_refusals
from ..ui.settings import draw_settings
from .operators import PROPOSALS, check_flattened, take_proposals

KINDS = [(fault.kind, fault.many.capitalize(), f"All {fault.many} of the model") for fault in FAULTS]
# This kind is not selected by default, because interior walls may be intended, and because some faces of the shell look
# like interior faces.
NOT_UNASKED = "INTERIOR"
WIDTH = 340  # width of the dialog, in pixels at interface scale 1; its longest text is about 265 wide, beside two icons


def _chosen_by_default(fault: Fault) -> object:
    return BoolProperty(
        name=f"{fault.verb} {fault.many}".capitalize(),
        description=f"Repair the {fault.many} of the model",
        default=fault.kind != NOT_UNASKED,
    )


class Repairs:
    """Mixin of operators with a switch for each kind of fault. The switch has the name of the kind in lower case."""

    __annotations__ = {fault.kind.lower(): _chosen_by_default(fault) for fault in FAULTS}  # noqa: RUF012


class BetweenRuns(OnMesh):
    modes = WORKING_MODES

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return super().poll(context) and not window_run.is_running()


class OBJECT_OT_wirewarp_check(BetweenRuns, Repairs, bpy.types.Operator):
    """List the faults of the mesh, and repair the kinds that you choose"""

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
            bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would restore only the edited meshes
        with in_object_mode(context):
            check_not_edited(source)
            self._counts = _counts(source)
            kinds = [fault.kind for fault in FAULTS if getattr(self, fault.kind.lower())]
            repaired = repair_faults(source.data, kinds)
        done = [f"{fault.text(repaired[fault.kind])} {fault.done}" for fault in FAULTS if fault.kind in repaired]
        if done:
            self.report({"INFO"}, f"{', '.join(done)}. Flatten again.")
        else:
            self.report({"INFO"}, f'Nothing was repaired in the mesh of "{source.name}"')
        # If the mesh had faults, finish even without a repair, so that Adjust Last Operation offers the kinds again.
        return {"FINISHED"} if self._counts else {"CANCELLED"}

    def draw(self, _context: bpy.types.Context) -> None:
        """Draw the faults, in the dialog and in Adjust Last Operation."""
        column = self.layout.column(align=True)
        for fault in FAULTS:
            if fault.kind not in self._counts:
                continue
            row, text = column.row(align=True), fault.text(self._counts[fault.kind])
            row.prop(self, fault.kind.lower(), text=f"{fault.verb}: {text}")
            row.operator("object.wirewarp_show_fault", text="", icon="RESTRICT_SELECT_OFF").kind = fault.kind


class OBJECT_OT_wirewarp_show_fault(BetweenRuns, bpy.types.Operator):
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
            self.report({"INFO"}, "This fault no longer exists")
            return {"CANCELLED"}
        select_elements(context, source, found)
        return {"FINISHED"}


def _counts(source: bpy.types.Object) -> dict[str, int]:
    found = find_faults(source.data).items()
    return {kind: len(each.vertices) + len(each.edges) + len(each.faces) for kind, each in found}


WORTH_WORDS = 0.001  # smallest reported change of the outlines' length: a millimeter per meter
SUGGEST_AGAIN = "Suggest Darts, Suggest Seams or Simplify Seams"
NOTHING = {  # sentences for fixes that changed nothing, by kind of fix
    "SEAMS": "Already marked. Flatten again.",
    "SUGGESTION": "Already marked. Flatten again.",
    "UV_SEAMS": "Already marked. Flatten again.",
    "TOLERANCES": "These wires already have the suggested tolerances, or were removed. Flatten again.",
    "DISSOLVE": 'Nothing to dissolve: "{}" has no zero-area faces.',
    "MERGE": 'Nothing to merge: no vertices of "{}" overlap.',
    "NORMALS": 'No face of "{}" can be flipped so that more normals agree. Mark a seam between opposite normals.',
}
CLEAN_UP = ("DISSOLVE", "MERGE", "NORMALS")  # kinds in blender.faults


class OBJECT_OT_wirewarp_mend(BetweenRuns, FlattenSteps, bpy.types.Operator):
    """Fix the model and flatten it again"""

    bl_idname = "object.wirewarp_mend"
    bl_label = "Fix and Flatten"
    bl_options = {"REGISTER", "UNDO"}

    what: EnumProperty(
        name="What",
        description="What to do before flattening again",
        items=[
            *PROPOSALS,
            ("SUGGESTION", "Suggestion", "Mark the chosen suggestion as seams, or clear the suggested seams"),
            ("DISSOLVE", "Dissolve", "Dissolve faces without area on the model"),
            ("MERGE", "Merge", "Merge overlapping vertices of the model"),
            ("NORMALS", "Normals", "Flip faces of the model so that all point to the same side"),
            ("APPLY", "Apply Modifiers", "Apply the modifiers to the model"),
            ("UV_SEAMS", "Seams of the UV Map", "Mark the borders of the islands of the model's own UV map as seams"),
            ("FABRIC", "Fabric", "Choose this fabric"),
            (
                "SUBDIVIDE",
                "Subdivide",
                "Make the model smoother and a little smaller with a Subdivision Surface modifier, or with one more "
                "level of it, and turn on Modifiers",
            ),
            ("MODIFIERS", "Modifiers", "Use the mesh with its modifiers and shape keys from now on"),
        ],
        options={"HIDDEN"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        what = properties.rna_type.properties["what"].enum_items[properties.what]
        return f"{what.description}, and flatten again"

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        return self.execute(context) if bpy.app.background else self._begin(context)

    @reporting_refusals
    def _begin(self, context: bpy.types.Context) -> set[str]:
        return self.begin_run(context, [self._fixed(context)])

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        """Fix and flatten without a modal run, for scripts and Adjust Last Operation."""
        self.flatten_now(context, [self._fixed(context)])
        return {"FINISHED"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """Follow the run, and end with FINISHED even if it fails, so that the fix stays and the user can undo it."""
        result = super().modal(context, event)
        return {"FINISHED"} if result == {"CANCELLED"} else result

    def _fixed(self, context: bpy.types.Context) -> bpy.types.Object:
        """Fix the active model and return it. Raises ObjectError, with nothing changed, if it cannot be fixed."""
        check_sources(context, active_target(context))
        source, settings = model_or_self(context.active_object), context.scene.wirewarp
        if self.what == "MODIFIERS":
            self.use_modifiers = settings.use_modifiers = True
        elif self.what == "SUBDIVIDE":
            check_local(source, source)
            report = last_report(source)
            subdivide(source, report is not None and report.with_modifiers)
            self.use_modifiers = settings.use_modifiers = True
            with in_object_mode(context):
                context.view_layer.update()
                change = outline_change(source, context.evaluated_depsgraph_get())
            if abs(change) >= WORTH_WORDS:
                longer = "longer" if change > 0 else "shorter"
                self.report({"WARNING"}, f"Subdivision makes the outlines {percent_text(abs(change))} {longer}.")
        elif self.what == "FABRIC":  # the maximum stretch is reset, so that the new fabric uses its own
            settings.cloth = self.cloth
            self.gives_across = self.gives_along = settings.gives_across = settings.gives_along = 0.0
        else:
            if context.mode == "EDIT_MESH" and source.mode != "EDIT":
                bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would restore only the edited meshes
            with in_object_mode(context):
                if self._change(source) == 0:
                    raise object_error("nothing", NOTHING[self.what].format(source.name))
        return source

    def _change(self, source: bpy.types.Object) -> int:
        """Apply the fix, and return the number of changed elements. Raises ObjectError, with nothing changed, if the
        fix cannot be applied."""
        if self.what in {"SEAMS", "TOLERANCES"}:
            return take_proposals(source, check_flattened(source, last_report(source)), self.what)
        check_local(source, source.data)
        check_not_edited(source)
        if self.what in CLEAN_UP:
            return sum(repair_faults(source.data, [self.what]).values())
        if self.what == "UV_SEAMS":
            return seams_from_uv([source])[0]
        if self.what == "APPLY":
            apply_modifiers(source)
            self.use_modifiers = bpy.context.scene.wirewarp.use_modifiers = False
            return 1
        found = current_suggestions(source, read_anew)
        if found is None:
            sentence = f'There are no suggestions for the present shape of "{source.name}". Press {SUGGEST_AGAIN}.'
            raise object_error("no_suggestion", sentence)
        cut = found.cuts[found.chosen]
        if cut.cleared:
            changed = take_away(source, cut.cleared, found.with_modifiers)
        else:
            changed = take_lines(source, cut.paths, found.with_modifiers)
        if found.with_modifiers:
            self.use_modifiers = bpy.context.scene.wirewarp.use_modifiers = False
        return changed + found.with_modifiers

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)
