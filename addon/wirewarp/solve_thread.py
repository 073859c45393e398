# SPDX-License-Identifier: GPL-3.0-or-later
"""A solver in a thread of its own: the core leaves Python's lock, so that Blender's window stays alive meanwhile.

No Blender in here: a thread must not touch it.
"""

import threading

from .solve_models import CancelledError, Outcome, Solver


class SolveThread:
    """Begins at once. Whoever makes one must wait for its end, by join() or result()."""

    def __init__(self, solve: Solver) -> None:
        self.fraction = 0.0  # of the whole, from 0 to 1
        self._solve = solve
        self._cancelled = threading.Event()
        self._outcomes: list[Outcome] = []
        self._error: BaseException | None = None
        self._thread = threading.Thread(target=self._work, name="WireWarp")
        self._thread.start()

    @property
    def cancelled(self) -> bool:
        return self._cancelled.is_set()

    def cancel(self) -> None:
        """Takes effect the next time the core tells of its progress."""
        self._cancelled.set()

    def is_done(self) -> bool:
        return not self._thread.is_alive()

    def join(self) -> None:
        self._thread.join()

    def result(self) -> list[Outcome]:
        """Raises CancelledError after cancel(), even if all was done by then, and what the solver raised."""
        self.join()
        if self.cancelled:
            raise CancelledError
        if self._error is not None:
            raise self._error
        return self._outcomes

    def _work(self) -> None:
        try:
            self._outcomes = self._solve(self._progress)
        except BaseException as error:  # noqa: BLE001  result() raises it where somebody hears it
            self._error = error

    def _progress(self, _stage: str, fraction: float) -> bool:
        self.fraction = fraction
        return not self.cancelled
