# SPDX-License-Identifier: GPL-3.0-or-later
"""The one piece of work that may be going on in the window: its thread, its timer, and how far it is.

However a run ends, be it done, cancelled, by another file or because the add-on goes, it ends in stop().
"""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic

import bpy

from ..blender.views import redraw_sidebars
from .thread import Progress, T, WorkThread

POLL_SECONDS = 0.02
UNSEEN_SECONDS = 0.3  # a line that is gone at once would only flicker


@dataclass(frozen=True)
class Task:
    """What it is called in sentences, and on the bar while it goes on and at its end."""

    name: str
    doing: str
    finishing: str


FLATTEN = Task("Flatten", "Flattening", "Measuring")
EXPORT = Task("Export", "Exporting", "Reading again")
_current: "WindowRun | None" = None


def is_running(task: Task | None = None) -> bool:
    """Whether a run goes on; task: of this kind."""
    return _current is not None and task in {None, _current.task}


def busy_sentence() -> str:
    """Why no other run can begin now; empty where one can."""
    return f"{_current.task.name} is still running. Wait, or press Esc." if _current else ""


def shown_progress(task: Task) -> float | None:
    """How far the current run is, from 0 to 1; None without one of this kind, or before it is worth showing."""
    return _current.shown if is_running(task) else None


def cancel() -> None:
    """Stops the current run, if there is one, as soon as its work hears of it."""
    if _current:
        _current.cancel()


def is_cancelled() -> bool:
    return _current is not None and _current.is_cancelled


def begin(context: bpy.types.Context, task: Task, what: str, work: Callable[[Progress], T]) -> "WindowRun[T]":
    """Starts to work; what: on which object or objects, for the status bar. Only if none is running."""
    global _current
    _current = run = WindowRun(context, task, what, work)
    return run


def stop(*_: object) -> None:
    """Gives up the current run, if there is one, and waits for its thread."""
    if _current:
        _current.cancel()
        _current.stop()


class WindowRun(Generic[T]):
    def __init__(self, context: bpy.types.Context, task: Task, what: str, work: Callable[[Progress], T]) -> None:
        self.task, self._what = task, what
        self._manager, self._workspace = context.window_manager, context.workspace
        self._begun = time.monotonic()
        self.shown: float | None = None
        self._timer = self._manager.event_timer_add(POLL_SECONDS, window=context.window)
        self._thread = WorkThread(work)

    def cancel(self) -> None:
        self._thread.cancel()

    @property
    def is_cancelled(self) -> bool:
        return self._thread.cancelled

    def is_done(self) -> bool:
        """Also shows how far it is."""
        fraction = math.floor(100 * self._thread.fraction) / 100
        if fraction != self.shown and time.monotonic() - self._begun > UNSEEN_SECONDS:
            self.shown = fraction
            self._workspace.status_text_set(f"{self.task.doing} {self._what}    Esc: cancel")
            redraw_sidebars()
        return self._thread.is_done()

    def result(self) -> T:
        """As WorkThread.result."""
        try:
            return self._thread.result()
        finally:
            self.stop()

    def stop(self) -> None:
        global _current
        if _current is not self:
            return
        _current = None
        self._thread.join()
        self._manager.event_timer_remove(self._timer)
        self._workspace.status_text_set(None)
        redraw_sidebars()
