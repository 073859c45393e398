# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the cost of work in this process: CPU seconds and peak memory. Works on Linux only."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

Answer = TypeVar("Answer")


def resident_megabytes(line: str) -> float:
    """Return the memory of the process. line: VmRSS for the present memory, VmHWM for its peak since the last reset."""
    status = Path("/proc/self/status").read_text().splitlines()
    return int(next(text for text in status if text.startswith(line)).split()[1]) / 1024


def cost_of(work: Callable[[], Answer]) -> tuple[Answer, float, float]:
    """Return the result of the work, the CPU seconds of all threads, and the peak of the added memory in megabytes."""
    Path("/proc/self/clear_refs").write_text("5")  # resets the peak (VmHWM) to the present memory (VmRSS)
    before = resident_megabytes("VmRSS")
    begin = time.process_time()
    answer = work()
    seconds = time.process_time() - begin
    return answer, seconds, resident_megabytes("VmHWM") - before
