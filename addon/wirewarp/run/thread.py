# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a thread that tells how far it is, and that can be cancelled. No Blender in here."""

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

from ..solve.flatten import Progress

T = TypeVar("T")


class CancelledError(Exception):
    """The user wants no result."""


class WorkThread(Generic[T]):
    """Begins at once. Whoever makes one must wait for its end, by join() or result()."""

    def __init__(self, work: Callable[[Progress], T]) -> None:
        self.fraction = 0.0  # of the whole, from 0 to 1
        self._cancelled = threading.Event()
        self._result: T | None = None
        self._error: BaseException | None = None
        self._thread = threading.Thread(target=self._run, args=(work,), name="WireWarp")
        self._thread.start()

    @property
    def cancelled(self) -> bool:
        return self._cancelled.is_set()

    def cancel(self) -> None:
        """Takes effect the next time the work tells of its progress."""
        self._cancelled.set()

    def is_done(self) -> bool:
        return not self._thread.is_alive()

    def join(self) -> None:
        self._thread.join()

    def result(self) -> T:
        """Of work that was done before cancel() took effect, too: what it wrote is there.

        Raises CancelledError if cancel() ended it, and what the work raised.
        """
        self.join()
        if self._error is None:
            return self._result
        if self.cancelled:
            raise CancelledError from self._error
        raise self._error

    def _run(self, work: Callable[[Progress], T]) -> None:
        try:
            self._result = work(self._progress)
        except BaseException as error:  # noqa: BLE001  result() raises it where somebody hears it
            self._error = error

    def _progress(self, _stage: str, fraction: float) -> bool:
        self.fraction = fraction
        return not self.cancelled
