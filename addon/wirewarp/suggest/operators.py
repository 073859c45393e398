# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators Suggest Darts, Suggest Seams and Simplify Seams. They find cuts, or seams to clear, and the resulting
stretch. Two more operators choose and discard these suggestions.
"""

from dataclasses import dataclass, replace

import bpy
from bpy.props import EnumProperty, IntProperty

from ..blender.mesh import evaluated_mesh
from ..blender.objects import check_local, length_text, meters_per_blender_unit
from ..blender.selection import WORKING_MODES, in_object_mode
from ..blender.views import redraw_views
from ..core import ANY_LIMIT, paragraph, quoted
from ..flatten.models import Model
from ..flatten.read import active_target, check_sources, find_source, is_as_read, read_models
from ..issues import ObjectError, changed_error, object_error
from ..properties import reset_unknown
from ..solve.flatten import FlattenChoices, known_stretch, used_choices
from ..solve.report import ObjectReport
from ..solve.seam_sets import fewer_seams, first_sets, limits_up_to, with_measures, within_fabric
from ..solve.steps import CanceledError, Steps
from ..solve.suggest import (
    Cut,
    NoSeam,
    SearchOptions,
    cut_text,
    found_words,
    set_for,
    shortfall,
    step_text,
    suggest_cuts,
)
from ..state.changes import has_changed
from ..state.memory import read_anew
from ..state.owners import model_or_self
from ..state.read_model import check_modifiers, shaped_by
from ..state.reports import last_report, pieces_report
from ..state.settings import FlattenSettings, TargetSettings, choices_of, target_of
from ..state.suggestions import Place, Suggestions, are_current, choose, drop, keep, read_no_seam
from ..ui import window_run
from ..ui.editing import OnMesh, reporting_refusals
from ..ui.window_run import WindowSteps, fault_sentence

STOPPED = "Canceled early"
CHOOSE_FABRIC = "Choose a fabric that stretches more."
SET_TARGET = "Set a larger target."
# Maximum stretches, as fractions, if the fabric is unknown:
# - 0.2 is for plush and knits, from which most closed models are sewn.
# - 0.5 is for jersey, the softest fabric that is not made for swimming.
SOFT = 0.2, 0.5


@dataclass(frozen=True)
class Search:
    options: SearchOptions
    model: Model
    choices: FlattenChoices
    no_seam: NoSeam  # painted areas of the model's own mesh
    with_modifiers: bool  # whether the search uses the mesh with modifiers, which differs from the base mesh
    steps: Steps[list[Cut]]
    names: dict[int, str]  # known names of pieces, by index

    @property
    def is_of_model(self) -> bool:
        """Return whether the cuts may be in several pieces. Such cuts are listed under the model's name."""
        return self.options.kind == "FEWER" or (self.options.target is not None and self.options.piece is None)


def begin_search(context: bpy.types.Context, source: bpy.types.Object, kind: str, piece: int | None) -> Search:
    """Return the search for this model. kind: DARTS, SEAMS or FEWER; piece: index in the report of the flat pieces,
    None for any piece. Raises ObjectError if nothing can be searched."""
    settings = context.scene.wirewarp
    check_local(source, source.data)
    (model,) = read_models(context, [source], settings)
    if model.issue:
        raise ObjectError(model.issue)
    depsgraph = context.evaluated_depsgraph_get()
    is_shaped = settings.use_modifiers and bool(shaped_by(source, depsgraph))
    # Even modifiers that keep the shape may split edges, so that the search uses other vertices than the base mesh has.
    is_split = len(model.arrays.vertices) != len(source.data.vertices)
    if is_shaped or is_split:
        check_modifiers(source)
    known = _known_report(source, piece, with_modifiers=settings.use_modifiers)
    pieces = known.pieces if known else []
    choices = choices_of(settings, meters_per_blender_unit(context.scene))
    own = no_seam = read_no_seam(source)
    if is_shaped or is_split:
        with evaluated_mesh(source, depsgraph) as mesh:
            no_seam = read_no_seam(source, mesh)
    target, used = target_of(settings), used_choices(choices, model.arrays)
    is_smooth = settings.dart_lines == "SMOOTH" and target is None
    names = {each.piece_id: each.name for each in pieces if each.piece_id}
    limits = known_stretch(used.cloth)
    is_for_sets = known is None or _lacks_seams(known, piece)
    # The library's default is for soft fabrics. Only a smaller maximum stretch replaces the default: with the larger
    # limit of swim knit, a ball would become two pieces that need a stretch of 71%.
    strain = limits[0] if limits and limits[0] < SOFT[0] and is_for_sets else None
    options = SearchOptions(kind, piece, target, strain, is_smooth, names)
    if kind == "FEWER":
        accepted, remedy = ([target.strain], SET_TARGET) if target else (limits_up_to(limits), CHOOSE_FABRIC)
        steps = fewer_seams(model.arrays, choices, accepted, remedy)
        options = replace(options, target=None)  # the sets are alternatives, not steps
    elif kind == "SEAMS" and is_for_sets and limits and target is None:
        steps = first_sets(model.arrays, choices, options, no_seam)
    else:
        steps = suggest_cuts(model.arrays, choices, options, no_seam)
    if options.target is None:
        steps = with_measures(steps, model.arrays, choices, limits or SOFT)
    if kind == "FEWER" and limits and not target:
        steps = within_fabric(steps, limits, CHOOSE_FABRIC)
    return Search(options, model, used, own, is_shaped or is_split, steps, {each.index: each.name for each in pieces})


