# SPDX-License-Identifier: GPL-3.0-or-later
"""What Flatten asks for, in the sidebar and after a run alike."""

from dataclasses import asdict, replace

import bpy

from ..blender.units import meters_per_blender_unit
from ..flat.suggestions import Suggestions
from ..properties import EaseAmount, WIREWARP_PG_settings
from ..run.settings import FlattenChoices, FlattenSettings, choices_of

LINES_FIRST = {"WIREWARP_PLUS_PLUS", "WIREWARPING"}
WHOLE_WIDTH = {"fairness"}  # its name does not fit half a narrow sidebar
ADVANCED = {"thickness", "surface", "method", "node_weight"}  # for few models, and the paper's methods
ONLY_FOR = {"fairness": {"REFINED"}, "node_weight": LINES_FIRST}
OF_CUSTOM = {"cloth_across", "cloth_along", "cloth_shear"}
OF_CLOTHS = {"gives_across", "gives_along", "worn_across", "worn_along"}
TEXTS = {"spacing": {"text": "Gap (mm)"}, "thickness": {"text": "Thickness (mm)"}}
NAMES = {  # of the choices in a report, as the panel calls them
    "method": "Method",
    "fairness": "Smooth Outlines",
    "node_weight": "Angles",
    "layout": "Layout",
    "orientation": "Upright",
    "grain_angle": "Grain Angle",
    "cloth": "Cloth",
    "thickness": "Thickness",
    "surface": "Model Is",
    "spacing": "Gap",
    "mirror": "Mirrored",
}
CHOICES = ("method", "node_weight", "layout_kind", "orientation", "cloth", "surface")
BEFORE = {"cloth": None, "grain_angle": 0.0, "thickness": 0.0, "surface": "inside"}  # where a report has none
OF_REFINED, OF_OTHERS = {"fairness"}, {"node_weight"}


def draw_ease(layout: bpy.types.UILayout, settings: EaseAmount) -> None:
    """The amount and its unit."""
    row = layout.row(align=True)
    row.use_property_split = False
    in_percent = settings.ease_unit == "PERCENT"
    row.prop(settings, "ease_percent" if in_percent else "ease_length", text="")
    row.prop(settings, "ease_unit", expand=True)


def draw_settings(layout: bpy.types.UILayout, settings: FlattenSettings) -> None:
    """What most models need; settings that the chosen method does not use are gray."""
    _draw(layout, settings, [name for name in FlattenSettings.__annotations__ if name not in ADVANCED])


def draw_advanced(layout: bpy.types.UILayout, settings: FlattenSettings) -> None:
    """The material's thickness, the methods, and what belongs to those of the paper."""
    _draw(layout, settings, [name for name in FlattenSettings.__annotations__ if name in ADVANCED])


def _draw(layout: bpy.types.UILayout, settings: FlattenSettings, names: list[str]) -> None:
    hidden = (OF_CUSTOM if settings.cloth != "CUSTOM" else set()) | (OF_CLOTHS if settings.cloth == "NONE" else set())
    for name in (each for each in names if each not in hidden):
        row = layout.row()
        row.use_property_split = name not in WHOLE_WIDTH
        row.use_property_decorate = False
        row.enabled = settings.method in ONLY_FOR.get(name, {settings.method})
        if name == "grain_angle":
            row.enabled = settings.orientation == "WIRE"
        if name == "surface":
            row.enabled = settings.thickness > 0
        row.prop(settings, name, **TEXTS.get(name, {}))


def known_choices(settings: WIREWARP_PG_settings) -> FlattenChoices | None:
    """None where there is one that this version does not know: see mend_settings."""
    if "" in [getattr(settings, name) for name in CHOICES]:
        return None
    return choices_of(settings, meters_per_blender_unit(settings.id_data))


def settings_sentence(source: bpy.types.Object, report: dict, settings: WIREWARP_PG_settings) -> str:
    """Empty where a run with the settings of the panel would make the same pieces."""
    changed = _changed(source, report, settings)
    if not changed:
        return ""
    names = ", ".join(changed)
    return f"Settings changed since ({names}). Flatten again to apply."


def figures_sentence(source: bpy.types.Object, found: Suggestions, settings: WIREWARP_PG_settings) -> str:
    """Empty where a search with the settings of the panel would find the same cuts and figures."""
    choices = known_choices(settings)
    if choices is None:
        return ""
    then = asdict(_of_figures(found.choices)) | {"grain_wire": found.grain_wire}
    changed = _changed_choices(source, _of_figures(choices), then, found.wire_ids)
    return f"Settings changed since ({', '.join(changed)}). Suggest again." if changed else ""


def _of_figures(choices: FlattenChoices) -> FlattenChoices:
    """All alike but for what strain depends on: without a cloth it is the same whatever stands upright."""
    choices = replace(choices, layout="packed", spacing=0.0, mirror=False)
    if choices.cloth is None:
        return replace(choices, orientation="up", grain_angle=0.0)
    return replace(choices, cloth=replace(choices.cloth, gives_across=0.0, gives_along=0.0))


def _changed(source: bpy.types.Object, report: dict, settings: WIREWARP_PG_settings) -> list[str]:
    choices = known_choices(settings)
    if "options" not in report or choices is None:
        return []
    wire_ids = {wire["wire_id"] for wire in report["wires"]}
    changed = _changed_choices(source, choices, BEFORE | report["options"], wire_ids)
    if report.get("with_modifiers", False) != settings.use_modifiers and report.get("shaped_by"):
        changed.append("Modifiers")
    return changed


def _changed_choices(source: bpy.types.Object, choices: FlattenChoices, then: dict, wire_ids: set[int]) -> list[str]:
    """then: the options of a report; wire_ids: of the wires that there were."""
    now = asdict(choices) | {"grain_wire": source.data.wirewarp_grain}
    then = now | then
    unused = OF_OTHERS if now["method"] == "refined" else OF_REFINED
    had_grain = then["grain_wire"] in wire_ids
    if (now["orientation"], then["orientation"]) == ("wire", "up") and not had_grain:
        unused = unused | {"orientation"}  # while there is no grain wire, pieces stand as on the model
    changed = [name for key, name in NAMES.items() if key not in unused and now[key] != then[key]]
    if now["orientation"] == "wire" and then["grain_wire"] != now["grain_wire"]:
        changed.append("Grain Wire")
    return changed
