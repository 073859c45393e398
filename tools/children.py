# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends everything that `dev` has started: each process is asked to end, and killed if it does not.

Linux only. It also finds children that have left our process group, such as Blender on its virtual screen.
"""

import ctypes
import os
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PR_SET_CHILD_SUBREAPER = 36  # from <linux/prctl.h>
PATIENCE = 10.0  # seconds to end, so that apt and pip leave nothing incomplete


@contextmanager
def no_child_left() -> Iterator[None]:
    """Treat SIGTERM and SIGHUP like Ctrl+C, a KeyboardInterrupt. At the end, every process below this one ends.

    Later signals are ignored.
    """
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    if ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0):
        # orphans of our children become our children
        raise OSError(ctypes.get_errno(), "prctl(PR_SET_CHILD_SUBREAPER)")
    try:
        yield
    finally:
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)
        _end_children()


def _end_children() -> None:
    begin = time.monotonic()
    while below := _processes_below(os.getpid()):
        too_long = time.monotonic() - begin > PATIENCE
        for process in below:
            _send(process, signal.SIGKILL if too_long else signal.SIGTERM)
        time.sleep(0.1)


def _processes_below(ancestor: int) -> list[int]:
    """Return the ids of all descendants, and reap children that have ended."""
    children: dict[int, list[int]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            state, parent = (folder / "stat").read_text().rpartition(")")[2].split()[:2]
        except (FileNotFoundError, ProcessLookupError):
            continue  # the process has ended in the meantime
        process = int(folder.name)
        if state != "Z":
            children.setdefault(int(parent), []).append(process)
        elif int(parent) == ancestor:
            os.waitpid(process, os.WNOHANG)
    found = children.get(ancestor, [])
    for process in found:  # the loop appends the children of each process
        found += children.get(process, [])
    return found


def _send(process: int, number: signal.Signals) -> None:
    try:
        os.kill(process, number)
    except ProcessLookupError:
        return  # the process has ended in the meantime
