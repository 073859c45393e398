# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts to be taken together, towards an aim in numbers."""

import math
from collections.abc import Callable, Iterable
from typing import Literal

import numpy as np
import numpy.typing as npt

from ._errors import ErrorCode, FlattenError
from ._wirewarp import DartProposal, Ease, Options, Wire, propose_darts, propose_seams

_PROPOSE = {"dart": propose_darts, "seam": propose_seams}


def plan_cuts(
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    kind: Literal["dart", "seam"] = "dart",
    strain: float = 0.05,
    most: int = 2,
    longest: float | None = None,
    total_length: float | None = None,
    seams: npt.ArrayLike | None = None,
    wires: Iterable[Wire] = (),
    options: Options | None = None,
    eases: Iterable[Ease] = (),
    no_seam: npt.ArrayLike | None = None,
    progress: Callable[[str, float], bool | None] | None = None,
) -> list[DartProposal]:
    """Cuts one after the other, each the one that leaves least strain beside those before it, until that is enough.

    kind: "dart" or "seam", as propose_darts() and propose_seams() propose them.
    strain: the aim, 0.05 for 5%: pieces strained by no more (DartProposal.strain) are left as they are.
    most: cuts at most, 1 or more; a set of first cuts (see propose_seams()) counts as one.
    longest: no cut is longer on the surface, scene units; None for any length.
    total_length: of all cuts together at most, on the surface, scene units; None for any length.
    no_seam: (k, 2) vertex pairs, edges along which no cut is to run.
    The other arguments are those of flatten().

    The figures of each, and the number of its piece, are those beside the cuts before it. Fewer cuts than are allowed
    mean that the aim is met, or that no further one helps. Raises what propose_darts() raises for the first cut:
    FlattenError "no_proposal" where the aim is met without any.
    """
    if kind not in _PROPOSE:
        raise FlattenError(ErrorCode.invalid_option, f"kind must be dart or seam, not {kind}.")
    taken: list[DartProposal] = []
    wires, eases = list(wires), list(eases)
    if most < 1:
        raise FlattenError(ErrorCode.invalid_option, f"most must be at least 1, not {most}.")
    given = np.asarray([] if seams is None else seams)
    lines = [given if len(given) else np.zeros((0, 2), dtype=np.int32)]
    while len(taken) < most:
        left = math.inf if total_length is None else total_length - sum(cut.length for cut in taken)
        if taken and left <= 0:
            break
        done = len(taken)

        def report(stage: str, fraction: float, done: int = done) -> bool | None:
            return None if progress is None else progress(stage, (done + fraction) / most)

        try:
            proposals = _PROPOSE[kind](
                vertices,
                faces,
                seams=np.concatenate(lines),
                wires=wires,
                options=options,
                eases=eases,
                strain=strain,
                longest=left if longest is None else min(left, longest),
                no_seam=no_seam,
                progress=report,
            )
        except FlattenError as error:
            if taken and error.code == ErrorCode.no_proposal:
                break
            raise
        worst = max(proposal.strain_before for proposal in proposals)
        best = min(
            (proposal for proposal in proposals if proposal.strain_before == worst),
            key=lambda proposal: proposal.strain,
        )
        taken.append(best)
        lines.append(best.edges)
    return taken
