# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators have in common that work in steps while the window goes on."""

import traceback

import bpy

from ..blender.events import send_mouse_move
from ..solve.steps import Steps, T, in_one_go
from . import window_run


class WindowSteps:
    """Mixed into operators. modal() belongs to what begin() has begun."""

    ends_on = "TIMER"  # the event upon which a run that is done is finished

    def begin(self, context: bpy.types.Context, task: window_run.Task, what: str, steps: Steps[object]) -> set[str]:
        """modal() goes on with it; what: on which object or objects."""
        self._run: window_run.WindowRun = window_run.begin(context, task, what, steps)
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
        """Blender ends the run: its window closes or another file is opened."""
        window_run.stop()

    def lets_pass(self, event: bpy.types.Event) -> bool:
        """Whether the user may do this during the run."""
        raise NotImplementedError

    def finish_run(self, context: bpy.types.Context) -> set[str]:
        raise NotImplementedError

    def wait_for(self, context: bpy.types.Context, steps: Steps[T]) -> T:
        """All at once; Blender waits."""
        manager = context.window_manager
        manager.progress_begin(0.0, 1.0)
        try:
            return in_one_go(steps, manager.progress_update)
        finally:
            manager.progress_end()


def fault_sentence(error: Exception, what: str) -> str:
    """The sentence for what should not happen; what: failed, and the state of the file."""
    traceback.print_exc()
    return (
        f"{what}: {str(error) or type(error).__name__}. This is a bug in WireWarp. Please report it, with the text in "
        "Blender's console."
    )
