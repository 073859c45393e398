# SPDX-License-Identifier: GPL-3.0-or-later
"""Every wire of a mesh with an id of its own, and the list of names as the edges are.

Editing the mesh copies and cuts wires: then one id stands on several runs of edges, or with several tolerances.
"""

import bpy

from .marking import own_ids
from .wire_names import chain_names, write_names
from .wire_summary import find_wires


def repair_names(mesh: bpy.types.Mesh) -> dict[int, int]:
    """Writes the names, and returns the ids that are still to be written, by edge. In either mode."""
    wires = find_wires(mesh)
    ids = [wire.wire_id for wire in wires]
    own = own_ids(ids)
    write_names(mesh, dict(zip(own, chain_names(mesh, ids), strict=True)))
    return {edge: wire_id for wire, wire_id in zip(wires, own, strict=True) if wire.shares_id for edge in wire.edges}
