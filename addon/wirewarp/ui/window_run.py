# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one task at a time in the window, with steps, a timer and progress.

Every run ends in stop(), even if another file is opened or the add-on is disabled.
"""

import math
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic

import bpy

from ..blender.views import redraw_sidebars, send_mouse_move
from ..solve.steps import CanceledError, Steps, T, in_one_go

POLL_SECONDS = 0.02  # between two slices of work (SLICE in solve/steps.py), so that the window can be drawn
UNSEEN_SECONDS = 0.3  # seconds before the progress bar appears, because it would only flicker during short runs


@dataclass(frozen=True)
class Task:
    """Words for a kind of run."""

    name: str  # in sentences
    doing: str  # on the progress bar during the run
    finishing: str  # on the progress bar at the end of the run
    escape: str = "cancel"  # effect of Esc, in the status bar


FLATTEN = Task("Flatten", "Flattening", "Measuring")
EXPORT = Task("Export", "Exporting", "Reading again")
SUGGEST = Task("Suggest", "Searching", "Measuring", "stop")
_current: "WindowRun | None" = None


def is_running(task: Task | None = None) -> bool:
    """Return whether a run of this kind is in progress, or any run if task is None."""
    return _current is not None and task in {None, _current.task}


def busy_sentence() -> str:
    """Return a sentence that says why no run can start now; empty if a run can start."""
    return f"{_current.task.name} is still running. Wait, or press Esc." if _current else ""


def shown_progress(task: Task) -> float | None:
    """Return the progress of the current run, from 0 to 1. Return None if there is no run of this kind, or in its first
    UNSEEN_SECONDS."""
    return _current.shown if is_running(task) else None


def cancel() -> None:
    """Cancel the work of the current run, if there is a run. Its operator then ends the run."""
    if _current:
        _current.cancel()


def begin(context: bpy.types.Context, task: Task, what: str, steps: Steps[T]) -> "WindowRun[T]":
    """Return a new run of this work, which becomes the current run. No other run may be in progress. what: name of the
    object or objects in the status bar."""
    global _current
    _current = run = WindowRun(context, task, what, steps)
    return run


def stop(*_: object) -> None:
    """Stop the current run, if there is a run. Discard its work."""
    if _current:
        _current.stop()


class WindowRun(Generic[T]):
    def __init__(self, context: bpy.types.Context, task: Task, what: str, steps: Steps[T]) -> None:
        self.task, self._what = task, what
        self._manager, self._workspace = context.window_manager, context.workspace
        self._begun = time.monotonic()
        self.shown: float | None = None
        self._timer = self._manager.event_timer_add(POLL_SECONDS, window=context.window)
        self._steps = steps
        self._result: T | None = None
        self._error: Exception | None = None
        self.is_done = self._is_cancelled = False
        self.was_stopped = False  # whether the user has canceled the run, which may have a result anyway

    def cancel(self) -> None:
        """Cancel the work. If only optional work was left, the run has a result."""
        self.was_stopped = True
        if self.is_done:
            self._is_cancelled = True
        else:
            self._do(lambda: self._steps.throw(CanceledError()))

    def go_on(self) -> None:
        if not self.is_done:
            self._do(lambda: next(self._steps))

    def _do(self, step: Callable[[], float]) -> None:
        try:
            fraction = step()
        except StopIteration as end:
            self._result, self.is_done = end.value, True
        except CanceledError:
            self.is_done = self._is_cancelled = True
        except Exception as error:  # result() raises the error for the caller
            self._error, self.is_done = error, True
        else:
            self._show(math.floor(100 * fraction) / 100)

    def _show(self, fraction: float) -> None:
        if fraction != self.shown and time.monotonic() - self._begun > UNSEEN_SECONDS:
            self.shown = fraction
            self._workspace.status_text_set(f"Esc: {self.task.escape}    {self.task.doing} {self._what}")
            redraw_sidebars()

    def result(self) -> T:
        """Stop the finished run, and return its result. Raises CanceledError if the run was canceled without a result,
        and errors of the work."""
        self.stop()
        if self._is_cancelled:
            raise CanceledError
        if self._error:
            raise self._error
        return self._result

    def stop(self) -> None:
        """Stop the run, finished or not. A second call does nothing."""
        global _current
        if _current is not self:
            return
        _current = None
        self._steps.close()
        self._manager.event_timer_remove(self._timer)
        self._workspace.status_text_set(None)
        redraw_sidebars()


class WindowSteps:
    """Mixin of operators that start a run with begin(), continue it in modal() and end it in finish_run()."""

    ends_on = "TIMER"  # type of the event at which modal() calls finish_run() after the work is done

    def begin(self, context: bpy.types.Context, task: Task, what: str, steps: Steps[object]) -> set[str]:
        """Start a run with these steps, which modal() continues. what: name of the object, or number of objects."""
        self._run: WindowRun = begin(context, task, what, steps)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if event.type == "ESC" and event.value == "PRESS":
            self._run.cancel()
        if event.type == "TIMER":
            self._run.go_on()
        if self._run.is_done and event.type == self.ends_on:
            return self.finish_run(context)
        if self._run.is_done and self.ends_on == "MOUSEMOVE" and event.type == "TIMER":
            send_mouse_move(context.window)
        return {"PASS_THROUGH" if self.lets_pass(event) else "RUNNING_MODAL"}

    def cancel(self, _context: bpy.types.Context) -> None:
        """End the run when Blender closes its window or opens another file."""
        stop()

    def lets_pass(self, event: bpy.types.Event) -> bool:
        """Return whether Blender may handle this event during the run. All events except Esc may pass, because all data
        have been read."""
        return event.type != "ESC"

    def wait_for(self, context: bpy.types.Context, steps: Steps[T]) -> T:
        """Do all steps while Blender waits, and return the result. The mouse pointer shows the progress."""
        manager = context.window_manager
        manager.progress_begin(0.0, 1.0)
        try:
            return in_one_go(steps, manager.progress_update)
        finally:
            manager.progress_end()


def fault_sentence(error: Exception, what: str) -> str:
    """Return the sentence about an unexpected error, and print its traceback. what: a text about the failed work and
    the state of the file."""
    traceback.print_exc()
    return (
        f"{what}: {str(error) or type(error).__name__}. This is a bug in WireWarp. Please report it, with the text in "
        "Blender's console."
    )
