# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the panel Flatten, with the verdict of the last run and the next steps."""

import math
from collections.abc import Sequence, Set

import bpy

from ..blender.mesh import read_seams
from ..blender.objects import height_of, likely_units, meters_per_blender_unit, size_text, strange_size, unit_text
from ..core import Cloth, Kind, Line, as_seen, with_narrow
from ..flatten.auto_update import EDIT_LIMIT, is_left, waits_for_object_mode
from ..issues import ObjectError
from ..marks.mark import has_new_seams
from ..marks.wire_list import shown_wires
from ..overlay.shown import narrow_pieces
from ..solve.report import ObjectReport
from ..state.changes import shows_modified
from ..state.drawings import Same, kept_drawing
from ..state.memory import is_due, stamp, state_of
from ..state.owners import find_flat_object, has_flat_object, model_of, model_or_self
from ..state.read_model import shaped_by
from ..state.reports import last_report, seems_changed
from ..state.settings import fabric_label
from ..suggest.panel import are_shown, draw_suggest, draw_suggestions
from ..ui.layout import LEVEL_ICONS, SidebarPanel, draw_progress, draw_sentence
from ..ui.settings import draw_settings, settings_sentence, shown_report, untrue_sentence
from ..ui.window_run import FLATTEN, is_running
from .next_step import (
    CHECK,
    SHOW,
    NextStep,
    draw_first_steps,
    failure_text,
    marks_seams,
    next_step,
    piece_to_cut,
    uv_step,
    wants_seams,
)

ICON = "MATCLOTH"
FAR_ENOUGH = "Ticked fabrics stretch far enough for the present pieces"
TO_TRY = "Flatten to see whether a fabric stretches far enough"
# These elastic fabrics are sold for clothes.
EVERYDAY = {"fleece", "jersey", "swim"}


def fabrics_to_choose(report: ObjectReport, present: str = "") -> tuple[list[str], list[str]]:
    """Return the presets that stretch far enough for these pieces, and the other presets, both by increasing stretch.

    This is an estimate, because the pieces differ with another fabric. present: fabric that the second list leaves out
    """
    across = max((piece.threads.across if piece.threads else piece.needed for piece in report.pieces), default=0.0)
    along = max((piece.threads.along if piece.threads else piece.needed for piece in report.pieces), default=0.0)
    limits = {name: Cloth.preset(name).limits for name in Cloth.presets()}
    names = sorted(limits, key=lambda name: min(limits[name]))
    can = [name for name in names if across <= limits[name][0] and along <= limits[name][1]]
    return can, [name for name in names if name not in can and name != present]


class VIEW3D_MT_wirewarp_fabrics(bpy.types.Menu):
    """Choose another fabric, and flatten for it"""

    bl_label = "Choose Fabric"

    def draw(self, context: bpy.types.Context) -> None:
        report, layout, present = shown_report(context), self.layout, context.scene.wirewarp.cloth.lower()
        layout.operator_context = "INVOKE_DEFAULT"
        found = fabrics_to_choose(report, present) if report else ([], [])
        layout.label(text=FAR_ENOUGH if found[0] else TO_TRY)
        # Both groups share one heading, because Blender reverses the order of a menu that opens upward.
        for icon, names in zip(("CHECKMARK", "BLANK1"), found, strict=True):
            for name in names:
                button = layout.operator("object.wirewarp_mend", text=fabric_label(name), icon=icon)
                button.what, button.cloth = "FABRIC", name.upper()


DUE = "Auto updates the pieces when the tool ends."
FIRST = "Press Flatten once. Then Auto updates the pieces."
LEFT = "Auto was canceled for this change. Press Flatten, or change the model again."
FABRIC_HELPS = {Kind.NEEDS_STRETCH, Kind.BEYOND_FABRIC}
WAITS = f"This model has more than {EDIT_LIMIT:,} vertices, so Auto waits until you leave Edit Mode."


class VIEW3D_PT_wirewarp_flatten(SidebarPanel, bpy.types.Panel):
    bl_label = "Flatten"

    def draw(self, context: bpy.types.Context) -> None:
        layout, settings = self.layout, context.scene.wirewarp
        draw_settings(layout, settings, "FRONT")
        row = layout.row(align=True)
        row.scale_y = 1.5
        layout = layout.column()
        # During a run, the column is gray instead of hidden, so that no button moves.
        layout.enabled = not draw_progress(row, FLATTEN, "object.wirewarp_flatten")
        if layout.enabled:
            row.operator("object.wirewarp_flatten", icon="MOD_UVPROJECT")
            row.prop(settings, "auto_update", text="", icon="FILE_REFRESH")
        active = context.active_object
        if active is None or active.type != "MESH":
            draw_sentence(context, layout, "Select a mesh, or try a sample.", "INFO")
            draw_first_steps(layout)
            return
        source = model_or_self(active)
        _draw_size(context, layout, source)
        report = last_report(source)
        if report is None:
            if settings.auto_update:
                draw_sentence(context, layout, FIRST, "INFO")
            if _may_use_uv_seams(source):
                _draw_step(context, layout, uv_step(None))
            draw_first_steps(layout)
            draw_suggestions(context, layout, "FLATTEN")
        else:
            _draw_state(context, layout, source, report)
        if report and settings.auto_update and waits_for_object_mode(source):
            draw_sentence(context, layout, WAITS, "INFO")
        if report:
            text = "Show Model and Pieces" if find_flat_object(source) else "Show Model"
            layout.operator("view3d.wirewarp_frame", text=text, icon="VIEWZOOM")
        if settings.method == "WIREWARPING" and _has_loose_wires(active):
            draw_sentence(context, layout, "The chosen method keeps elastic and free wires rigid, too.", "INFO")


