# SPDX-License-Identifier: GPL-3.0-or-later
"""Chooses and draws the best next step before the first run and after each run."""

from collections.abc import Iterable, Sequence
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

import bpy
from bpy.props import EnumProperty

from ..blender.objects import meters_per_blender_unit, world_box
from ..blender.selection import select_only
from ..blender.views import show_objects, work_area
from ..core import BEYOND_FABRIC, STRAINED, Issue, counted, issue_text, percent_text
from ..solve.report import ObjectReport, UvSeams
from ..state.reports import last_report
from ..state.settings import FlattenSettings

FOLDER = Path(str(files(__package__.rpartition(".")[0]))) / "samples"  # in the add-on's folder
SAMPLES = [  # samples in this folder, the simplest first
    ("CUSHION", "Cushion", "Six pieces, for any fabric"),
    ("FITTED_TOP", "Fitted Top", "Four pieces of jersey, with lines that keep their length"),
    ("JEANS", "Jeans", "Seven pieces of woven cotton"),
    ("TOY", "Bear", "Sixteen pieces of minky, with darts"),
    ("CARNIVAL_MASK", "Carnival Mask", "One piece of leather with two holes"),
]
STEPS = (
    "1. Open a sample, or select your model and press Mark This Model.",
    "2. Select the edges where the fabric is cut, and press Mark Seam.",
    "    Alt+click selects a whole line of edges.",
    "3. Select lines that must keep their length, and press Rigid.",
    "4. Choose the fabric, and press Flatten.",
    "5. Read the sentence below Flatten. If it is not green, press a button below it.",
    "6. Press Export Pattern, and print at 100%.",
)
WIDTH = 480  # width of the guide, in pixels at interface scale 1; its longest sentence is about 380 wide


class OBJECT_OT_wirewarp_open_sample(bpy.types.Operator):
    """Add a sample model with its seams and wires. If the file has no patterns yet, also use the sample's settings"""

    bl_idname = "object.wirewarp_open_sample"
    bl_label = "Open Sample"
    bl_options = {"REGISTER", "UNDO"}

    sample: EnumProperty(name="Sample", description="Which model to add", items=SAMPLES)

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.mode == "OBJECT" and context.scene.library is None

    def execute(self, context: bpy.types.Context) -> set[str]:
        scene, is_first = context.scene, not any(each.type == "MESH" for each in context.scene.objects)
        path = FOLDER / f"{self.sample.lower()}.blend"
        try:
            with bpy.data.libraries.load(str(path)) as (held, loaded):
                loaded.scenes = held.scenes
        except OSError:
            self.report({"ERROR"}, f'The sample "{path.name}" is not installed. Install the zip of WireWarp again.')
            return {"CANCELLED"}
        (sample_scene,) = loaded.scenes
        (model,) = sample_scene.objects
        if is_first or _is_new(scene):  # a new scene may contain Blender's default cube
            _take(scene.wirewarp, sample_scene.wirewarp, FlattenSettings.__annotations__)
        if is_first:
            _take(scene.unit_settings, sample_scene.unit_settings, ("system", "scale_length", "length_unit"))
        else:
            model.scale /= meters_per_blender_unit(scene)  # samples are in meters
            model.location.x = _free_place(scene, model)
        context.collection.objects.link(model)
        bpy.data.scenes.remove(sample_scene)
        select_only(context, model)
        area = work_area(context)
        if area:
            context.view_layer.update()
            show_objects(context, area, [model])
        return {"FINISHED"}


def _free_place(scene: bpy.types.Scene, model: bpy.types.Object) -> float:
    """Return the x coordinate at which the sample is beside the scene's meshes, with a gap of half the sample's
    width."""
    meshes = [each for each in scene.objects if each.type == "MESH"]
    right = max(world_box(each)[1, 0] for each in meshes)
    edges = [corner[0] * model.scale.x for corner in model.bound_box]
    return right - min(edges) + (max(edges) - min(edges)) / 2


