# SPDX-License-Identifier: GPL-3.0-or-later
"""Whoever waits is told how far things are, and may stop them."""

import time
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from .._errors import FlattenError

OFTEN = 0.1  # seconds between questions: a stop is heard within a second even where one step takes long
Progress = Callable[[str, float], bool | None]  # stage, and the share of it that is done; False stops
T = TypeVar("T")


class Watch:
    def __init__(self, progress: Progress | None = None) -> None:
        self._progress, self._asked = progress, 0.0

    def each(self, items: Sequence[T], stage: str) -> Iterator[T]:
        """The items, one by one. Raises FlattenError ("cancelled") where the callback says False."""
        for number, item in enumerate(items):
            self.ask(stage, number / len(items))
            yield item

    def ask(self, stage: str, fraction: float) -> None:
        """Raises FlattenError as each()."""
        now = time.monotonic()
        if self._progress and now - self._asked >= OFTEN:
            self._asked = now
            if self._progress(stage, fraction) is False:
                raise FlattenError("cancelled", "Stopped before it was done.")
