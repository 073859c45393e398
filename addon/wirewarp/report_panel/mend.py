# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixing what a report complains about: suggested seams and tolerances, cuts, fabric, modifiers, normals."""

import bpy
from bpy.props import EnumProperty

from ..blender.faults import repair_faults
from ..blender.modes import WORKING_MODES, in_object_mode
from ..blender.objects import check_local
from ..core import percent_text
from ..flatten.steps import FlattenSteps
from ..flatten.targets import active_target, nothing_to_flatten
from ..issues import ObjectError, object_error
from ..marks.change import mark_seams
from ..marks.uv_seams import seams_from_uv
from ..properties import take_settings
from ..state.memory import read_anew
from ..state.modifiers import apply_modifiers, outline_change, subdivide
from ..state.owners import check_not_edited, model_or_self
from ..state.reports import last_report
from ..state.suggestions import chosen_cut
from ..suggest.cut_lines import cut_across_faces
from ..suggest.smooth import cut_smooth_lines
from ..ui import window_run
from ..ui.settings import draw_settings
from .operators import PROPOSALS, take_proposals

WORTH_WORDS = 0.001  # of the length of outlines: a millimeter on a meter
NOTHING = {  # by kind
    "SEAMS": "Already marked. Flatten again.",
    "SUGGESTION": "Already marked. Flatten again.",
    "UV_SEAMS": "Already marked. Flatten again.",
    "TOLERANCES": "These wires are already that loose, or were removed. Flatten again.",
    "DISSOLVE": 'Nothing to dissolve: "{}" has no zero-area faces.',
    "MERGE": 'Nothing to merge: no vertices of "{}" overlap.',
    "NORMALS": '"{}" cannot be oriented consistently. Mark a seam where the normals flip.',
}
CLEAN_UP = ("DISSOLVE", "MERGE", "NORMALS")  # of blender.faults