def _known_report(source: bpy.types.Object, piece: int | None, *, with_modifiers: bool) -> ObjectReport | None:
    """Return the report of the present model; None if there is none. Raises ObjectError if a piece is to be cut, but
    its report is missing, or of an earlier model, or of the model with other modifiers."""
    report = pieces_report(source)
    if report and report.with_modifiers == with_modifiers and not has_changed(source, report.model_state):
        return report
    if piece is not None:
        raise changed_error(source.name)
    # Without current flat pieces, as for a closed model, the last report is used.
    report = last_report(source)
    return report if report and not has_changed(source, report.model_state) else None


def _lacks_seams(report: ObjectReport, piece: int | None) -> bool:
    """Return whether a piece has no usable flat shape, so that the search is for cut sets. Usable pieces get single
    cuts, even if their fabric stretches far enough."""
    pieces = report.pieces if piece is None else report.pieces[piece : piece + 1]
    return not pieces or any(not each.ok or each.needed > ANY_LIMIT for each in pieces)


def _names_of(search: Search, cuts: list[Cut]) -> list[str]:
    if search.is_of_model:
        return [search.model.facts.object] * len(cuts)
    return [search.names.get(cut.piece, f"Piece {cut.piece + 1}") for cut in cuts]


def _shown_first(search: Search, cuts: list[Cut]) -> int:
    """Return the index of the cut to show first: the last cut if there is a target, the set for the fabric if the cuts
    are sets, otherwise the best cut."""
    if search.options.target:
        return len(cuts) - 1
    if not cuts[0].is_set:
        return 0
    return set_for(cuts, known_stretch(search.choices.cloth) or SOFT)


def keep_found(search: Search, cuts: list[Cut], place: Place = "FLATTEN") -> Suggestions:
    """Keep the cuts for the panel and the overlay. This works in any mode. Raises ObjectError if the model has changed
    during the search."""
    model = search.model
    wire_ids = {wire.chain.wire_id for wire in model.arrays.wires}
    found = Suggestions(
        search.options.kind,
        cuts,
        search.options.target,
        _names_of(search, cuts),
        search.choices,
        model.arrays.grain_wire,
        wire_ids,
        model.state,
        search.no_seam,
        chosen=_shown_first(search, cuts),
        with_modifiers=search.with_modifiers,
        place=place,
        other_pieces=max(len(search.names) - 1, 0),
    )
    source = find_source(model)
    if not (is_as_read(model) and are_current(source, found, read_anew)):
        raise object_error("changed", f'"{model.facts.object}" changed during the search. Search again.')
    keep(source, found)
    return found


