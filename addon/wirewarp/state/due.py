# SPDX-License-Identifier: GPL-3.0-or-later
"""In which scenes Auto has to look for changes; and a timer by which it does so though the mouse rests."""

from collections.abc import Callable

import bpy

from ..blender.events import send_mouse_move
from .memory import state_of

SECONDS = 0.2  # between two looks: soon enough to be felt as at once, and a tool that goes on is not disturbed by it


def is_due(scene: bpy.types.Scene) -> bool:
    return state_of(scene).is_due


def note_change(scene: bpy.types.Scene) -> None:
    """Notes that something may have changed in this scene, for Auto to look into it soon."""
    state_of(scene).is_due = True
    if not bpy.app.background and not bpy.app.timers.is_registered(_nudge):
        bpy.app.timers.register(_nudge, first_interval=SECONDS)


def _nudge() -> float | None:
    """The timer: until nothing is due in the scenes that windows show. Returns the seconds until the next time."""
    windows = [window for window in bpy.context.window_manager.windows if is_due(window.scene)]
    for window in windows:
        send_mouse_move(window)
    return SECONDS if windows else None


def attach() -> Callable[[], None]:
    return _detach


def _detach() -> None:
    if bpy.app.timers.is_registered(_nudge):
        bpy.app.timers.unregister(_nudge)
