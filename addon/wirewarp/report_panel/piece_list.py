# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the list of flat pieces, the worst first, and figures of the chosen piece below the list."""

import bpy

from .. import core
from ..blender.objects import length_text
from ..core import needs_text, percent_text
from ..overlay.shown import piece_copies
from ..solve.report import ObjectReport
from ..state.owners import find_flat_object
from ..state.reports import pieces_report
from ..suggest.panel import draw_simplify, draw_suggest, draw_suggestions
from ..ui.layout import SidebarPanel, draw_cells, draw_sentence, is_wide, mark_of
from ..ui.settings import settings_sentence, shown_report, shown_source, untrue_sentence
from .flatten_panel import narrow_names, offered_piece
from .panel import draw_select

NO_STRAIN = 5e-4  # smaller values are shown as 0.0%
MOST_ROWS = 16  # a longer list has a scroll bar in the place of the buttons that select a piece
MOST_LETTERS = 12  # letters of a name for which there is room beside a button in a sidebar of the default width
NAMES, SHORT_NAMES = 0.78, 0.7  # share of a row for the name, beside "8.6%" and beside ">100%"
SELECT = "Select Piece"
WORTH_A_CUT = 0.005  # smallest stretch for which the library suggests cuts


class WIREWARP_UL_pieces(bpy.types.UIList):
    """List of flat pieces, in which the worst piece is shown first. Its entries have the order of the report"""

    def draw_item(
        self,
        context: bpy.types.Context,
        layout: bpy.types.UILayout,
        source: bpy.types.Object,
        entry: bpy.types.PropertyGroup,
        _icon: int,
        _active_source: bpy.types.Object,
        _active_name: str,
        index: int,
    ) -> None:
        line, row = layout.row(align=True), _row_of(context, index)
        if row is None:
            line.prop(entry, "name", text="", emboss=False, icon="BLANK1")
            return
        is_long = any(each.has_layout and each.shown >= 1 for each in report_of_pieces(context).tables.pieces)
        columns = line.split(factor=SHORT_NAMES if is_long else NAMES)
        mark = {"icon": "BLANK1"}
        if _has_true_verdict(context):
            narrow = narrow_names(context, shown_source(context), report_of_pieces(context))
            mark = mark_of(row.ok, row.is_strained or row.name in narrow)
        columns.prop(entry, "name", text="", emboss=False, **mark)
        if row.has_layout:
            figure = columns.row()
            figure.alignment = "RIGHT"
            # A longer text would not fit the column.
            figure.label(text=percent_text(row.shown) if row.shown < 1 else ">100%")
            if _have_buttons(context, source):
                draw_select(line, "PIECE", index)

    def filter_items(
        self, context: bpy.types.Context, source: bpy.types.Object, entries_name: str
    ) -> tuple[list[int], list[int]]:
        """Return a flag for each entry to show (empty: all entries), and the place of each entry in the list."""
        entries, helper = getattr(source, entries_name), bpy.types.UI_UL_list
        shown = []
        if self.filter_name:
            shown = helper.filter_items_by_name(self.filter_name, self.bitflag_filter_item, entries, "name")
        if self.use_filter_sort_alpha:
            return shown, helper.sort_items_by_name(entries, "name")
        places = {row.index: place for place, row in enumerate(report_of_pieces(context).tables.pieces)}
        if places.keys() != set(range(len(entries))):
            return shown, []
        return shown, [places[index] for index in range(len(entries))]


def _have_buttons(context: bpy.types.Context, source: bpy.types.Object) -> bool:
    """Return whether each row has a button that selects its piece. Otherwise, one button is below the list."""
    pieces = source.wirewarp_pieces
    longest = max((len(entry.name) for entry in pieces), default=0)
    return len(pieces) <= MOST_ROWS and (is_wide(context) or longest <= MOST_LETTERS)


def report_of_pieces(context: bpy.types.Context) -> ObjectReport | None:
    """Return the report of the existing pieces, even if a later run failed."""
    source = shown_source(context)
    return pieces_report(source) if source else None


def _row_of(context: bpy.types.Context, index: int) -> core.report.Piece | None:
    """Return the piece with this index in the report; None if the report does not have it."""
    return next((row for row in report_of_pieces(context).tables.pieces if row.index == index), None)


