# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the objects to draw in 3D views and UV editors."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import bpy
import numpy as np

from ..blender.attributes import stored_text
from ..blender.objects import meters_per_blender_unit, metric
from ..core import by_way, percent_text
from ..export.export import GRAINS, Cloth, PatternParts, library_paper
from ..export.read import read_outlines
from ..export.steps import copies_of_piece, copies_sentences
from ..issues import ObjectError
from ..names import MARKER, MARKS
from ..solve.maps import ASPECT_RATIO, CLOTH_MAPS, COLOR_MAPS, SHEAR, STRETCH, WEFT, ColorMap
from ..solve.report import ObjectReport
from ..state.drawings import Same, kept_drawing
from ..state.identities import piece_names, seam_names
from ..state.memory import find_objects, stamp
from ..state.owners import find_flat_object, model_of, model_or_self
from ..state.reports import last_report, pieces_report
from ..state.suggestions import suggestions_of
from .failures import Failures, failures, suggested_lines, uv_suggested_lines, with_cut
from .gather import ColoredTriangles, shows_our_map
from .objects import Lines, colored_surface, marked_lines, uv_lines
from .pages import CutLines, PageChoices, PagePreview, cut_lines, cut_places, page_preview

MODES = {"OBJECT", "EDIT"}
STRETCH_MAPS = (STRETCH, ASPECT_RATIO)
# For these maps, the legend shows the value that 99% of the area does not exceed, like the list of pieces. It does not
# show the largest value.
ONE_FIGURE = (*STRETCH_MAPS, *CLOTH_MAPS)


@dataclass(frozen=True)
class Drawing:
    target: bpy.types.Object
    lines: Lines | None
    failures: Failures | None
    surface: ColoredTriangles | None


def shown_map(context: bpy.types.Context) -> ColorMap | None:
    wanted = context.scene.wirewarp.shown_map
    return next((each for each in COLOR_MAPS if each.attribute.upper() == wanted), None)


# The legend lists these reasons for a missing map in this order.
REASONS = NOT_FLATTENED, NO_FABRIC, CHANGED, EDITED = (
    "Not flattened: no map",
    "No fabric was chosen: no map",
    "Model changed: flatten again",
    "In Edit Mode: no map",
)


def missing_maps(shown: Sequence[Drawing], color_map: ColorMap) -> list[str]:
    missing = [each.target for each in shown if each.surface is None]
    found = {_why_missing(target, color_map) for target in missing}
    if len(missing) < len(shown):  # maps of other objects are in view, so the note about Edit Mode is unnecessary
        found.discard(EDITED)
    return [reason for reason in REASONS if reason in found]


def _why_missing(target: bpy.types.Object, color_map: ColorMap) -> str:
    if _is_edited(target):
        return EDITED
    report = last_report(model_or_self(target))
    if report is None or report.flat_object is None:
        return NOT_FLATTENED
    has_cloth = bool((report.options or {}).get("cloth"))
    return NO_FABRIC if color_map in CLOTH_MAPS and not has_cloth else CHANGED


def _is_edited(target: bpy.types.Object) -> bool:
    """Return whether the object, or its flat pieces, which store the colors of its map, are in Edit Mode."""
    flat = find_flat_object(target)
    return target.data.is_editmode or (flat is not None and flat.data.is_editmode)


def map_notes(shown: Sequence[Drawing], color_map: ColorMap) -> list[str]:
    """Return notes for the legend: why the map is missing on some objects and, for maps of stretch and shear, the value
    that 99% of the area does not exceed."""
    reports = [last_report(model_or_self(each.target)) for each in shown if each.surface is not None]
    figure = _figure([report for report in reports if report], color_map)
    return [*missing_maps(shown, color_map), *([f"99% of the area: up to {figure}"] if figure else [])]


def _figure(reports: Sequence[ObjectReport], color_map: ColorMap) -> str:
    """Return the text of the largest stretch or shear of the pieces; empty for maps of other measures."""
    pieces = [piece for report in reports for piece in report.pieces if piece.ok]
    threads = [piece.threads for piece in pieces if piece.threads]
    if color_map in STRETCH_MAPS and pieces:
        if threads:
            return by_way(max(each.across for each in threads), max(each.along for each in threads))
        return f"{percent_text(max(piece.needed for piece in pieces))} in the worst direction"
    if color_map is SHEAR and threads:
        return f"{math.degrees(max(each.shear for each in threads)):.0f}°"
    if color_map in CLOTH_MAPS and threads:
        return percent_text(max(each.across if color_map is WEFT else each.along for each in threads))
    return ""


def highest_value(shown: Sequence[Drawing], color_map: ColorMap) -> float | None:
    """Return the largest value of the map on any object; None if the legend does not show the value."""
    if color_map in ONE_FIGURE:
        return None
    found = [each.surface.highest for each in shown if each.surface]
    return max((highest for highest in found if highest is not None), default=None)