def _is_new(scene: bpy.types.Scene) -> bool:
    """Return whether nothing was flattened in the scene and no setting of Flatten was changed."""
    settings = scene.wirewarp
    changed = any(settings.is_property_set(name) for name in FlattenSettings.__annotations__)
    return not changed and not any(last_report(each) for each in scene.objects if each.type == "MESH")


def _take(settings: bpy.types.bpy_struct, others: bpy.types.bpy_struct, names: Iterable[str]) -> None:
    for name in names:
        setattr(settings, name, getattr(others, name))


class WM_OT_wirewarp_guide(bpy.types.Operator):
    """Show the six steps from a model to a pattern"""

    bl_idname = "wm.wirewarp_guide"
    bl_label = "Guide"
    bl_options = {"INTERNAL"}

    def execute(self, _context: bpy.types.Context) -> set[str]:
        return {"FINISHED"}

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_popup(self, width=WIDTH)

    def draw(self, _context: bpy.types.Context) -> None:
        for step in STEPS:
            self.layout.label(text=step)


def draw_first_steps(layout: bpy.types.UILayout) -> None:
    layout.operator_menu_enum("object.wirewarp_open_sample", "sample", icon="FILE_FOLDER")
    layout.operator("wm.wirewarp_guide", icon="HELP")


MEND = "object.wirewarp_mend"
SHOW = "mesh.wirewarp_select_result"
# Text and icon of the button for each kind of fix, the most urgent first.
# Faults of the mesh come before seams, because seams would only hide the effects of the faults.
REMEDIES = {
    "MERGE": ("Merge and Flatten", "AUTOMERGE_ON"),
    "DISSOLVE": ("Dissolve and Flatten", "X"),
    "NORMALS": ("Fix Normals and Flatten", "NORMALS_FACE"),
    "SEAMS": ("Mark and Flatten", "EDGESEL"),
    "TOLERANCES": ("Loosen and Flatten", "FIXED_SIZE"),
}
APPLY_FIRST = "This fix needs edges that modifiers make. Apply the modifiers, or mark edges of the model itself."
CHECK = "object.wirewarp_check"
# Check and Repair finds and repairs these faults.
FAULTY_CODES = {"non_manifold_edge", "repeated_face", "repeated_vertex_in_face"}
OF_CODES = {"zero_area_face": "DISSOLVE", "loose_faces": "MERGE", "inconsistent_orientation": "NORMALS"}


class NextStep(NamedTuple):
    sentence: str  # reason; "" if the verdict has stated it
    text: str
    icon: str
    operator: str
    settings: dict


def next_step(report: ObjectReport, left_out: list[str]) -> NextStep | None:
    """Return the next step; None if none is needed, or if it is Suggest Darts or Suggest Seams.

    left_out: "modifiers" and "shape keys" of the present model if the run ignored them
    """
    remedies = [remedy_of(issue) for issue in report.issues]
    if report.with_modifiers and any(remedies):
        return NextStep(APPLY_FIRST, "Apply Modifiers and Flatten", "MODIFIER", MEND, {"what": "APPLY"})
    if report.uv_seams and report.uv_seams.is_good:
        return uv_step(report.uv_seams)
    for what, (text, icon) in REMEDIES.items():
        if what not in remedies:
            continue
        if what == "SEAMS" and not report.offered_seams:
            return None
        return NextStep(_reason(report.issues, what), text, icon, MEND, {"what": what})
    if {issue.code for issue in report.issues} & FAULTY_CODES and not report.with_modifiers:
        return NextStep("", "Check and Repair", "TOOL_SETTINGS", CHECK, {})
    if report.issues:
        return _step_to_show("ISSUE", "Show Failed Place", _placed(report, report.issues))
    if left_out:
        return NextStep("", "Flatten with Modifiers", "MODIFIER", MEND, {"what": "MODIFIERS"})
    is_strained = any(piece.is_strained for piece in report.pieces)
    return _step_to_show("HINT", "Show Worst Place", _strained_places(report)) if is_strained else None