def _has_true_verdict(context: bpy.types.Context) -> bool:
    """Return whether the panel Flatten shows the verdict on these pieces, and nothing has changed since the run."""
    source, report = shown_source(context), report_of_pieces(context)
    if report is not shown_report(context) or untrue_sentence(context.active_object, source, report):
        return False
    return not settings_sentence(source, report, context.scene.wirewarp)


class VIEW3D_PT_wirewarp_pieces(SidebarPanel, bpy.types.Panel):
    bl_label = "Pieces"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        report = report_of_pieces(context)
        return report is not None and report.flat_object is not None and len(shown_source(context).wirewarp_pieces) > 0

    def draw(self, context: bpy.types.Context) -> None:
        source = shown_source(context)
        rows = min(len(source.wirewarp_pieces), MOST_ROWS)
        self.layout.template_list(
            "WIREWARP_UL_pieces", "", source, "wirewarp_pieces", source, "wirewarp_active_piece", rows=rows
        )
        chosen = _row_of(context, source.wirewarp_active_piece)
        if chosen and chosen.has_layout and not _have_buttons(context, source):
            button = self.layout.operator("mesh.wirewarp_select_result", text=SELECT, icon="RESTRICT_SELECT_OFF")
            button.what, button.index = "PIECE", chosen.index
        if chosen:  # buttons above the figures, so that the suggestions below the buttons stay in view
            report = shown_report(context)
            # This is the piece for which the panel Flatten has the buttons Suggest Darts and Suggest Seams.
            offered = offered_piece(context, source, report) if report else None
            has_seams = bool(report and report.seams)
            if chosen.ok and chosen.needed >= WORTH_A_CUT and offered != chosen.index:
                draw_suggest(self.layout, context.scene.wirewarp, "PIECES", chosen.index, has_seams=has_seams)
            elif has_seams and offered is None:
                draw_simplify(self.layout, context.scene.wirewarp, "PIECES")
        draw_suggestions(context, self.layout, "PIECES")
        if chosen:
            draw_copies(context, self.layout, source, source.wirewarp_pieces[chosen.index].name)
            draw_figures(context, self.layout, chosen)
        if context.scene.wirewarp.keep_places:
            button = self.layout.operator("object.wirewarp_flatten", text="Lay Out Again", icon="MOD_ARRAY")
            button.keep_places, button.only_active = False, True


def draw_figures(context: bpy.types.Context, layout: bpy.types.UILayout, row: core.report.Piece) -> None:
    text, column = length_text(context.scene), layout.column(align=True)
    draw_cells(column, "Area, model", [text.area(row.area_3d)], 0.45)
    if not row.has_layout:
        draw_cells(column, "Area, flat", ["not laid flat"], 0.45)
        return
    draw_cells(column, "Area, flat", [text.area(row.area_2d)], 0.45)
    change = row.area_2d / row.area_3d - 1
    draw_cells(column, "Difference", [f"{100 * change:+.2f}%" if abs(change) >= 5e-5 else "0.00%"], 0.45)
    if row.threads:
        draw_sentence(context, column, f"{needs_text(row.threads)}, in {row.threads.cloth}")
    elif row.needed < NO_STRAIN:
        draw_sentence(context, column, "Unfolds without any stretch")
    if row.needed >= NO_STRAIN:
        line = column.row(align=True)
        draw_cells(line, "Stretch", [percent_text(row.shown)], 0.5)
        # A stretch of None is infinite.
        is_stretched = row.stretch_max is None or (row.ease_max is not None and row.stretch_max >= row.ease_max)
        draw_select(line, "STRETCH" if is_stretched else "EASE", row.index)


def draw_copies(context: bpy.types.Context, layout: bpy.types.UILayout, source: bpy.types.Object, name: str) -> None:
    """Draw a sentence about the copies of this piece and its symmetry, which Equal Pieces and On the Fold use."""
    flat = find_flat_object(source)
    if flat is None or flat.data.is_editmode:
        return
    if sentence := piece_copies(context, source, flat, name):
        draw_sentence(context, layout, sentence)