def drawings(context: bpy.types.Context) -> Iterator[Drawing]:
    settings, color_map = context.scene.wirewarp, shown_map(context)
    if not context.space_data.overlay.show_overlays or not (settings.show_lines or settings.show_pages or color_map):
        return
    view_layer, space = context.view_layer, context.space_data
    for target in find_objects(concerns_us):
        if target.mode in MODES and target.visible_get(view_layer=view_layer, viewport=space):
            yield _drawing(context, target, color_map)


def concerns_us(target: bpy.types.Object) -> bool:
    if target.type != "MESH":
        return False
    attributes = target.data.attributes
    is_marked = any(mark.name in attributes for mark in MARKS if mark.is_drawn)
    return bool(is_marked or model_of(target) or last_report(target) or suggestions_of(target))


def _drawing(context: bpy.types.Context, target: bpy.types.Object, color_map: ColorMap | None) -> Drawing:
    lines = failed = surface = None
    source = model_or_self(target)
    wires = [(entry.wire_id, entry.name) for entry in source.data.wirewarp_names]
    names = wires, piece_names(source), seam_names(source)
    report = Same(last_report(source))
    scale = metric(source).tobytes()  # in made_of, because report and suggestions are valid for one scale
    made_of = stamp(target), stamp(target.data), target.data.is_editmode, report, source.name_full, names, scale
    depsgraph = context.view_layer.depsgraph
    if context.scene.wirewarp.show_lines:
        has_cut = target != source and not target.data.is_editmode
        cut = _cut_lines(context, source, target) if has_cut else None
        lines = kept_drawing(
            target,
            "lines",
            (*made_of, Same(cut)),
            lambda: _with_cut(_or_none(marked_lines, target, depsgraph), cut, context.scene),
        )
        of_model = stamp(source.data), source.data.is_editmode, Same(suggestions_of(source))
        failed = kept_drawing(
            target,
            "failures",
            (*made_of, *of_model),
            lambda: with_cut(failures(target), suggested_lines(target, depsgraph)),
        )
    if context.scene.wirewarp.show_pages and target != source and not target.data.is_editmode:
        pages, without = shown_pages(context, source, target), lines
        lines = kept_drawing(
            target, "lines and pages", (Same(without), Same(pages)), lambda: _with_pages(without, pages)
        )
    if color_map and not target.data.is_editmode:
        flat = find_flat_object(source)
        with_map = (*made_of, color_map.attribute, *((stamp(flat.data), flat.data.is_editmode) if flat else ()))
        surface = kept_drawing(target, "surface", with_map, lambda: colored_surface(target, depsgraph, color_map))
    return Drawing(target, lines, failed, surface)


def _or_none(build: Callable[..., Lines], *given: object) -> Lines:
    """Return build(*given), or no lines if an attribute of another add-on has one of our names. The list of wires
    reports this fault."""
    try:
        return build(*given)
    except ObjectError:
        return Lines({}, {}, [])


def _outlines(context: bpy.types.Context, source: bpy.types.Object, flat: bpy.types.Object) -> PatternParts | None:
    """Return the outlines of the pieces, with their allowances. The result is kept until model or pieces change."""
    scene, depsgraph = context.scene, context.view_layer.depsgraph
    made_of = stamp(flat), stamp(flat.data), Same(pieces_report(source)), source.name_full
    of_model = stamp(source), stamp(source.data), source.data.is_editmode
    units = meters_per_blender_unit(scene), scene.unit_settings.system
    build = partial(read_outlines, scene, source, flat, depsgraph)
    return kept_drawing(flat, "outlines", (*made_of, *of_model, *units), build, source)


def _cut_lines(
    context: bpy.types.Context,
    source: bpy.types.Object,
    flat: bpy.types.Object,
    pairs: bool = False,
    on_fold: bool = False,
) -> CutLines:
    """Return the cutting lines of the pieces. They are kept until outlines or settings change. pairs and on_fold: see
    PatternOptions."""
    settings, parts = context.scene.wirewarp, _outlines(context, source, flat)
    options = {
        "allowance": settings.allowance,
        "darts": (settings.darts or "CLOSE").lower(),
        "pairs": pairs,
        "on_fold": on_fold,
    }
    what = f"cut lines, {pairs=}, {on_fold=}"
    return kept_drawing(flat, what, (Same(parts), options), lambda: cut_lines(parts, **options))


def narrow_pieces(context: bpy.types.Context, source: bpy.types.Object, flat: bpy.types.Object) -> list[str]:
    """Return the names of the pieces without room for their allowances. The flat object must not be in Edit Mode."""
    parts, allowance = _outlines(context, source, flat), context.scene.wirewarp.allowance
    if parts is None:
        return []
    return kept_drawing(flat, "narrow pieces", (Same(parts), allowance), lambda: parts.narrow(allowance))