def uv_step(found: UvSeams | None) -> NextStep:
    """Return the step that marks the seams of the UV map.

    found: the result of flattening with these seams; None before the first run.
    """
    sentence = ""
    if found:
        beyond = ", too much for this fabric" if found.is_beyond_fabric else ""
        stretch = percent_text(found.stretch)
        became = f"with a stretch of {stretch}{beyond}"
        if found.failed:
            became = f"{found.failed} of them fail"
        elif found.beyond_any:
            became = f"{found.beyond_any} with a stretch over 100%, the others with {stretch}{beyond}"
        sentence = f"The seams of the UV map make {counted(found.pieces, 'piece')}, {became}."
    return NextStep(sentence, "Use UV Map Seams", "UV", MEND, {"what": "UV_SEAMS"})


def marks_seams(step: NextStep) -> bool:
    return step.settings.get("what") == "SEAMS"


def wants_seams(report: ObjectReport) -> bool:
    return any(issue.proposed_seams for issue in report.issues)


def piece_to_cut(report: ObjectReport, step: NextStep | None) -> int | None:
    """Return the piece for which darts or seams are offered: the piece that the next step shows, or the worst piece if
    there is no next step. Return None if no piece needs cuts."""
    if step:
        return report.hints[step.settings["index"]].piece if step.settings.get("what") == "HINT" else None
    strained = [piece for piece in report.pieces if piece.is_strained]
    return max(strained, key=lambda piece: piece.excess).index if strained else None


def _step_to_show(what: str, text: str, places: list[int]) -> NextStep | None:
    """Return the step that shows the first of these places; None if there are no places. places: indices of the
    report's issues or hints."""
    return NextStep("", text, "RESTRICT_SELECT_OFF", SHOW, {"what": what, "index": places[0]}) if places else None


def _placed(report: ObjectReport, entries: Sequence[Issue]) -> list[int]:
    """Return the indices of the issues or hints that have a place, the worst first."""
    return [index for index, entry in enumerate(entries) if has_shown_place(report, entry)]


def _strained_places(report: ObjectReport) -> list[int]:
    """Return the indices of the hints about strained places of the worst piece.

    The largest place is first, because the most strained place may be a single face.
    """
    hints = report.hints
    places = [index for index in _placed(report, hints) if hints[index].code in {STRAINED, BEYOND_FABRIC}]
    own = [index for index in places if hints[index].piece == hints[places[0]].piece]
    return sorted(own, key=lambda index: -len(hints[index].faces))


def remedy_of(issue: Issue) -> str | None:
    """Return the kind of fix for the issue, or None if nothing fixes it."""
    if issue.proposed_seams:
        return "SEAMS"
    return "TOLERANCES" if issue.proposed_tolerances else OF_CODES.get(issue.code)


def has_shown_place(report: ObjectReport, entry: Issue) -> bool:
    """Return whether an issue or hint has a place to select. With modifiers, only places on flat
    pieces can be selected."""
    if not entry.has_place:
        return False
    if not report.with_modifiers:
        return True
    return entry.piece is not None and report.pieces[entry.piece].has_layout


def failure_text(report: ObjectReport, step: NextStep | None) -> str:
    """Return the text of the fault that the step fixes or shows, or else of the first fault, without the remedy. The
    report must have a fault."""
    what = step.settings.get("what") if step else None
    found = [report.issues[step.settings["index"]]] if step and what == "ISSUE" else []
    found += [issue for issue in report.issues if what and remedy_of(issue) == what]
    fault = issue_text(report, [*found, *report.issues][0]).partition(". ")[0]
    return f"{fault.rstrip('.')}."


def _reason(issues: Sequence[Issue], what: str) -> str:
    if what == "SEAMS":
        # Each edge counts once, because the issues of mirrored pieces suggest the same edges.
        edges = {(min(edge), max(edge)) for issue in issues for edge in issue.proposed_seams}
        return f"Suggested seam: {counted(len(edges), 'edge')}."
    if what == "TOLERANCES":
        wires = {wire.name for issue in issues for wire in issue.proposed_tolerances}
        return f"Suggestion: loosen {counted(len(wires), 'wire')}."
    return ""
