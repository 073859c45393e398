# SPDX-License-Identifier: GPL-3.0-or-later
"""Applies the proposals for failed pieces and flattens again, until there are no new proposals."""

from dataclasses import replace

import numpy as np

from .. import FlattenResult, Options, Wire, flatten
from ..report import counted
from .lines import Lines
from .model import Model

# Closed parts need one round, handles a second round, and short outlines a third. Few models need four rounds.
MOST_ROUNDS = 10


def with_proposals(
    model: Model, result: FlattenResult, seams: np.ndarray, lines: Lines, options: Options
) -> tuple[FlattenResult, Lines, list[str]]:
    """Return the last result, its wires and eases, and sentences about the applied proposals. Raises FlattenError."""
    marked = {(int(min(a, b)), int(max(a, b))) for a, b in seams}
    before, tolerances = len(marked), [wire.tolerance for wire in lines.wires]
    for _ in range(MOST_ROUNDS):
        errors = [piece.error for piece in result.pieces if piece.error]
        new = {(min(edge), max(edge)) for error in errors for edge in error.proposed_seams} - marked
        suggested = [pair for error in errors for pair in error.proposed_tolerances]
        wires = [
            _widened(wire, max((tolerance for own, tolerance in suggested if own == index), default=wire.tolerance))
            for index, wire in enumerate(lines.wires)
        ]
        if not new and all(wire is own for wire, own in zip(wires, lines.wires, strict=True)):
            break
        marked |= new
        lines = replace(lines, wires=wires)
        result = flatten(
            model.vertices, model.faces, seams=sorted(marked), wires=wires, eases=lines.eases, options=options
        )
    done = []
    if len(marked) > before:
        done.append(f"{counted(len(marked) - before, 'suggested edge')} marked as seams")
    widened = sum(wire.tolerance > tolerance for wire, tolerance in zip(lines.wires, tolerances, strict=True))
    if widened:
        done.append(f"tolerance of {counted(widened, 'wire')} widened as suggested")
    return result, lines, done


def _widened(wire: Wire, tolerance: float) -> Wire:
    """Return a copy of the wire with this tolerance, or the wire itself if its tolerance is at least as large."""
    if tolerance <= wire.tolerance:
        return wire
    return Wire(wire.vertices, tolerance, wire.name, wire.ease)
