# SPDX-License-Identifier: GPL-3.0-or-later
"""What the overlay shows in a view: the objects and their drawings, built where they have changed."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import bpy

from ..color_maps import COLOR_MAPS, ColorMap
from ..issues import ObjectError
from ..mesh_cache import stamp
from ..owners import find_flat_object, model_of, model_or_self
from ..report_store import last_report
from ..wire_attributes import WIRE
from .cache import Same, kept_drawing
from .failure_drawing import Failures, failures
from .object_drawing import Lines, colored_surface, marked_lines
from .surface_arrays import ColoredTriangles, Extremes

MODES = {"OBJECT", "EDIT"}


@dataclass(frozen=True)
class Drawing:
    target: bpy.types.Object
    lines: Lines | None
    failures: Failures | None
    surface: ColoredTriangles | None


def shown_map(context: bpy.types.Context) -> ColorMap | None:
    wanted = context.scene.wirewarp.shown_map
    return next((each for each in COLOR_MAPS if each.attribute.upper() == wanted), None)


def missing_maps(shown: Sequence[Drawing]) -> list[str]:
    """Why the map that is wanted is not on all of them, as sentences."""
    without = [each.target for each in shown if each.surface is None and not each.target.data.is_editmode]
    never = [target for target in without if last_report(model_or_self(target)) is None]
    notes = ["Not flattened yet: no map"] if never else []
    return notes + (["Changed since: flatten again"] if len(never) < len(without) else [])


def extremes(shown: Sequence[Drawing]) -> Extremes | None:
    """The smallest and the largest value of the map on all of them."""
    found = [each.surface.extremes for each in shown if each.surface and each.surface.extremes]
    return (min(low for low, _ in found), max(high for _, high in found)) if found else None


def drawings(context: bpy.types.Context) -> Iterator[Drawing]:
    """Of all models and flat pieces in the view."""
    settings, color_map = context.scene.wirewarp, shown_map(context)
    if not context.space_data.overlay.show_overlays or not (settings.show_lines or color_map):
        return
    for target in context.visible_objects:
        if target.type == "MESH" and target.mode in MODES and _concerns_us(target):
            yield _drawing(context, target, color_map)


def _concerns_us(target: bpy.types.Object) -> bool:
    return bool(model_of(target) or last_report(target) or WIRE in target.data.attributes)


def _drawing(context: bpy.types.Context, target: bpy.types.Object, color_map: ColorMap | None) -> Drawing:
    lines = failed = surface = None
    source = model_or_self(target)
    names = [(entry.wire_id, entry.name) for entry in source.data.wirewarp_names]
    report = Same(last_report(source))
    made_of = stamp(target), stamp(target.data), target.data.is_editmode, report, source.name_full, names
    depsgraph = context.view_layer.depsgraph
    if context.scene.wirewarp.show_lines:
        lines = kept_drawing(target, "lines", made_of, lambda: _lines(target, depsgraph))
        if not target.data.is_editmode:
            failed = kept_drawing(target, "failures", made_of, lambda: failures(target))
    if color_map and not target.data.is_editmode:
        flat = find_flat_object(source)
        with_map = (*made_of, color_map.attribute, *((stamp(flat.data), flat.data.is_editmode) if flat else ()))
        surface = kept_drawing(target, "surface", with_map, lambda: colored_surface(target, depsgraph, color_map))
    return Drawing(target, lines, failed, surface)


def _lines(target: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> Lines:
    try:
        return marked_lines(target, depsgraph)
    except ObjectError:
        return Lines({}, {}, [])  # an attribute of our name is another's; the list of wires says so
