# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes the machine on which the figures of a page were measured."""

import os
import platform
from pathlib import Path


def machine() -> str:
    cpu = next(line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{cpu.partition(':')[2].strip()}, {os.cpu_count()} cores, {memory:.0f} GiB, {platform.system()}"
