# SPDX-License-Identifier: GPL-3.0-or-later
"""Notes on what the model has and the flat pieces have not."""

import bpy

from ..issues import note, warning
from ..names import UV_LAYER
from ..solve.arrays import MeshArrays
from ..words import counted

# Modifiers that move no vertex and make no face.
OF_ATTRIBUTES = {
    "DATA_TRANSFER",
    "EDGE_SPLIT",
    "NORMAL_EDIT",
    "UV_PROJECT",
    "UV_WARP",
    "VERTEX_WEIGHT_EDIT",
    "VERTEX_WEIGHT_MIX",
    "VERTEX_WEIGHT_PROXIMITY",
    "WEIGHTED_NORMAL",
}


def left_out(source: bpy.types.Object, arrays: MeshArrays | None, use_modifiers: bool) -> list[dict]:
    notes = []
    shown = [] if use_modifiers else shown_only(source)
    if shown:
        ignored = " and ".join(shown).capitalize()
        text = f"{ignored} were ignored, so sizes may differ from what you see. Tick Modifiers and flatten again."
        notes.append(warning(text))
    if use_modifiers and UV_LAYER in source.data.uv_layers:
        text = f'The UV map "{UV_LAYER}" is from an earlier run without Modifiers. It does not show these pieces.'
        notes.append(note(text))
    if arrays and arrays.loose_marks:
        ignored = counted(arrays.loose_marks, "marked edge ignored: it has", "marked edges ignored: they have")
        notes.append(warning(f"{ignored} no face."))
    return notes


def shown_only(source: bpy.types.Object) -> list[str]:
    """What makes the object look different from its base mesh."""
    moving = [modifier for modifier in source.modifiers if modifier.type not in OF_ATTRIBUTES]
    shown = ["modifiers"] if any(modifier.show_viewport for modifier in moving) else []
    return shown + (["shape keys"] if _is_keyed(source.data.shape_keys, source) else [])


def _is_keyed(keys: bpy.types.Key | None, source: bpy.types.Object) -> bool:
    if keys is None:
        return False
    if source.show_only_shape_key:
        return source.active_shape_key != keys.reference_key
    if not keys.use_relative:
        return True
    return any(key.value != 0 and not key.mute for key in keys.key_blocks if key != keys.reference_key)
