# SPDX-License-Identifier: GPL-3.0-or-later
"""The one run that may be going on in the window: its thread, its timer, and how far it is.

However a run ends, be it done, cancelled, by another file or because the add-on goes, it ends in stop().
"""

import math
import time

import bpy

from ..blender.views import redraw_sidebars
from .models import Outcome, Solver, SolveThread

POLL_SECONDS = 0.02
UNSEEN_SECONDS = 0.3  # a line that is gone at once would only flicker
_current: "WindowRun | None" = None


def is_running() -> bool:
    return _current is not None


def shown_progress() -> float | None:
    """How far the current run is, from 0 to 1; None without one, or before it is worth showing."""
    return _current.shown if _current else None


def cancel() -> None:
    """Stops the current run, if there is one, as soon as the core hears of it."""
    if _current:
        _current.cancel()


def is_cancelled() -> bool:
    return _current is not None and _current.is_cancelled


def begin(context: bpy.types.Context, what: str, solve: Solver) -> "WindowRun":
    """Starts to solve; what: that is flattened, for the status bar. Only if none is running."""
    global _current
    _current = WindowRun(context, what, solve)
    return _current


def stop(*_: object) -> None:
    """Gives up the current run, if there is one, and waits for its thread."""
    if _current:
        _current.cancel()
        _current.stop()


class WindowRun:
    def __init__(self, context: bpy.types.Context, what: str, solve: Solver) -> None:
        self._what = what
        self._manager, self._workspace = context.window_manager, context.workspace
        self._begun = time.monotonic()
        self.shown: float | None = None
        self._timer = self._manager.event_timer_add(POLL_SECONDS, window=context.window)
        self._thread = SolveThread(solve)

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
            self._workspace.status_text_set(f"Flattening {self._what}    Esc: cancel")
            redraw_sidebars()
        return self._thread.is_done()

    def result(self) -> list[Outcome]:
        """Raises CancelledError, and what the solver raised."""
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
