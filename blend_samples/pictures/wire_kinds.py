# SPDX-License-Identifier: GPL-3.0-or-later
"""Sorts wires by kind, with names and colors of the kinds. Needs only numpy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .palette import DARK_RIM, ELASTIC, FREE, LIGHT_RIM, RIGID


@dataclass(frozen=True)
class WireKind:
    name: str
    color: np.ndarray
    rim: np.ndarray


_RIGID = WireKind("rigid wire", RIGID, LIGHT_RIM)
_ELASTIC = WireKind("elastic wire", ELASTIC, DARK_RIM)
_FREE = WireKind("free wire", FREE, DARK_RIM)


def by_kind(wires: np.ndarray, tolerances: np.ndarray) -> list[tuple[WireKind, np.ndarray]]:
    """Return the kinds that occur among the wire edges (k, 2), each with its edges."""
    masks = ((_RIGID, tolerances == 0), (_ELASTIC, (tolerances > 0) & np.isfinite(tolerances)))
    split = [(kind, wires[mask]) for kind, mask in (*masks, (_FREE, np.isinf(tolerances)))]
    return [(kind, edges) for kind, edges in split if len(edges)]
