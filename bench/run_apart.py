# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a process of its own, which may crash or be stopped when its time is over."""

import contextlib
import multiprocessing
import os
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import TypeVar

Answer = TypeVar("Answer")
PROCESSES = multiprocessing.get_context("fork")  # the work finds all that was loaded and made before


class NoAnswerError(Exception):
    """The work raised an error, ended its process or took too long; the message says which, in a clause."""


def run_apart(work: Callable[[], Answer], limit: float) -> Answer:
    """What the work returns, which must be picklable; limit in seconds by the clock."""
    receiver, sender = PROCESSES.Pipe(duplex=False)
    process = PROCESSES.Process(target=send_answer, args=(work, sender))
    process.start()
    sender.close()
    try:
        if not receiver.poll(limit):
            raise NoAnswerError(f"over {limit:,.0f} s")
        is_error, answer = receiver.recv()
    except EOFError:
        process.join()
        raise NoAnswerError(f"the process ended with code {process.exitcode}") from None
    finally:
        stop(process)
    if is_error:
        raise NoAnswerError(answer)
    return answer


def send_answer(work: Callable[[], Answer], sender: Connection) -> None:
    os.setsid()  # so that stop() also reaches the processes that the work starts
    try:
        sender.send((False, work()))
    except Exception as error:  # whatever it is belongs into the table, beside the other methods
        sender.send((True, str(error) or type(error).__name__))


def stop(process: multiprocessing.Process) -> None:
    with contextlib.suppress(ProcessLookupError):  # it has ended, or has not come to setsid()
        os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.join()
