# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads one model and returns the cuts that are proposed for the model."""

import math
from typing import Any

import numpy as np

from .. import DartProposal, SeamProposal, flatten, plan_cuts, propose_darts, propose_seams, simplify_seams
from ..pattern import piece_width, pieces_along
from .flatten import material_options
from .lines import edges_of, lines_of, seams_of
from .model import read_model
from .request import BLEND, MILLIMETERS, CutRequest, InputError
from .verdicts import NOTHING, PROPOSED, Line, unfinished, with_faults_answered

ALL_NEEDED = "Every seam is needed for this strain."
NO_SEAMS = "The model has no seams that could be left out."
IN_BLENDER = "propose reads OBJ, PLY, STL or glTF. For .blend files, use the add-on in Blender."


@with_faults_answered
def propose_for(request: CutRequest) -> Line:
    """Return the line to print. Faults of the model are reported in the line, not raised."""
    if request.model.suffix.lower() == BLEND:
        raise InputError(IN_BLENDER)
    model = read_model(request.model)
    lines, per_unit = lines_of(request.wires), MILLIMETERS[request.unit]
    mesh: dict[str, Any] = {
        "vertices": model.vertices,
        "faces": model.faces,
        "seams": seams_of(model, request.seams),
        "wires": lines.wires,
        "eases": lines.eases,
        "options": material_options(request.material, request.unit),
    }
    wanted: dict[str, Any] = {} if request.strain is None else {"strain": request.strain}
    if request.kind == "fewer":
        return _fewer(mesh, simplify_seams(**mesh, **wanted), per_unit / 1000)
    wanted["no_seam"] = edges_of(request.no_seam)
    wanted["longest"] = None if request.longest is None else request.longest / per_unit
    if request.together:
        cuts = plan_cuts(**mesh, **wanted, kind=request.kind, most=request.together)
    else:
        propose = propose_darts if request.kind == "dart" else propose_seams
        piece = None if request.piece is None else request.piece - 1
        if request.narrowest is not None:
            wanted["narrowest"] = request.narrowest / per_unit
        if request.count is not None:
            wanted["count"] = request.count
        cuts = propose(**mesh, **wanted, piece=piece)
    meters, are_together = per_unit / 1000, request.together is not None
    described = [_proposal(cut, meters, not are_together) | _width_of_set(mesh, cut, meters) for cut in cuts]
    return _proposed(request.kind, described, are_together)


def _width_of_set(mesh: dict[str, Any], cut: DartProposal, meters: float) -> dict[str, Any]:
    """Return {"narrowest_width_m": width} for the pieces that a set of seams makes, or {} for a single cut.

    A set is recognized by its strain_before, which is infinite.
    """
    if math.isfinite(cut.strain_before):
        return {}
    seams = np.concatenate([np.reshape(mesh["seams"], (-1, 2)), cut.edges])
    return {"narrowest_width_m": _narrowest(mesh, seams, cut.edges, meters)}


def _narrowest(mesh: dict[str, Any], seams: np.ndarray, changed: np.ndarray, meters: float) -> float | None:
    """Return the width in meters of the narrowest flat piece with changed edges; None if all such pieces failed."""
    own = pieces_along(flatten(**mesh | {"seams": seams}).pieces, changed)
    return min((piece_width(piece) * meters for piece in own if not piece.error), default=None)


def _fewer(mesh: dict[str, Any], proposal: SeamProposal, meters: float) -> Line:
    """Return the line to print. Its "lines" are the seams to keep."""
    if len(proposal.opened) == 0:
        return unfinished(NOTHING, "no_proposal", ALL_NEEDED if len(proposal.edges) else NO_SEAMS)
    described = {
        "lines": _lines_along(proposal.edges.tolist()),
        "length_m": proposal.length * meters,
        "length_before_m": proposal.length_before * meters,
        "pieces": proposal.num_pieces,
        "pieces_before": proposal.num_pieces_before,
        "energy": _if_finite(proposal.energy),
        "energy_before": _if_finite(proposal.energy_before),
        "strain": _if_finite(proposal.strain),
        "strain_before": _if_finite(proposal.strain_before),
        "narrowest_width_m": _narrowest(mesh, proposal.edges, proposal.opened, meters),
    }
    return _proposed("fewer", [described], are_together=False)


def _proposed(kind: str, proposals: list[dict[str, Any]], are_together: bool) -> Line:
    about: Line = {"verdict": PROPOSED, "cut": kind, "together": are_together}
    return about | {"proposals": proposals, "problems": [], "codes": []}


def _proposal(cut: DartProposal, meters: float, has_mirror_image: bool) -> dict[str, Any]:
    """Return a proposal, with lines in the form that --seams reads.

    - meters: length of the model's unit
    - has_mirror_image: whether to add the keys for the mirror image, which is another proposal
    """
    described: dict[str, Any] = {
        "piece": cut.piece + 1,
        "lines": _lines_along(cut.edges.tolist()),
        "length_m": cut.length * meters,
        "pieces": cut.num_pieces,
        "energy": cut.energy,
        "energy_before": _if_finite(cut.energy_before),
        "strain": cut.strain,
        "strain_before": _if_finite(cut.strain_before),
    }
    if not has_mirror_image:
        return described
    return described | {
        "twin": None if cut.twin is None else cut.twin + 1,
        "energy_with_twin": cut.energy_with_twin,
        "strain_with_twin": cut.strain_with_twin,
    }


def _lines_along(edges: list[list[int]]) -> list[list[int]]:
    """Return the edges as lines of vertices. An edge that begins at the end of the last line continues that line."""
    lines: list[list[int]] = []
    for start, end in edges:
        if lines and lines[-1][-1] == start:
            lines[-1].append(end)
        else:
            lines.append([start, end])
    return lines


def _if_finite(figure: float) -> float | None:
    """Return the figure, or None if it is infinite, because JSON has no infinity. A piece without a flat shape has
    infinite figures."""
    return figure if math.isfinite(figure) else None
