# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn, kept until what it was made of changes, so that a redraw costs nothing."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import bpy
from bpy.app.handlers import persistent

from ..redraw import redraw_views

T = TypeVar("T")
# After a build there is none for this many times as long, so that dragging is not slowed down by more than a tenth;
IDLE_SHARE = 9
MAX_IDLE = 1.0  # second, though, so that what is seen is never old.


@dataclass(frozen=True)
class Same:
    """Equal only to what holds the very same object."""

    value: object

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.value is other.value

    __hash__ = None


@dataclass(frozen=True)
class _Entry:
    made_of: tuple
    value: object
    rests_until: float  # seconds of the monotonic clock


_entries: dict[tuple[str, str], _Entry] = {}


def kept_drawing(owner: bpy.types.Object, what: str, made_of: tuple, build: Callable[[], T]) -> T:
    """build(), from the last time if `made_of` is the same as then, or if building again so soon would be felt."""
    key = owner.name_full, what
    entry, now = _entries.get(key), time.monotonic()
    if entry and entry.made_of == made_of:
        return entry.value
    if entry and now < entry.rests_until:
        _redraw_in(entry.rests_until - now)
        return entry.value
    value = build()
    done = time.monotonic()
    _entries[key] = _Entry(made_of, value, done + min(IDLE_SHARE * (done - now), MAX_IDLE))
    return value


def _redraw_in(seconds: float) -> None:
    if not bpy.app.timers.is_registered(redraw_views):
        bpy.app.timers.register(redraw_views, first_interval=seconds)


@persistent
def _forget(*_: object) -> None:
    _entries.clear()


def attach() -> None:
    bpy.app.handlers.load_post.append(_forget)


def detach() -> None:
    bpy.app.handlers.load_post.remove(_forget)
    if bpy.app.timers.is_registered(redraw_views):
        bpy.app.timers.unregister(redraw_views)
    _forget()
