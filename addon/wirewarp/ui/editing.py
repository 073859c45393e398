# SPDX-License-Identifier: GPL-3.0-or-later
"""Common parts of operators that change models: they refuse flat pieces, report errors, and plan before they write."""

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

import bpy

from ..blender.objects import check_local
from ..blender.selection import in_object_mode
from ..issues import ObjectError
from ..state.owners import model_of

T = TypeVar("T")
Operator = TypeVar("Operator", bound=bpy.types.Operator)
Execute = Callable[[Operator, bpy.types.Context], set[str]]


class OnMesh:
    """Mixin of operators and panels that need an active mesh."""

    modes = frozenset[str]()  # modes in which the operator or panel works; empty: all modes
    refusal = ""  # reason shown if there is no active mesh in one of these modes

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        if active is not None and active.type == "MESH" and (context.mode in cls.modes or not cls.modes):
            return True
        if cls.refusal:
            cls.poll_message_set(cls.refusal)
        return False


class OnModel(OnMesh):
    """Mixin of operators that refuse flat pieces."""

    on_model = ""  # the action that is possible on the model, such as "mark the wire"
    modes = frozenset({"EDIT_MESH"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if not super().poll(context):
            return False
        if model_of(context.active_object):
            cls.poll_message_set(f"These are flat pieces: {cls.on_model} on the model")
            return False
        if any(map(model_of, context.objects_in_mode_unique_data)):
            cls.poll_message_set("Leave Edit Mode of the flat pieces first")
            return False
        return True


def reporting_refusals(execute: Execute) -> Execute:
    """Return an operator's execute() that reports an ObjectError instead of raising it."""

    @wraps(execute)
    def execute_or_report(operator: Operator, context: bpy.types.Context) -> set[str]:
        try:
            return execute(operator, context)
        except ObjectError as error:
            operator.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    return execute_or_report


def change_edited(context: bpy.types.Context, plan: Callable[[bpy.types.Object], Callable[[], T]]) -> list[T]:
    """Plan changes for each object in Edit Mode, then write all changes, and return their results.

    plan() is called in Object Mode, if an edge is selected. If it raises ObjectError, no object is changed.
    """
    targets = list(context.objects_in_mode_unique_data)
    for target in targets:
        check_local(target, target.data)
    if not any(target.data.total_edge_sel for target in targets):
        return []
    with in_object_mode(context):
        planned = [plan(target) for target in targets]
        return [write() for write in planned]
