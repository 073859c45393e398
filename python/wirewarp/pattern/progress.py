# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs long tasks in steps. A task is a generator, so the caller can show progress or cancel between two steps."""

import time
from collections.abc import Callable, Generator
from contextlib import closing
from typing import TypeVar

from .._errors import FlattenError

OFTEN = 0.1  # least seconds between two calls of progress
Progress = Callable[[str, float], bool | None]  # gets the stage and the completed share; returns False to cancel
# Each stage of making and writing a pattern starts at this share of the total time, for a garment of 20 pieces.
STAGES = {
    "allowance": 0.0,
    "marks and lines": 0.2,
    "texts": 0.3,
    "writing": 0.5,
    "sheets": 0.6,
    "reading again": 0.8,
}
T = TypeVar("T")
Steps = Generator[tuple[str, float], None, T]  # yields the arguments of Progress before each step, returns a result


def in_one_go(steps: Steps[T], progress: Progress | None = None) -> T:
    """Run all steps and return the result. If progress returns False, FlattenError with the code "cancelled" is raised
    inside the steps, which may handle it."""
    asked = 0.0
    with closing(steps):  # closes the steps even if progress raises
        try:
            while True:
                stage, fraction = next(steps)
                if progress and time.monotonic() - asked >= OFTEN:
                    asked = time.monotonic()
                    if progress(stage, fraction) is False:
                        steps.throw(FlattenError("cancelled", "The task was canceled before it was finished."))
        except StopIteration as end:
            result: T = end.value
            return result
