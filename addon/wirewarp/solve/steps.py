# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs work in steps, between which the window responds: generators that yield the completed share of the work.

To stop the steps, throw CanceledError into them. An optional part then ends with the result so far. To discard
the steps, close them; files do not change. The caller always closes them, because the traceback of an error would
keep them alive. Python threads are not used, because Blender does not allow them; the core has its own threads. Does
not use Blender.
"""

import time
from collections.abc import Callable, Generator
from contextlib import closing
from functools import partial
from typing import TypeVar

SLICE = 0.04  # seconds of work between two updates of the window, so that it is drawn 20 times a second
POLL = 0.001  # longest time in seconds until the end of a job is noticed
S = TypeVar("S")
T = TypeVar("T")
Steps = Generator[float, None, T]  # yields the completed share, from 0 to 1


class CanceledError(Exception):
    """The user canceled the work; there is no result unless one existed before."""


def reported_as(steps: Generator[S, None, T], share: Callable[[S], float]) -> Steps[T]:
    """Return the same steps with converted shares. share: converts a yielded value to the completed share of the
    whole."""
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
    """Return the share of all parts of the work. done: finished parts; share: completed share of the next."""
    return (done + share) / count


def in_slices(steps: Generator[S, None, T]) -> Generator[S, None, T]:
    """Group the steps, so that each group fills a slice of time."""
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
    """Do all steps while Blender waits. show: called with each yielded value."""
    with closing(steps):
        while True:
            try:
                show(next(steps))
            except StopIteration as end:
                result: T = end.value
                return result
            time.sleep(POLL)
