# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends every process that `dev` has started, even if it has left the process group of `dev`. Works on Linux only."""

import ctypes
import os
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PR_SET_CHILD_SUBREAPER = 36  # from <linux/prctl.h>
PATIENCE = 10.0  # seconds before a process is killed, so that apt and pip can finish what they write


@contextmanager
def no_child_left() -> Iterator[None]:
    """Return a context that ends all processes that were started inside it.

    In the context, SIGTERM and SIGHUP raise KeyboardInterrupt as Ctrl+C does. While the processes end, signals are
    ignored.
    """
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    # With this setting, orphans of our children become our children.
    if ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0):
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
