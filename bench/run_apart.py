# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs work in another process, which may crash or be stopped at its time limit."""

import contextlib
import multiprocessing
import os
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import TypeVar

Answer = TypeVar("Answer")
PROCESSES = multiprocessing.get_context("fork")  # forked processes have all modules and data loaded so far


class NoAnswerError(Exception):
    """The work raised an error, ended its process or took too long; the message names the reason in a clause."""


def run_apart(work: Callable[[], Answer], limit: float) -> Answer:
    """Return the result of the work, which must be picklable. limit: seconds of wall time."""
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
    os.setsid()  # so that stop() also reaches processes that the work starts
    try:
        sender.send((False, work()))
    except Exception as error:  # any error becomes an entry of the table
        sender.send((True, str(error) or type(error).__name__))


def stop(process: multiprocessing.Process) -> None:
    with contextlib.suppress(ProcessLookupError):  # it has ended, or has not called setsid() yet
        os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.join()