def _draw_size(context: bpy.types.Context, layout: bpy.types.UILayout, source: bpy.types.Object) -> None:
    """Draw a question about an implausible size, with buttons for possible units. Files often lack the unit."""
    question, state, report = strange_size(source, context.scene), state_of(source), Same(last_report(source))
    # After a choice, the question and its buttons stay until the next run, so that no button below moves.
    if question:
        state.size_asked = question, report
    asked, asked_at = state.size_asked or ("", None)
    if not asked or asked_at != report:
        return
    column = layout.column(align=True)
    draw_sentence(
        context, column, question or size_text(source, context.scene), "AMBER" if question else "INFO", as_high_as=asked
    )
    now = meters_per_blender_unit(context.scene)
    for unit in likely_units(source):
        is_now = math.isclose(unit, now, rel_tol=1e-5)  # Blender rounds the unit to single precision
        row = column.operator("scene.wirewarp_set_unit", text=unit_text(source, unit), depress=is_now)
        row.meters = unit
    if height_of(source) > 0:
        column.separator()
        column.operator("scene.wirewarp_set_height")


def _draw_state(
    context: bpy.types.Context, layout: bpy.types.UILayout, source: bpy.types.Object, report: ObjectReport
) -> None:
    untrue = untrue_sentence(context.active_object, source, report)
    is_updated = seems_changed(source, report) and _will_update(context, source)
    if untrue and not is_updated:
        warning = layout.column()
        warning.alert = True
        draw_sentence(context, warning, untrue, "ERROR")
        if context.scene.wirewarp.auto_update and is_left(source):
            draw_sentence(context, layout, LEFT, "INFO")
        draw_suggestions(context, layout, "FLATTEN")
        return
    left_out = _left_out(context, source, report)
    narrow = {source.name: narrow_names(context, source, report)}
    verdict = with_narrow(as_seen(report.tables.verdict, left_out), narrow)
    lines = verdict.lines
    if is_updated:  # the rows turn gray instead of disappearing, so that nothing below moves
        draw_sentence(context, layout, DUE, "INFO", as_high_as=lines[0].text)
        lines, layout = lines[1:], layout.column()
        layout.enabled = False
    _draw_verdict(context, layout, source, report, lines)
    step = next_step(report, left_out)
    kinds = {line.kind for line in verdict.lines}
    if report.issues and (verdict.kind is not Kind.CLOSED or Kind.NEEDS_SEAM in kinds):
        draw_sentence(context, layout, failure_text(report, step), "INFO")
    _draw_remedies(context, layout, report, step, kinds)


def _draw_verdict(
    context: bpy.types.Context,
    layout: bpy.types.UILayout,
    source: bpy.types.Object,
    report: ObjectReport,
    lines: Sequence[Line],
) -> None:
    # The settings are compared with those of the last run, even if it failed and kept earlier pieces, because the same
    # settings would fail again.
    changed = settings_sentence(source, report, context.scene.wirewarp) if has_flat_object(source) else ""
    if changed:
        draw_sentence(context, layout, changed, "INFO")
    of_last_run = layout.column()
    of_last_run.enabled = not changed
    for line in lines:
        draw_sentence(context, of_last_run, line.text, "BLANK1" if changed else LEVEL_ICONS[line.kind.level])


