# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps drawings until their data change, so that a redraw takes almost no time."""

import time
from collections.abc import Callable
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, TypeVar

import bpy
import numpy as np

from ..blender.views import redraw_views
from .memory import all_states, state_of

T = TypeVar("T")
IDLE_SHARE = 9  # pause after a build, as a multiple of its duration, so that builds take a tenth of the time
MAX_IDLE = 1.0  # longest pause after a build, in seconds, so that slow drawings are also updated often
FELT = 0.03  # seconds, 2 frames at 60 Hz; if a build takes longer, later builds wait for SOON or REST
SOON = 0.01  # seconds from a change to the build of a slow drawing, so that the screen is redrawn before
REST = 0.2  # seconds without a change before a slow drawing is built in Edit Mode, where the user may be dragging


@dataclass(frozen=True, eq=False)
class Same:
    """A value that equals another Same only if both contain the same object."""

    value: object

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.value is other.value


@dataclass(frozen=True)
class _Entry:
    made_of: tuple  # data from which the drawing was built
    value: Any
    rests_until: float  # end of the pause after the build, in seconds of the monotonic clock
    is_slow: bool  # whether the build took longer than FELT
    awaited: tuple | None = None  # data of a postponed build
    since: float = 0.0  # time when the build was postponed, in seconds of the monotonic clock


def kept_drawing(
    owner: bpy.types.Object, what: str, made_of: tuple, build: Callable[[], T], model: bpy.types.Object | None = None
) -> T:
    """Return build(), or its last result if `made_of` is unchanged, or if a build now would delay the user.

    While the owner or `model` is in Edit Mode, slow builds wait for a pause.
    """
    drawings, now = state_of(owner).drawings, time.monotonic()
    entry: _Entry | None = drawings.get(what)
    if entry and entry.made_of == made_of:
        return entry.value
    if entry:
        is_edited = "EDIT" in (owner.mode, model.mode if model else "")
        if entry.awaited is None or (is_edited and entry.awaited != made_of):
            entry = replace(entry, awaited=made_of, since=now)
        pause = (REST if is_edited else SOON) if entry.is_slow else 0.0
        wait = max(entry.rests_until, entry.since + pause) - now
        if wait > 0:
            drawings[what] = entry
            _redraw_in(wait)
            return entry.value
    value = build()
    if entry:
        value = reused(entry.value, value)  # equal parts stay the same objects, so drawings made of them stay valid
    done = time.monotonic()
    drawings[what] = _Entry(made_of, value, done + min(IDLE_SHARE * (done - now), MAX_IDLE), done - now > FELT)
    return value


def reused(old: Any, new: Any) -> Any:  # noqa: ANN401
    """Return the new data, but with the old object for each part that has not changed."""
    if is_same(old, new):
        return old
    if isinstance(old, dict) and isinstance(new, dict):
        return {key: reused(old[key], value) if key in old else value for key, value in new.items()}
    if is_dataclass(new) and not isinstance(new, type) and type(old) is type(new):
        names = [each.name for each in fields(new)]
        return replace(new, **{name: reused(getattr(old, name), getattr(new, name)) for name in names})
    return new


def is_same(first: Any, second: Any) -> bool:  # noqa: ANN401
    """Return whether the values are equal, even if they are or contain arrays."""
    if type(first) is not type(second):
        return False
    if isinstance(first, np.ndarray):
        return np.array_equal(first, second)
    if isinstance(first, dict):
        return first.keys() == second.keys() and all(is_same(value, second[key]) for key, value in first.items())
    if isinstance(first, list | tuple):
        return len(first) == len(second) and all(map(is_same, first, second))
    if is_dataclass(first):
        return all(is_same(getattr(first, each.name), getattr(second, each.name)) for each in fields(first))
    return first == second


def _redraw_in(seconds: float) -> None:
    if not bpy.app.timers.is_registered(redraw_views):
        bpy.app.timers.register(redraw_views, first_interval=seconds)


def forget(*_: object) -> None:
    if bpy.app.timers.is_registered(redraw_views):
        bpy.app.timers.unregister(redraw_views)
    for state in all_states():
        state.drawings.clear()