class OBJECT_OT_wirewarp_mend(FlattenSteps, bpy.types.Operator):
    """Fix the model and flatten it again"""

    bl_idname = "object.wirewarp_mend"
    bl_label = "Fix and Flatten"
    bl_options = {"REGISTER", "UNDO"}

    what: EnumProperty(
        name="What",
        description="What to do before flattening again",
        items=[
            *PROPOSALS,
            ("SUGGESTION", "Suggestion", "Mark the cut that is chosen in the list of suggestions as seam"),
            ("SMOOTH", "Smooth Suggestion", "Cut the chosen suggestion into the faces as a smooth line, as seam"),
            ("DISSOLVE", "Dissolve", "Dissolve faces without area on the model"),
            ("MERGE", "Merge", "Merge overlapping vertices of the model"),
            ("NORMALS", "Normals", "Turn faces of the model so that all look to one side"),
            ("APPLY", "Apply Modifiers", "Make what modifiers show the model itself, with edges that can be marked"),
            ("UV_SEAMS", "Seams of the UV Map", "Mark the borders of the islands of the model's own UV map as seams"),
            ("FABRIC", "Fabric", "Choose this fabric"),
            (
                "SUBDIVIDE",
                "Subdivide",
                "Add a Subdivision Surface modifier, or one more level, and use modifiers. It rounds the model, "
                "so that it becomes a little smaller",
            ),
            ("MODIFIERS", "Modifiers", "Use the mesh with its modifiers and shape keys from now on"),
        ],
        options={"HIDDEN"},
    )

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        what = properties.rna_type.properties["what"].enum_items[properties.what]
        return f"{what.description}, and flatten again"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        is_mesh = active is not None and active.type == "MESH"
        return is_mesh and context.mode in WORKING_MODES and not window_run.is_running()

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        take_settings(self, context.scene.wirewarp)
        if bpy.app.background:
            return self.execute(context)
        return self.begin_run(context, [self._model(context)]) if self._mend(context) else {"CANCELLED"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        """In a script and for Adjust Last Operation."""
        if not self._mend(context):
            return {"CANCELLED"}
        self.flatten_now(context, [self._model(context)])
        return {"FINISHED"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """What was fixed stays, and can be undone, whatever becomes of the run."""
        result = super().modal(context, event)
        return {"FINISHED"} if result == {"CANCELLED"} else result

    def _model(self, context: bpy.types.Context) -> bpy.types.Object:
        return model_or_self(context.active_object)

    def _mend(self, context: bpy.types.Context) -> bool:
        """Whether it was; says why not."""
        refusal = nothing_to_flatten(context, active_target(context))
        if refusal:
            self.report({"ERROR"}, refusal)
            return False
        source = self._model(context)
        try:
            if self.what == "MODIFIERS":
                self.use_modifiers = context.scene.wirewarp.use_modifiers = True
                return True
            if self.what == "SUBDIVIDE":
                check_local(source, source)
                report = last_report(source)
                subdivide(source, report is not None and report.with_modifiers)
                self.use_modifiers = context.scene.wirewarp.use_modifiers = True
                with in_object_mode(context):
                    context.view_layer.update()
                    change = outline_change(source, context.evaluated_depsgraph_get())
                if abs(change) >= WORTH_WORDS:
                    longer = "longer" if change > 0 else "shorter"
                    self.report({"WARNING"}, f"Subdivision makes the outlines {percent_text(abs(change))} {longer}.")
                return True
            if self.what == "FABRIC":  # its own maximum stretch, not that of another fabric
                settings = context.scene.wirewarp
                settings.cloth = self.cloth
                self.gives_across = self.gives_along = settings.gives_across = settings.gives_along = 0.0
                return True
            if context.mode == "EDIT_MESH" and source.mode != "EDIT":
                bpy.ops.object.mode_set(mode="OBJECT")  # in Edit Mode, undo would bring back the edited meshes only
            with in_object_mode(context):
                count = self._change(source)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return False
        if count == 0:
            self.report({"ERROR"}, NOTHING[self.what].format(source.name))
        return count > 0

    def _change(self, source: bpy.types.Object) -> int:
        """Returns how many elements changed. Raises ObjectError, with nothing changed."""
        if self.what in CLEAN_UP:
            check_local(source, source.data)
            check_not_edited(source)
            return sum(repair_faults(source.data, [self.what]).values())
        if self.what == "UV_SEAMS":
            check_local(source, source.data)
            check_not_edited(source)
            return seams_from_uv([source])[0]
        if self.what == "APPLY":
            check_local(source, source.data)
            check_not_edited(source)
            apply_modifiers(source)
            self.use_modifiers = bpy.context.scene.wirewarp.use_modifiers = False
            return 1
        if self.what in {"SUGGESTION", "SMOOTH"}:
            return _take_suggestion(source, is_smooth=self.what == "SMOOTH")
        report = last_report(source)
        if report is None:
            raise object_error("not_flattened", f'"{source.name}" has not been flattened yet. Press Flatten first.')
        return take_proposals(source, report, self.what)

    def draw(self, _context: bpy.types.Context) -> None:
        draw_settings(self.layout, self)


def _take_suggestion(source: bpy.types.Object, *, is_smooth: bool) -> int:
    """Returns how many edges were marked. Raises ObjectError."""
    check_local(source, source.data)
    check_not_edited(source)
    cut = chosen_cut(source, read_anew)
    if cut is None:
        sentence = f'Nothing is suggested for "{source.name}" as it is now. Press Suggest Darts or Suggest Seams.'
        raise object_error("no_suggestion", sentence)
    if is_smooth:
        return len(cut_smooth_lines(source, cut.edges))
    if cut.diagonals:
        cut_across_faces(source.data, cut.diagonals)
    return mark_seams(source.data, cut.edges)


CLASSES = (OBJECT_OT_wirewarp_mend,)
