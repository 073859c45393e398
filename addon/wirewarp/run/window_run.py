# SPDX-License-Identifier: GPL-3.0-or-later
"""The one run that may be going on in the window: its thread, its timer and its line in the status bar.

However a run ends, be it done, cancelled, by another file or because the add-on goes, it ends in stop().
"""

import time

import bpy

from .models import Outcome, Solver, SolveThread

POLL_SECONDS = 0.02
UNSEEN_SECONDS = 0.3  # a line that is gone at once would only flicker
_current: "WindowRun | None" = None


def is_running() -> bool:
    return _current is not None


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
        self._timer = self._manager.event_timer_add(POLL_SECONDS, window=context.window)
        self._thread = SolveThread(solve)

    def cancel(self) -> None:
        self._thread.cancel()

    def is_done(self) -> bool:
        """Also shows how far it is."""
        if time.monotonic() - self._begun > UNSEEN_SECONDS:
            percent = f"{100 * self._thread.fraction:.0f}%"
            key = "stopping..." if self._thread.cancelled else "Esc: cancel"
            self._workspace.status_text_set(f"Flattening {self._what}: {percent}    {key}")
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
