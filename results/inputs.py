# SPDX-License-Identifier: GPL-3.0-or-later
"""Collects the inputs of the sections of docs/results.md."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

import wirewarp
from methods import METHODS, Unwraps
from shapes import Shape


@dataclass(frozen=True)
class Inputs:
    shapes: dict[str, Shape]  # the samples by name
    unwraps: Unwraps
    worn: dict[str, dict[str, dict[str, float]]]  # output of wear_in_newton.py
    error_curves: Path  # program built from native/bench/error_curves
    pictures: Path  # folder for the pictures
    _flattened: dict[str, dict[str, wirewarp.FlattenResult]] = field(default_factory=dict)

    def by_all_methods(self, name: str) -> dict[str, wirewarp.FlattenResult]:
        """Return a sample flattened by each of METHODS with its own tolerances. Each sample is flattened once."""
        if name not in self._flattened:
            shape = self.shapes[name]
            self._flattened[name] = {title: method(shape, self.unwraps) for title, method in METHODS.items()}
        return self._flattened[name]


def with_tolerances(shape: Shape, tolerances: list[float]) -> Shape:
    """Return the sample with these tolerances of its wires."""
    wires = [replace(wire, tolerance=t) for wire, t in zip(shape.wires, tolerances, strict=True)]
    return replace(shape, wires=wires)
