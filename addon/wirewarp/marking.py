# SPDX-License-Identifier: GPL-3.0-or-later
"""Which selected edges become which wire, and with which id. No Blender in here."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .wire_chains import split_into_chains

MAX_ID = 2**31 - 1


@dataclass(frozen=True)
class PlannedWire:
    rows: list[int]  # rows of the selected edges
    kept_id: int  # the id of the wire that is marked again as a whole, 0: a new wire


def plan_wires(
    edges: np.ndarray, wire_ids: np.ndarray, edges_of_wire: Mapping[int, int], positions: np.ndarray
) -> list[PlannedWire]:
    """Selected edges (k,2) with their present ids (k,) to one wire a chain.

    A chain that contains all edges of one wire, and of no other, is that wire: it keeps its id and name and only
    changes its tolerance. edges_of_wire counts the edges of each id on the whole mesh.
    """
    planned = []
    for chain in split_into_chains(edges, positions):
        present = wire_ids[chain.edges]
        ids = np.unique(present[present != 0]).tolist()
        whole = len(ids) == 1 and np.count_nonzero(present) == edges_of_wire[ids[0]]
        planned.append(PlannedWire(chain.edges, ids[0] if whole else 0))
    return planned


def own_ids(wire_ids: Sequence[int]) -> list[int]:
    """An id for each wire, its own where it is the first with that: a wire that was copied or cut in two has several.

    The others get the next number that is no wire's; the same ones each time.
    """
    taken, own = set(wire_ids), dict[int, None]()
    for wire_id in wire_ids:
        free = wire_id
        while free in own or (free != wire_id and free in taken):
            free = free % MAX_ID + 1
        own[free] = None
    return list(own)
