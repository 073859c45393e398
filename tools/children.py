# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing that `dev` has started outlives it: it is asked to end, and killed if it does not.

Linux only. A child that leaves our process group, as Blender on its virtual screen does, is found all the same.
"""

import ctypes
import os
import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PR_SET_CHILD_SUBREAPER = 36  # of <linux/prctl.h>
PATIENCE = 10.0  # seconds to end in, so that apt and pip leave nothing half done


@contextmanager
def no_child_left() -> Iterator[None]:
    """SIGTERM and SIGHUP are inside what Ctrl+C is, a KeyboardInterrupt. In the end every process below this one ends.

    Signals that interrupt are ignored from then on.
    """
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    if ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0):
        raise OSError(ctypes.get_errno(), "prctl(PR_SET_CHILD_SUBREAPER)")  # by which orphans of our children are ours
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
    """Ids of the children, their children and so on; our own that have ended are taken leave of."""
    children: dict[int, list[int]] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            state, parent = (folder / "stat").read_text().rpartition(")")[2].split()[:2]
        except (FileNotFoundError, ProcessLookupError):
            continue  # has ended meanwhile
        process = int(folder.name)
        if state != "Z":
            children.setdefault(int(parent), []).append(process)
        elif int(parent) == ancestor:
            os.waitpid(process, os.WNOHANG)
    found = children.get(ancestor, [])
    for process in found:  # grows meanwhile
        found += children.get(process, [])
    return found


def _send(process: int, number: signal.Signals) -> None:
    try:
        os.kill(process, number)
    except ProcessLookupError:
        return  # has ended meanwhile
