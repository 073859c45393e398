# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the settings of Flatten in the sidebar and after a run, and compares them with reports and suggestions."""

from dataclasses import asdict, replace

import bpy

from ..blender.objects import meters_per_blender_unit
from ..core import percent_text
from ..properties import EaseAmount, WIREWARP_PG_settings
from ..solve.flatten import LAYOUT_OPTIONS
from ..solve.report import ObjectReport
from ..state.flat_pieces import no_pieces_sentence
from ..state.owners import earlier_sentence, has_flat_object, is_earlier, model_or_self
from ..state.reports import last_report, seems_changed
from ..state.settings import PARTS, SETTINGS, FlattenChoices, FlattenSettings, Setting, choices_of, usual_stretch
from ..state.suggestions import Suggestions

# Two settings whose labels end in these directions have a common heading. Their full labels would be cut off.
WAYS = ("Across", "Along")


def shown_report(context: bpy.types.Context) -> ObjectReport | None:
    """Return the report of the active model, or of the model of active flat pieces; None if there is none."""
    source = shown_source(context)
    return last_report(source) if source else None


def shown_source(context: bpy.types.Context) -> bpy.types.Object | None:
    active = context.active_object
    if active is None or active.type != "MESH":
        return None
    return model_or_self(active)


def untrue_sentence(active: bpy.types.Object, source: bpy.types.Object, report: ObjectReport) -> str:
    """Return a sentence that says why the report does not match the displayed model; "" if it matches."""
    if seems_changed(source, report):
        return "The model has changed since it was flattened. Flatten again."
    if report.flat_object is not None and not has_flat_object(source):
        return no_pieces_sentence(source)
    return earlier_sentence(active) if is_earlier(active) else ""


def draw_ease(layout: bpy.types.UILayout, settings: EaseAmount) -> None:
    row = layout.row(align=True)
    row.use_property_split = False
    in_percent = settings.ease_unit == "PERCENT"
    row.prop(settings, "ease_percent" if in_percent else "ease_length", text="")
    row.prop(settings, "ease_unit", expand=True)


def draw_settings(layout: bpy.types.UILayout, settings: FlattenSettings, *parts: str) -> None:
    """Draw the settings of these PARTS, or all settings. Settings without effect are gray."""
    for setting in SETTINGS:
        if setting.part(settings) in (parts or PARTS) and setting.is_shown(settings):
            heading, _, way = setting.full_label.rpartition(" ")
            if way == WAYS[0]:
                layout.label(text=heading)
            row = layout.row()
            row.use_property_split = not setting.is_wide
            row.use_property_decorate = False
            row.enabled = setting.is_used(settings)
            # The fabric has no label, because the items of its menu are long and clear without a label.
            if setting.name == "cloth" and parts:
                row.use_property_split = False
                row.prop(settings, setting.name, text="", icon="MATCLOTH")
            else:
                row.prop(settings, setting.name, text=_label(settings, setting, way if way in WAYS else ""))


def _label(settings: FlattenSettings, setting: Setting, way: str) -> str:
    """Return the label of a setting. way: the direction if a heading names the rest, otherwise "". If a maximum stretch
    is 0, its label has the usual value of the fabric."""
    usual = usual_stretch(settings).get(setting.name)
    note = "" if usual is None or getattr(settings, setting.name) else f" (0 = {percent_text(usual)})"
    return (way or setting.full_label) + note


def known_choices(settings: WIREWARP_PG_settings) -> FlattenChoices | None:
    """Return the choices; None if a setting has a value that this version does not know: see reset_unknown."""
    if "" in [getattr(settings, setting.name) for setting in SETTINGS]:
        return None
    return choices_of(settings, meters_per_blender_unit(settings.id_data))


def settings_sentence(source: bpy.types.Object, report: ObjectReport, settings: WIREWARP_PG_settings) -> str:
    """Return a sentence about settings that changed after the run; empty if a run with the present settings would make
    the same pieces."""
    choices = known_choices(settings)
    if report.options is None or choices is None:
        return ""
    wire_ids = {wire.wire_id for wire in report.wires}
    changed = _changed_choices(source, settings, choices, report.options, wire_ids, set())
    if report.with_modifiers != settings.use_modifiers and report.shaped_by:
        changed.append("Modifiers")
    return f"Settings changed after Flatten: {', '.join(changed)}. Flatten again to use them." if changed else ""


def figures_sentence(source: bpy.types.Object, found: Suggestions, settings: WIREWARP_PG_settings) -> str:
    """Return a sentence about settings that changed after the search; empty if a search with the present settings would
    find the same cuts and figures."""
    choices = known_choices(settings)
    if choices is None:
        return ""
    then = asdict(_of_strain(found.choices)) | {"grain_wire": found.grain_wire}
    # Without a fabric, the strain does not depend on the upright direction, so its settings are ignored.
    upright = {"orientation", "grain_angle", "grain_wire"} if choices.cloth else set()
    ignored = set(LAYOUT_OPTIONS) - upright
    changed = _changed_choices(source, settings, _of_strain(choices), then, found.wire_ids, ignored)
    return f"Settings changed after the search: {', '.join(changed)}. Search again." if changed else ""


def _of_strain(choices: FlattenChoices) -> FlattenChoices:
    """Return the choices without the fabric's maximum stretch, because suggestions do not depend on it."""
    fabric = choices.cloth
    return replace(choices, cloth=replace(fabric, gives_across=0.0, gives_along=0.0)) if fabric else choices


def _changed_choices(
    source: bpy.types.Object,
    settings: WIREWARP_PG_settings,
    choices: FlattenChoices,
    then: dict,
    wire_ids: set[int],
    ignored: set[str],
) -> list[str]:
    """Return the labels of changed settings that are used. then: options of the earlier run or search; wire_ids: ids of
    its wires; ignored: names of options that are not compared."""
    now = asdict(choices) | {"grain_wire": source.data.wirewarp_grain}
    had_grain = then["grain_wire"] in wire_ids
    if (now["orientation"], then["orientation"]) == ("grain", "up") and not had_grain:
        # Without a grain wire, "grain" has the same effect as "up".
        ignored = ignored | {"orientation"}
    compared = [each for each in SETTINGS if each.choice and each.choice not in ignored and each.is_used(settings)]
    changed = [each.label for each in compared if now[each.choice] != then[each.choice]]
    if "grain_wire" not in ignored and now["orientation"] == "grain" and then["grain_wire"] != now["grain_wire"]:
        changed.append("Grain Wire")
    return changed
