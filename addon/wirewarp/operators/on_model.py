# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators that change models have in common: they refuse flat pieces."""

import bpy

from ..model.owners import model_of


class OnModel:
    """Mixed into operators. Subclasses say in `on_model` what to do on the model instead."""

    on_model = ""
    modes = frozenset({"EDIT_MESH"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is None or active.type != "MESH" or context.mode not in cls.modes:
            return False
        if model_of(active):
            cls.poll_message_set(f"These are flat pieces: {cls.on_model} on the model")
            return False
        if any(map(model_of, context.objects_in_mode_unique_data)):
            cls.poll_message_set("Leave Edit Mode of the flat pieces first")
            return False
        return True
