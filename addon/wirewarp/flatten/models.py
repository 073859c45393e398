# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens models that were read earlier, without using Blender."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from functools import partial

import numpy as np

from ..core import ANY_LIMIT, Cache, FlattenResult, Issue, Note, torn_hints
from ..issues import ObjectError
from ..solve.arrays import INWARD, MeshArrays, faces_inward, new_seams
from ..solve.flat_mesh import FlatMesh, flat_mesh
from ..solve.flatten import FlattenChoices, flatten_arrays, has_layout, used_choices
from ..solve.identity import (
    KnownPieces,
    KnownSeams,
    PieceIdentity,
    SeamIdentity,
    identify_pieces,
    identify_seams,
    ids_by_edge,
)
from ..solve.report import Facts, ObjectReport, UvSeams, failure_report, object_report, uv_seams
from ..solve.steps import CanceledError, Steps, of_all, reported_as

MIDDLE = "Lengths on the model are measured in the middle of the material's thickness."
NO_ANGLE = "Grain Angle was not used. Choose Grain Wire under Upright, and mark a grain wire."


@dataclass(frozen=True)
class Model:
    """The data read from an object. The model has the object's name instead of the object, which may be deleted during
    the run."""

    name: str  # Object.name_full, which includes the name of its library
    facts: Facts
    state: dict | None  # see state.changes.model_state; None if it could not be read
    notes: list[Note]
    arrays: MeshArrays | None = None
    known: KnownPieces | None = None
    seams: KnownSeams | None = None
    solved: Cache | None = None  # pieces of the last run
    solved_by_map: Cache | None = None  # pieces of the last attempt with UV seams
    issue: Issue | None = None  # why the model cannot be flattened


@dataclass
class Outcome:
    """The result of flattening one model, which may be only a report."""

    model: Model
    report: ObjectReport
    result: FlattenResult | None = None
    identities: Sequence[PieceIdentity] = ()
    seams: Sequence[SeamIdentity] = ()
    arrays: MeshArrays | None = None  # the model, with the present ids of its seams
    pieces: FlatMesh | None = None  # None if there is no layout
    is_elsewhere: bool = False  # whether some pieces are in new places, or the layout is much larger than before


def solve_models(
    models: list[Model], choices: FlattenChoices, meters: float, *, tries_uv_seams: bool = True
) -> Steps[list[Outcome]]:
    """Flatten every model. If the user cancels the attempt with UV seams, keep the results with the marked seams.

    meters: meters in a Blender unit
    tries_uv_seams: whether to try UV seams, too
    """
    outcomes: list[Outcome] = []
    # Models with modifiers are left out, because edges that modifiers create cannot be marked.
    readable = [model for model in models if tries_uv_seams and model.arrays and not model.facts.with_modifiers]
    with_map = [model for model in readable if len(new_seams(model.arrays))]
    count = len(models) + len(with_map)
    for number, model in enumerate(models):
        solving = _solve(model, choices, meters)
        outcomes.append((yield from reported_as(solving, partial(of_all, number, count))))
    with suppress(CanceledError):
        for number, model in enumerate(with_map, start=len(models)):
            report = outcomes[models.index(model)].report
            trying = _try_uv_seams(model, choices, meters, report)
            report.uv_seams = yield from reported_as(trying, partial(of_all, number, count))
    return outcomes


def failed_report(model: Model, issue: Issue) -> ObjectReport:
    return replace(failure_report(issue, model.facts), model_state=model.state)


def _solve(model: Model, choices: FlattenChoices, meters: float) -> Steps[Outcome]:
    try:
        if model.issue:
            raise ObjectError(model.issue)
        result = yield from flatten_arrays(model.arrays, choices, model.solved)
        yield 1.0  # the rest of the work is one step
    except ObjectError as error:
        outcome = Outcome(model, failed_report(model, error.issue))
    else:
        outcome = _outcome(model, result, choices, meters)
    if model.arrays:  # the options include the grain wire, which is known only if the model was read
        used = used_choices(choices, model.arrays)
        if choices.thickness > 0 and choices.surface != "middle":
            outcome.report.notes.append(Note(MIDDLE))
        if choices.grain_angle and used.orientation != "grain":
            outcome.report.notes.append(Note(NO_ANGLE))
        outcome.report.options = asdict(used) | {"grain_wire": model.arrays.grain_wire}
    outcome.report.notes += model.notes
    # If normals point inward, the pieces show the inside. With the option mirror, they show the outside, and no note is
    # needed.
    if model.arrays and not choices.mirror and faces_inward(model.arrays):
        outcome.report.notes.append(Note(INWARD, is_warning=True))
    if model.arrays:
        outcome.report.hints += torn_hints(model.arrays.vertices, model.arrays.outline)
    return outcome


def _try_uv_seams(model: Model, choices: FlattenChoices, meters: float, report: ObjectReport) -> Steps[UvSeams | None]:
    """Return the result with the seams of the model's own UV map; None if no such result is needed, or it is not better
    than the result with the marked seams."""
    arrays = model.arrays
    is_strained = not len(arrays.seams) and any(piece.is_strained for piece in report.pieces)
    if not (report.issues or is_strained):
        return None
    seam_edges = np.union1d(arrays.seam_edges, new_seams(arrays)).astype(np.int32)
    ids = np.zeros(len(seam_edges), dtype=np.int32)
    tried = replace(arrays, seam_edges=seam_edges, seams=arrays.edges[seam_edges], seam_ids=ids)
    try:
        result = yield from flatten_arrays(tried, choices, model.solved_by_map)
    except ObjectError:
        return None  # faults of the whole model are in the report
    found = uv_seams(result, tried, meters, choices.cloth)
    needed = [piece.needed for piece in report.pieces if piece.ok]
    usable = sum(each <= ANY_LIMIT for each in needed)
    bad, is_less = found.pieces - found.usable, found.stretch < max(needed, default=0.0)
    if not report.issues:
        is_better = not found.failed and bad <= len(needed) - usable and is_less
    else:
        is_better = found.usable > usable and bad <= max(len(report.pieces) - usable, 1)
    return found if is_better else None


def _outcome(model: Model, result: FlattenResult, choices: FlattenChoices, meters: float) -> Outcome:
    identities = identify_pieces(result, model.arrays, model.known, model.facts.object)
    seams = identify_seams(result, model.arrays, model.seams)
    report = object_report(result, model.arrays, model.facts, identities, seams, meters, choices.cloth)
    arrays = replace(model.arrays, seam_ids=ids_by_edge(result, model.arrays, seams))
    any_layout = bool(has_layout(result.corner_uv).any())
    pieces = flat_mesh(result, model.arrays, identities, choices) if any_layout else None
    report.model_state = model.state
    return Outcome(model, report, result, identities, seams, arrays, pieces)
