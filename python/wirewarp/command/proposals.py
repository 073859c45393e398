# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks what is suggested for pieces that failed, and flattens again, until nothing more is suggested."""

from dataclasses import replace

import numpy as np

from .. import FlattenResult, Options, Wire, flatten
from ..report import counted
from .lines import Lines
from .model import Model

MOST_ROUNDS = 10  # a part is cut open, then its handles, then what is still too short: few models take four


def with_proposals(
    model: Model, result: FlattenResult, seams: np.ndarray, lines: Lines, options: Options
) -> tuple[FlattenResult, Lines, list[str]]:
    """The last result with the lines that it has, and what was done. Raises FlattenError."""
    marked = {(int(min(a, b)), int(max(a, b))) for a, b in seams}
    before, widened = len(marked), 0
    for _ in range(MOST_ROUNDS):
        errors = [piece.error for piece in result.pieces if piece.error]
        new = {(min(edge), max(edge)) for error in errors for edge in error.proposed_seams} - marked
        wider = {wire: tolerance for error in errors for wire, tolerance in error.proposed_tolerances}
        if not (new or wider):
            break
        marked |= new
        widened += len(wider)
        wires = [_widened(wire, wider.get(index)) for index, wire in enumerate(lines.wires)]
        lines = replace(lines, wires=wires)
        result = flatten(
            model.vertices, model.faces, seams=sorted(marked), wires=wires, eases=lines.eases, options=options
        )
    done = []
    if len(marked) > before:
        done.append(f"{counted(len(marked) - before, 'suggested edge')} marked as seams")
    if widened:
        done.append(f"{counted(widened, 'tolerance')} widened as suggested")
    return result, lines, done


def _widened(wire: Wire, tolerance: float | None) -> Wire:
    if tolerance is None or tolerance <= wire.tolerance:
        return wire
    return Wire(wire.vertices, tolerance, wire.name, wire.ease)
