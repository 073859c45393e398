# SPDX-License-Identifier: GPL-3.0-or-later
"""What a piece of work costs this process: seconds of one core, and memory at its peak. Linux only."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

Answer = TypeVar("Answer")


def resident_megabytes(line: str) -> float:
    """VmRSS, or VmHWM: the most since it was reset."""
    status = Path("/proc/self/status").read_text().splitlines()
    return int(next(text for text in status if text.startswith(line)).split()[1]) / 1024


def cost_of(work: Callable[[], Answer]) -> tuple[Answer, float, float]:
    """The answer, CPU seconds of all threads and of the system for them, and megabytes above those there were before.

    CPU seconds, since other work on the machine lengthens those of the clock.
    """
    Path("/proc/self/clear_refs").write_text("5")  # VmHWM becomes VmRSS
    before = resident_megabytes("VmRSS")
    begin = time.process_time()
    answer = work()
    seconds = time.process_time() - begin
    return answer, seconds, resident_megabytes("VmHWM") - before
