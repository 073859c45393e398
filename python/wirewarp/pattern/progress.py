# SPDX-License-Identifier: GPL-3.0-or-later
"""Long tasks run in steps, as generators: between two steps, the caller can show progress or stop."""

import time
from collections.abc import Callable, Generator
from contextlib import closing
from typing import TypeVar

from .._errors import FlattenError

OFTEN = 0.1  # seconds between calls of progress: canceling takes at most 1 s, even if one step is slow
Progress = Callable[[str, float], bool | None]  # called with the stage and the completed share; returns False to stop
STAGES = {  # start of each stage of making and writing a pattern, as a share of the time for a garment of 20 pieces
    "allowance": 0.0,
    "marks and lines": 0.2,
    "texts": 0.3,
    "writing": 0.5,
    "sheets": 0.6,
    "reading again": 0.8,
}
T = TypeVar("T")
Steps = Generator[tuple[str, float], None, T]  # yields the arguments of progress before each step


def in_one_go(steps: Steps[T], progress: Progress | None = None) -> T:
    """Run all steps. Raises FlattenError "cancelled" if progress returns False, unless the steps handle it."""
    asked = 0.0
    with closing(steps):  # closes the steps even if progress raises
        try:
            while True:
                stage, fraction = next(steps)
                if progress and time.monotonic() - asked >= OFTEN:
                    asked = time.monotonic()
                    if progress(stage, fraction) is False:
                        steps.throw(FlattenError("cancelled", "Stopped before it was done."))
        except StopIteration as end:
            result: T = end.value
            return result