class SuggestCuts(OnMesh, WindowSteps):
    """Mixin of operators that search. They write nothing: the panel shows the cuts until the model changes."""

    bl_options = {"REGISTER"}
    modes = WORKING_MODES
    refusal = "Select a mesh, in Object Mode or in Edit Mode"
    kind = ""  # "DARTS", "SEAMS" or "FEWER"

    place: EnumProperty(
        name="Place",
        description="Panel that lists the suggestions",
        items=[("FLATTEN", "Flatten", "The panel Flatten"), ("PIECES", "Pieces", "The panel Pieces")],
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def invoke(self, context: bpy.types.Context, _event: bpy.types.Event) -> set[str]:
        return self.execute(context) if bpy.app.background else self._begin(context)

    @reporting_refusals
    def _begin(self, context: bpy.types.Context) -> set[str]:
        self._read(context)
        return self.begin(context, window_run.SUGGEST, self._search.model.facts.object, self._search.steps)

    @reporting_refusals
    def execute(self, context: bpy.types.Context) -> set[str]:
        """Search in a script, while Blender waits."""
        self._read(context)
        return self._keep(context, self.wait_for(context, self._search.steps))

    @reporting_refusals
    def finish_run(self, context: bpy.types.Context) -> set[str]:
        try:
            return self._keep(context, self._run.result(), STOPPED if self._run.was_stopped else "")
        except CanceledError:
            self.report({"WARNING"}, "The search was canceled.")
        except ObjectError:
            raise
        except Exception as error:
            self.report({"ERROR"}, fault_sentence(error, "The search failed and suggests nothing"))
        return {"CANCELLED"}

    def _read(self, context: bpy.types.Context) -> None:
        """Read the model for the search. Raises ObjectError if there is nothing to search."""
        check_sources(context, active_target(context))
        source = model_or_self(context.active_object)
        for settings in (FlattenSettings, TargetSettings):
            reset_unknown(context.scene.wirewarp, settings)
        with in_object_mode(context):
            self._search: Search = begin_search(context, source, self.kind, self._piece())

    def _piece(self) -> int | None:
        """Return the index of the piece to cut; None for any piece."""
        return None

    def _keep(self, context: bpy.types.Context, cuts: list[Cut], remark: str = "") -> set[str]:
        """Keep the cuts and report them. Raises ObjectError like keep_found.

        This must work in any mode, because leaving Edit Mode while a tool runs would crash Blender.
        remark: text before the figures
        """
        found = keep_found(self._search, cuts, self.place)
        redraw_views()
        lengths, name = length_text(context.scene), found.names[0]
        is_named = cuts[0].piece in self._search.names or self._search.is_of_model
        piece = quoted([name]) if is_named else name  # last in the texts, because the status bar cuts long texts off
        if found.target:
            step = step_text(self.kind, cuts[-1], lengths)
            said = [f"Stretch with {step}, for {piece}", shortfall(self.kind, cuts, found.target)]
        elif cuts[0].is_set:
            said = [found_words(cuts), f"Chosen: {cut_text(cuts[found.chosen], lengths)}"]
        else:
            said = [found_words(cuts), f"Best: {cut_text(cuts[0], lengths)}, for {piece}"]
        self.report({"INFO"}, paragraph(each for each in [remark, *said] if each))
        return {"FINISHED"}


class SuggestForPiece(SuggestCuts):
    piece: IntProperty(
        name="Piece",
        description="Index of the piece in the report, from 0, or -1 for the piece that gains most from a cut",
        default=-1,
        min=-1,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    def _piece(self) -> int | None:
        return None if self.piece == -1 else self.piece


class OBJECT_OT_wirewarp_suggest_darts(SuggestForPiece, bpy.types.Operator):
    """Find the darts that lower the stretch of this piece most"""

    bl_idname = "object.wirewarp_suggest_darts"
    bl_label = "Suggest Darts"
    kind = "DARTS"


class OBJECT_OT_wirewarp_suggest_seams(SuggestForPiece, bpy.types.Operator):
    """Find the seams that lower the stretch of this piece most, or the first seams of a closed model"""

    bl_idname = "object.wirewarp_suggest_seams"
    bl_label = "Suggest Seams"
    kind = "SEAMS"


class OBJECT_OT_wirewarp_simplify_seams(SuggestCuts, bpy.types.Operator):
    """Find the seams that this model does not need, so that it has fewer and larger pieces"""

    bl_idname = "object.wirewarp_simplify_seams"
    bl_label = "Simplify Seams"
    kind = "FEWER"


class OBJECT_OT_wirewarp_choose_suggestion(OnMesh, bpy.types.Operator):
    """Show this suggestion on the model and on its flat pieces"""

    bl_idname = "object.wirewarp_choose_suggestion"
    bl_label = "Show Suggestion"
    bl_options = {"INTERNAL"}

    index: IntProperty(name="Index", description="Index in the list, from 0", min=0)

    def execute(self, context: bpy.types.Context) -> set[str]:
        choose(model_or_self(context.active_object), self.index)
        redraw_views()
        return {"FINISHED"}


class OBJECT_OT_wirewarp_drop_suggestions(OnMesh, bpy.types.Operator):
    """Discard these suggestions"""

    bl_idname = "object.wirewarp_drop_suggestions"
    bl_label = "Discard Suggestions"
    bl_options = {"INTERNAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        drop(model_or_self(context.active_object))
        redraw_views()
        return {"FINISHED"}
