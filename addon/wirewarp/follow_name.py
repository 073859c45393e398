# SPDX-License-Identifier: GPL-3.0-or-later
"""The results of a model that was renamed since the last run get names after its present one."""

import bpy

from .owners import find_flat_object, find_helper_wires, flat_name, helper_name


def follow_name(source: bpy.types.Object, earlier: str) -> None:
    """earlier: what the model was called then. What the user has named otherwise stays."""
    flat = find_flat_object(source)
    _rename(find_helper_wires(source), helper_name(earlier), helper_name(source.name))
    if flat:
        before = flat.name
        _rename(flat, flat_name(earlier), flat_name(source.name))
        _rename(find_helper_wires(flat), helper_name(before), helper_name(flat.name))


def _rename(target: bpy.types.Object | None, before: str, now: str) -> None:
    """With its mesh."""
    for each in (target, target.data) if target and before != now else ():
        if each.name == before and each.library is None:
            each.name = now
