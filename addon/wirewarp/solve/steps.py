# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs work in steps, between which the window responds, because Blender does not allow Python threads.

Steps are generators that yield the completed share of work.

- To cancel, throw CanceledError into the steps. If only optional work is left, they end with the result so far.
- To discard the work, close the steps.
- The caller must always close the steps, because the traceback of an error would keep them alive.
"""

import time
from collections.abc import Callable, Generator
from contextlib import closing
from functools import partial
from typing import TypeVar

SLICE = 0.04  # seconds of work between two updates of the window, so that it is drawn about 20 times a second
POLL = 0.001  # longest time in seconds until the end of a job is noticed
S = TypeVar("S")
T = TypeVar("T")
Steps = Generator[float, None, T]  # yields the completed share, from 0 to 1


class CanceledError(Exception):
    """Raised if the user has canceled the work."""


def reported_as(steps: Generator[S, None, T], share: Callable[[S], float]) -> Steps[T]:
    """Do these steps, but yield the completed share of the whole work. share: converts a yielded value to this
    share."""
    with closing(steps):
        go_on = partial(next, steps)
        while True:
            try:
                yielded = go_on()
            except StopIteration as end:
                result: T = end.value
                return result
            go_on = partial(next, steps)
            try:
                yield share(yielded)
            except CanceledError as canceled:
                go_on = partial(steps.throw, canceled)


def of_all(done: int, count: int, share: float) -> float:
    """Return the completed share of work in several parts. done: number of finished parts; count: number of all parts;
    share: completed share of the current part."""
    return (done + share) / count


def in_slices(steps: Generator[S, None, T]) -> Generator[S, None, T]:
    """Do these steps in groups, each of which fills a slice of time. Yield the last value of each group."""
    with closing(steps):
        while True:
            end = time.monotonic() + SLICE
            try:
                yielded = next(steps)
                while time.monotonic() < end:
                    yielded = next(steps)
            except StopIteration as done:
                result: T = done.value
                return result
            yield yielded


def in_one_go(steps: Generator[S, None, T], show: Callable[[S], object] = lambda _yielded: None) -> T:
    """Do all steps while Blender waits, and return the result. show: called with each yielded value."""
    with closing(steps):
        while True:
            try:
                show(next(steps))
            except StopIteration as end:
                result: T = end.value
                return result
            time.sleep(POLL)
