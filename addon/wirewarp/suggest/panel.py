# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the buttons that suggest darts and seams, and the list of suggestions. The views show the chosen suggestion."""

from collections.abc import Sequence
from itertools import pairwise

import bpy

from ..blender.objects import length_text
from ..core import counted, set_beyond_fabric
from ..solve.flatten import known_stretch
from ..solve.report import MOST_SEWN
from ..solve.suggest import Cut, row_text, shortfall
from ..state.drawings import Same, kept_drawing
from ..state.memory import stamp
from ..state.settings import TargetSettings
from ..state.suggestions import Place, Suggestions, current_suggestions, suggestions_of
from ..ui.layout import draw_progress, draw_sentence
from ..ui.settings import figures_sentence, shown_source
from ..ui.window_run import SUGGEST, is_running

KINDS = ("darts", "seams")
LABELS = {"DARTS": "Suggested Darts", "SEAMS": "Suggested Seams", "FEWER": "Fewer Seams"}
TARGET_LABELS = {"DARTS": "Stretch with Darts", "SEAMS": "Stretch with Seams"}
COLUMNS = "Pieces, stretch, length of {}."
FROM_FEW = "Above: fewer pieces. Below: less stretch."
ALL_PIECES = "All Pieces up to a Target"
WIDTH = "Narrowest place of a piece: {}."
NARROW = "A piece is only {} wide in one place, less than two allowances. It may be too narrow to sew."
MANY = "With these seams, the model has {} pieces, too many to sew. Simplify the model before you suggest seams."
UNMEASURED = "The search was canceled before it compared this set with the fabric."
LESS_STRETCH = "Click a row with less stretch."
MORE_CUTS = "Choose a fabric that stretches more, or mark this set and then add darts."
SMALLER_TARGET = "Choose a fabric that stretches more, or enter a smaller Max Stretch and search again."
EARLIER = "These suggestions are from an earlier search. Another search is running."
TARGET = ("aim_stretch", "aim_cuts", "aim_length")


def draw_suggest(
    layout: bpy.types.UILayout,
    settings: TargetSettings,
    place: Place,
    piece: int,
    kinds: Sequence[str] = KINDS,
    *,
    has_seams: bool,
) -> None:
    """Draw the buttons and the target. During a search, the progress replaces the buttons.

    - place: panel that shows the suggestions; in the panel FLATTEN, a target applies to all pieces
    - piece: index in the report, -1 for any piece
    """
    row, options, is_of_all = layout.row(align=True), layout.column(), place == "FLATTEN"
    options.enabled = not draw_progress(row, SUGGEST, "object.wirewarp_suggest_darts")
    for kind in kinds if options.enabled else ():
        button = row.operator(f"object.wirewarp_suggest_{kind}")
        button.place, button.piece = place, -1 if is_of_all and settings.suggest_together else piece
    row = options.row(align=True)
    row.enabled = not settings.suggest_together
    row.prop(settings, "dart_lines", expand=True)
    options.prop(settings, "suggest_together", **({"text": ALL_PIECES} if is_of_all else {}))
    if settings.suggest_together:
        column = options.column(align=True)
        for name in TARGET:
            column.prop(settings, name)
    if has_seams:
        options.operator("object.wirewarp_simplify_seams").place = place


def draw_simplify(layout: bpy.types.UILayout, settings: TargetSettings, place: Place) -> None:
    """Draw the button Simplify Seams and its target, like draw_suggest, for a piece that needs no cut."""
    row, options = layout.row(align=True), layout.column()
    options.enabled = not draw_progress(row, SUGGEST, "object.wirewarp_simplify_seams")
    if options.enabled:
        row.operator("object.wirewarp_simplify_seams").place = place
    if settings.suggest_together:
        options.prop(settings, "suggest_together")
        options.prop(settings, "aim_stretch")


def draw_suggestions(context: bpy.types.Context, layout: bpy.types.UILayout, place: Place) -> None:
    """Draw the list of suggestions below the buttons of this place, if the search was started there.

    A list above the buttons, or in its own panel, would move the buttons away from the mouse.
    """
    found = _shown(context)
    if found is None or found.place != place:
        return
    if is_running(SUGGEST):  # the rows are gray; they can be used again if the search ends without a result
        draw_sentence(context, layout, EARLIER, "INFO")
        layout = layout.column()
        layout.enabled = False
    cut = found.cuts[found.chosen]
    # The buttons are above the rows and the sentences. Below them, the buttons would move when another row is chosen.
    take = layout.row(align=True)
    take.scale_y = 1.2
    text = "Clear and Flatten" if cut.cleared else "Mark and Flatten"
    take.operator("object.wirewarp_mend", text=text, icon="EDGESEL").what = "SUGGESTION"
    take.operator("object.wirewarp_drop_suggestions", text="", icon="X")
    _draw_rows(context, layout.column(align=True), found)
    for sentence, icon in _remarks(context, found):
        draw_sentence(context, layout, sentence, icon)


