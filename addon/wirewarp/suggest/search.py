# SPDX-License-Identifier: GPL-3.0-or-later
"""From a model in Object Mode to the cuts that are suggested for it."""

from dataclasses import dataclass

import bpy

from .. import core
from ..blender.objects import check_local
from ..blender.units import meters_per_blender_unit
from ..flatten.models import Model
from ..flatten.read import find_source, is_current, read_models
from ..issues import ObjectError, changed_error, object_error
from ..solve.flatten import FlattenChoices, used_choices
from ..solve.steps import Steps
from ..solve.suggest import Cut, NoSeam, Target, suggest_cuts
from ..state.changes import has_changed
from ..state.memory import read_anew
from ..state.modifiers import shaped_by
from ..state.reports import pieces_report
from ..state.settings import choices_of, target_of
from ..state.suggestions import Suggestions, are_current, keep, read_no_seam

WITH_MODIFIERS = (
    "Suggested cuts are edges of the model itself: apply what changes its shape ({}), or flatten without Modifiers."
)


@dataclass(frozen=True)
class Search:
    """Under way for one model, as it was read."""

    kind: str  # DARTS or SEAMS
    piece: int | None  # as asked for
    target: Target | None
    model: Model
    choices: FlattenChoices
    no_seam: NoSeam
    steps: Steps[list[Cut]]
    names: dict[int, str]  # of pieces, where they are known

    @property
    def is_of_model(self) -> bool:
        """Cuts that are taken together, of any piece: they may be of several, which they number anew."""
        return self.target is not None and self.piece is None


def begin_search(context: bpy.types.Context, source: bpy.types.Object, kind: str, piece: int | None) -> Search:
    """piece: as in the report of the flat pieces; None for any. Raises ObjectError."""
    settings = context.scene.wirewarp
    check_local(source, source.data)
    (model,) = read_models(context, [source], settings)
    if model.issue:
        raise ObjectError(model.issue)
    makers = shaped_by(source, context.evaluated_depsgraph_get()) if settings.use_modifiers else []
    if not makers and len(model.arrays.vertices) != len(source.data.vertices):
        makers = ["modifiers"]  # that split edges and leave the shape as it is
    if makers:
        raise object_error("with_modifiers", WITH_MODIFIERS.format(" and ".join(makers)))
    report = pieces_report(source)
    is_true = (
        report is not None
        and report.with_modifiers == settings.use_modifiers
        and not has_changed(source, report.model_state)
    )
    if piece is not None and not is_true:
        raise changed_error(source.name)
    names = {piece.index: piece.name for piece in report.pieces} if is_true else {}
    choices = choices_of(settings, meters_per_blender_unit(context.scene))
    no_seam, target = read_no_seam(source), target_of(settings)
    steps = suggest_cuts(core.library(), model.arrays, choices, kind, piece, no_seam, target)
    return Search(kind, piece, target, model, used_choices(choices, model.arrays), no_seam, steps, names)


def _names_of(search: Search, cuts: list[Cut]) -> list[str]:
    """Of what each of them cuts."""
    if search.is_of_model:
        return [search.model.facts.object] * len(cuts)
    return [search.names.get(cut.piece, f"Piece {cut.piece + 1}") for cut in cuts]


def keep_found(search: Search, cuts: list[Cut]) -> Suggestions:
    """For the panel and the overlay. Raises ObjectError if the model is no longer as it was read. In any mode."""
    model = search.model
    wire_ids = {wire.chain.wire_id for wire in model.arrays.wires}
    found = Suggestions(
        search.kind,
        cuts,
        search.target,
        _names_of(search, cuts),
        search.choices,
        model.arrays.grain_wire,
        wire_ids,
        model.state,
        search.no_seam,
        chosen=len(cuts) - 1 if search.target else 0,
    )
    source = find_source(model)
    if not (is_current(model) and are_current(source, found, read_anew)):
        raise object_error("changed", f'"{model.facts.object}" changed during the search. Suggest again.')
    keep(source, found)
    return found
