# SPDX-License-Identifier: GPL-3.0-or-later
"""Contains functions that tests run in other processes."""

import os
import signal
import subprocess
import sys
import time


def square_or_crash(number):
    """Return the square of a number. 13 ends the process like a crash in C++, and 14 raises an exception."""
    if number == 13:
        os.kill(os.getpid(), getattr(signal, "SIGSEGV", signal.SIGABRT))
    if number == 14:
        raise ZeroDivisionError
    return number**2


def hang_or_wait(task):
    """Do one of these tasks:

    - ("hang", path): start a process, write its id to the path, and hang.
    - ("wait", path): wait until a file exists at the path.
    """
    kind, path = task
    if kind == "hang":
        other = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(3600)"])
        path.with_suffix(".part").write_text(str(other.pid))
        path.with_suffix(".part").replace(path)
        time.sleep(3600)
    while not path.is_file():
        time.sleep(0.01)


def take_memory_and_hang(size):
    taken = bytearray(os.urandom(1) * size)
    time.sleep(3600)
    return len(taken)