def _draw_rows(context: bpy.types.Context, column: bpy.types.UILayout, found: Suggestions) -> None:
    lengths, labels = length_text(context.scene), TARGET_LABELS if found.target else LABELS
    for name in dict.fromkeys(found.names):
        draw_sentence(context, column, f"{labels[found.kind]}, {name}")
        for index in (index for index, own in enumerate(found.names) if own == name):
            row, is_chosen = found.cuts[index], index <= found.chosen if found.target else index == found.chosen
            text = row_text(found.kind, row, found.target, lengths)
            icon = "ERROR" if row.is_narrow else "NONE"
            button = column.operator("object.wirewarp_choose_suggestion", text=text, depress=is_chosen, icon=icon)
            button.index = index


def _remarks(context: bpy.types.Context, found: Suggestions) -> list[tuple[str, str]]:
    """Return the sentences about the chosen cut, each with its icon."""
    cut = found.cuts[found.chosen]
    width = "" if cut.width is None else length_text(context.scene).rough(cut.width)
    count = found.pieces_after(cut) if cut.is_set else 0
    taking = "Clearing these seams" if cut.cleared else "Marking it"
    remarks = [
        ((NARROW if cut.is_narrow else WIDTH).format(width) if width else "", "ERROR" if cut.is_narrow else "INFO"),
        (MANY.format(count) if count > MOST_SEWN else "", "AMBER"),
        (_beyond_fabric(found), "AMBER"),
        (_explained(found.cuts), "INFO"),
        (shortfall(found.kind, found.cuts, found.target) if found.target else "", "INFO"),
        (figures_sentence(shown_source(context), found, context.scene.wirewarp), "INFO"),
        (_added(cut), "INFO"),
        (f"{taking} applies the modifiers of the model." if found.with_modifiers else "", "INFO"),
    ]
    return [(sentence, icon) for sentence, icon in remarks if sentence]


def _added(cut: Cut) -> str:
    """Return a sentence about the elements that marking the cut adds to the model; empty if it adds none."""
    if cut.paths and not cut.edges:
        return "Marking it adds vertices and edges where it crosses faces."
    new = len(cut.diagonals)
    return f"Marking it adds {counted(new, 'edge')} across faces of the model." if new else ""


def _beyond_fabric(found: Suggestions) -> str:
    """Return sentences that say why the fabric may not suffice for the chosen set, and what to do; empty if it
    suffices."""
    cut, limits = found.cuts[found.chosen], known_stretch(found.choices.cloth)
    if not (cut.is_set and limits):
        return ""
    if cut.threads is None:
        return UNMEASURED
    if cut.excess(limits) <= 0:
        return ""
    if any(each.threads and each.excess(limits) <= 0 for each in found.cuts):
        remedy = LESS_STRETCH
    else:
        # Without a target, Simplify Seams clears no seam that the fabric needs. If the fabric does not suffice for a
        # set of cleared seams, the target was therefore too large.
        remedy = SMALLER_TARGET if cut.cleared else MORE_CUTS
    return f"{set_beyond_fabric(cut.threads)} {remedy}"


def _explained(cuts: Sequence[Cut]) -> str:
    """Return sentences that explain the rows of cut sets; empty for other cuts."""
    if not cuts[0].is_set:
        return ""
    columns = COLUMNS.format("cleared seams" if cuts[0].cleared else "seams")
    # FROM_FEW is untrue if a row with narrow pieces has more stretch than the row above.
    is_falling = all(few.strain > more.strain for few, more in pairwise(cuts))
    return f"{columns} {FROM_FEW}" if len(cuts) > 1 and is_falling else columns


def are_shown(context: bpy.types.Context) -> bool:
    return _shown(context) is not None


def _shown(context: bpy.types.Context) -> Suggestions | None:
    """Return the suggestions for the active model, or for the model of active flat pieces; None if there are none, or
    if the model has changed."""
    source = shown_source(context)
    found = suggestions_of(source) if source else None
    if found is None:
        return None
    seen = stamp(source), stamp(source.data), source.mode, source.matrix_world.copy(), Same(found)
    return kept_drawing(source, "suggestions", seen, lambda: current_suggestions(source))