def _draw_remedies(
    context: bpy.types.Context,
    layout: bpy.types.UILayout,
    report: ObjectReport,
    step: NextStep | None,
    kinds: Set[Kind],
) -> None:
    """Draw the buttons for the next step, fabrics and suggestions. kinds: kinds of line in the verdict."""
    # A step that only shows a place is drawn below steps that change the model.
    is_looked_at = step is not None and step.operator == SHOW
    if step and not is_looked_at:
        below = layout.column()
        # While suggestions are shown, only their button marks seams. The button of this step turns gray instead of
        # disappearing, so that the buttons of the search do not move.
        below.enabled = not (marks_seams(step) and are_shown(context))
        _draw_step(context, below, step)
    # If the user has chosen a fabric, the button for a suitable fabric is not drawn.
    if Kind.NEEDS_STRETCH in kinds and context.scene.wirewarp.cloth == "NONE":
        _draw_fabric(layout, report)
    if kinds & FABRIC_HELPS:
        layout.menu(VIEW3D_MT_wirewarp_fabrics.__name__, icon=ICON)
    if wants_seams(report):
        draw_suggest(layout, context.scene.wirewarp, "FLATTEN", -1, ["seams"], has_seams=False)
        if report.flat_object is None:  # the panel Export, which has the allowance, is not shown without pieces
            layout.prop(context.scene.wirewarp, "allowance", text="Allowance (mm)")
    piece = piece_to_cut(report, step)
    if piece is not None:
        draw_suggest(layout, context.scene.wirewarp, "FLATTEN", piece, has_seams=bool(report.seams))
    draw_suggestions(context, layout, "FLATTEN")
    if report.uv_seams and not report.uv_seams.is_good:
        _draw_step(context, layout, uv_step(report.uv_seams))
    if step and is_looked_at:
        _draw_step(context, layout, step)
    if report.issues and not (step and step.operator == CHECK):
        layout.operator(CHECK, icon="TOOL_SETTINGS")


def narrow_names(context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> list[str]:
    """Return the names of the report's pieces without room for their allowances; none while pieces are in Edit Mode."""
    flat = find_flat_object(source) if report.flat_object is not None and has_flat_object(source) else None
    return [] if flat is None or flat.data.is_editmode else narrow_pieces(context, source, flat)


def _will_update(context: bpy.types.Context, source: bpy.types.Object) -> bool:
    """Return whether Auto will update the pieces of the changed model without another change."""
    if not context.scene.wirewarp.auto_update or source.library or not has_flat_object(source):
        return False
    if is_left(source):  # the present run updates the model, or an earlier update was canceled
        return is_running(FLATTEN)
    is_coming = is_due(context.scene) and not state_of(context.scene).is_undone
    return is_coming and not waits_for_object_mode(source)


def _draw_fabric(layout: bpy.types.UILayout, report: ObjectReport) -> None:
    """Draw a button for the everyday fabric with the least stretch that suffices, if there is one.

    Leather, foam and other special materials are in the menu below the button.
    """
    can, _ = fabrics_to_choose(report)
    name = next((name for name in can if name in EVERYDAY), "")
    if not name:
        return
    row = layout.row()
    row.scale_y = 1.2
    button = row.operator("object.wirewarp_mend", text=f"Flatten for {Cloth.about(name)['label']}", icon=ICON)
    button.what, button.cloth = "FABRIC", name.upper()


def _may_use_uv_seams(source: bpy.types.Object) -> bool:
    """Return whether the model has no seams, but its own UV map has several islands; False in Edit Mode."""
    mesh = source.data
    if mesh.is_editmode or source.library or mesh.library:
        return False
    made_of = stamp(source), stamp(mesh)
    return kept_drawing(source, "uv seams", made_of, lambda: not read_seams(mesh).any() and has_new_seams(mesh))


def _draw_step(context: bpy.types.Context, layout: bpy.types.UILayout, step: NextStep) -> None:
    if step.sentence:
        draw_sentence(context, layout, step.sentence, "INFO")
    button = layout.row()
    button.scale_y = 1.2
    asked = button.operator(step.operator, text=step.text, icon=step.icon)
    for name, value in step.settings.items():
        setattr(asked, name, value)


def offered_piece(context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> int | None:
    """Return the piece for which the panel shows Suggest Darts and Suggest Seams; None if it does not show them."""
    if untrue_sentence(context.active_object, source, report):
        return None
    left_out = _left_out(context, source, report)
    return piece_to_cut(report, next_step(report, left_out))


def _left_out(context: bpy.types.Context, source: bpy.types.Object, report: ObjectReport) -> list[str]:
    """Return "modifiers" and "shape keys" if they shape the model but not the pieces. If Blender does not evaluate the
    model's modifiers, return the words for the model of the last run."""
    if report.with_modifiers or not shows_modified(source):
        return report.left_out
    if not source.modifiers and not source.data.shape_keys:
        return []
    depsgraph = context.view_layer.depsgraph
    made_of = stamp(source), stamp(source.data)
    return kept_drawing(source, "shaped by", made_of, lambda: shaped_by(source, depsgraph))


def _has_loose_wires(active: bpy.types.Object) -> bool:
    try:
        return not model_of(active) and any(wire.tolerance > 0 for _, wire in shown_wires(active))
    except ObjectError:
        return False  # the list of wires reports the fault


class VIEW3D_PT_wirewarp_settings(SidebarPanel, bpy.types.Panel):
    bl_label = "Settings"
    bl_parent_id = "VIEW3D_PT_wirewarp_flatten"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        draw_settings(self.layout, context.scene.wirewarp, "MAIN")


class VIEW3D_PT_wirewarp_advanced(SidebarPanel, bpy.types.Panel):
    bl_label = "Advanced"
    bl_parent_id = "VIEW3D_PT_wirewarp_settings"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: bpy.types.Context) -> None:
        draw_settings(self.layout, context.scene.wirewarp, "ADVANCED")