NO_PAIRS, NO_FOLDS = "No two pieces have the same shape.", "No piece is symmetric."


def shown_copies(context: bpy.types.Context, source: bpy.types.Object, flat: bpy.types.Object) -> list[str]:
    """Return sentences about pieces that are drawn once for all their copies, or as halves. The flat object must not be
    in Edit Mode."""
    settings = context.scene.wirewarp
    made = _cut_lines(context, source, flat, settings.pairs, settings.on_fold).made
    if made is None:
        return []
    missing = [NO_PAIRS] * settings.pairs + [NO_FOLDS] * settings.on_fold
    return copies_sentences(made) or missing


def piece_copies(context: bpy.types.Context, source: bpy.types.Object, flat: bpy.types.Object, name: str) -> str:
    """Return a sentence about the copies and the symmetry of a piece. The flat object must not be in Edit Mode."""
    parts, allowance = _outlines(context, source, flat), context.scene.wirewarp.allowance
    if parts is None:
        return ""
    # Places of pieces, and one allowance for all edges, do not change which pieces are equal, so made_of lacks them.
    marked = (allowance, parts.allowances) if any(parts.allowances) else ()
    made_of = Same(pieces_report(source)), [piece.name for piece in parts.pieces], marked
    darts = (context.scene.wirewarp.darts or "CLOSE").lower()
    build = partial(cut_lines, parts, allowance, darts=darts, pairs=True, on_fold=True)
    made = kept_drawing(flat, "copies", made_of, build).made
    return copies_of_piece(made, name) if made else ""


def shown_pages(context: bpy.types.Context, source: bpy.types.Object, flat: bpy.types.Object) -> PagePreview:
    """Return the preview of the pages of the flat object, which must not be in Edit Mode."""
    settings, millimeters = context.scene.wirewarp, 1000 * meters_per_blender_unit(context.scene)
    cut = _cut_lines(context, source, flat)
    drawn = _cut_lines(context, source, flat, settings.pairs, settings.on_fold)
    # A setting is "" if this version does not know its stored value (see reset_unknown).
    cloth = Cloth(settings.cloth_width, settings.gap, GRAINS[settings.grain or "ONE_WAY"])
    paper = library_paper(settings.paper or "A4", settings.roll_width)
    chosen = PageChoices(paper, settings.arrangement or "IN_ROWS", cloth, stored_text(source, MARKER))
    made_of = Same(cut), Same(drawn), chosen, millimeters
    return kept_drawing(flat, "pages", made_of, lambda: page_preview(cut, drawn, chosen, millimeters))


def _with_pages(lines: Lines | None, pages: PagePreview) -> Lines:
    lines = lines or Lines({}, {}, [])
    places = dict(lines.places)
    for kind, ends in pages.places.items():
        places[kind] = np.concatenate([places[kind], ends]) if kind in places else ends
    return replace(lines, places=places, names=lines.names + pages.names)


def _with_cut(lines: Lines | None, cut: CutLines | None, scene: bpy.types.Scene) -> Lines | None:
    if lines is None or cut is None:
        return lines
    places = cut_places(cut, 1000 * meters_per_blender_unit(scene))
    return replace(lines, places=lines.places | {"cut": places}) if len(places) else lines


@dataclass(frozen=True)
class UvDrawing:
    target: bpy.types.Object
    lines: Lines
    failures: Failures | None


def uv_drawings(context: bpy.types.Context) -> Iterator[UvDrawing]:
    """Yield the drawings for the UV editor. In Edit Mode, yield drawings of the models in Edit Mode. In Object Mode,
    yield drawings of the models that are selected or have selected pieces."""
    space = context.space_data
    if space.mode != "UV" or not space.overlay.show_overlays or not context.scene.wirewarp.show_lines:
        return
    for target in _targets(context):
        if target.type == "MESH" and shows_our_map(target.data):
            scale = metric(target).tobytes()
            made_of = stamp(target), stamp(target.data), target.data.is_editmode, Same(last_report(target)), scale
            lines = kept_drawing(target, "uv lines", made_of, partial(_or_none, uv_lines, target))
            failed = None
            if not target.data.is_editmode:
                of_cut = Same(suggestions_of(target))
                build = partial(lambda each: with_cut(failures(each, in_map=True), uv_suggested_lines(each)), target)
                failed = kept_drawing(target, "uv failures", (*made_of, of_cut), build)
            yield UvDrawing(target, lines, failed)


def _targets(context: bpy.types.Context) -> list[bpy.types.Object]:
    if context.mode == "EDIT_MESH":
        return list(context.objects_in_mode_unique_data)
    if context.mode != "OBJECT":
        return []
    return list(dict.fromkeys(model_or_self(each) for each in context.selected_objects))
