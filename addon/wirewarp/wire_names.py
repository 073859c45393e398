# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of wires, kept in a list on the mesh. A wire without an entry (a joined mesh's) gets one when it is needed."""

from collections.abc import Iterable

import bpy


def find_name(mesh: bpy.types.Mesh, wire_id: int) -> bpy.types.PropertyGroup | None:
    return next((entry for entry in mesh.wirewarp_names if entry.wire_id == wire_id), None)


def list_position(mesh: bpy.types.Mesh, wire_id: int) -> int:
    """For sorting: the place in the list, unnamed wires last."""
    ids = [entry.wire_id for entry in mesh.wirewarp_names]
    return ids.index(wire_id) if wire_id in ids else len(ids)


def names_of(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> dict[int, str]:
    """The name of each id, in their order; those without an entry get the next free number."""
    present = dict.fromkeys(wire_ids)
    names = {entry.wire_id: entry.name for entry in mesh.wirewarp_names if entry.wire_id in present}
    taken = set(names.values())
    for wire_id in present:
        if wire_id not in names:
            names[wire_id] = _free_name(taken)
            taken.add(names[wire_id])
    return names


def update_names(mesh: bpy.types.Mesh, wire_ids: Iterable[int]) -> None:
    """One entry for each of the ids that are on the mesh; entries of vanished wires go."""
    names = names_of(mesh, wire_ids)
    for index in reversed(range(len(mesh.wirewarp_names))):
        if mesh.wirewarp_names[index].wire_id not in names:
            mesh.wirewarp_names.remove(index)
    known = {entry.wire_id for entry in mesh.wirewarp_names}
    for wire_id, name in names.items():
        if wire_id not in known:
            entry = mesh.wirewarp_names.add()
            entry.wire_id, entry.name = wire_id, name


def copy_names(source: bpy.types.Mesh, target: bpy.types.Mesh) -> None:
    target.wirewarp_names.clear()
    for entry in source.wirewarp_names:
        copied = target.wirewarp_names.add()
        copied.wire_id, copied.name = entry.wire_id, entry.name


def _free_name(taken: set[str]) -> str:
    number = len(taken) + 1
    while f"Wire {number}" in taken:
        number += 1
    return f"Wire {number}"
