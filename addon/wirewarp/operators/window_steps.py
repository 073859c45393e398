# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators have in common that work in a thread while the window goes on."""

from collections.abc import Callable

import bpy

from ..run import window_run
from ..run.thread import Progress, T


class WindowSteps:
    """Mixed into operators. modal() belongs to what begin() has begun."""

    ends_on = "TIMER"  # the event upon which a run that is done is finished

    def begin(
        self, context: bpy.types.Context, task: window_run.Task, what: str, work: Callable[[Progress], object]
    ) -> set[str]:
        """Works in a thread, while modal() waits for it; what: on which object or objects."""
        self._run: window_run.WindowRun = window_run.begin(context, task, what, work)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if event.type == "ESC" and event.value == "PRESS":
            self._run.cancel()
        if self._run.is_done() and event.type == self.ends_on:
            return self.finish_run(context)
        return {"PASS_THROUGH" if self.lets_pass(event) else "RUNNING_MODAL"}

    def cancel(self, _context: bpy.types.Context) -> None:
        """Blender ends the run: its window closes or another file is opened."""
        window_run.stop()

    def lets_pass(self, event: bpy.types.Event) -> bool:
        """Whether the user may do this during the run."""
        raise NotImplementedError

    def finish_run(self, context: bpy.types.Context) -> set[str]:
        raise NotImplementedError

    def wait_for(self, context: bpy.types.Context, work: Callable[[Progress], T]) -> T:
        """All at once; Blender waits."""
        manager = context.window_manager

        def progress(_stage: str, fraction: float) -> bool:
            manager.progress_update(fraction)
            return True

        manager.progress_begin(0.0, 1.0)
        try:
            return work(progress)
        finally:
            manager.progress_end()
