# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs work in another process, which may crash, and which is stopped at a time limit."""

import contextlib
import multiprocessing
import os
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import TypeVar

Answer = TypeVar("Answer")
PROCESSES = multiprocessing.get_context("fork")  # a forked process has the modules and data of this process


class NoAnswerError(Exception):
    """The work raised an error, ended its process or took too long. The message is the reason."""


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
    except Exception as error:  # any error, because the tables list the errors of methods
        sender.send((True, str(error) or type(error).__name__))


def stop(process: multiprocessing.Process) -> None:
    with contextlib.suppress(ProcessLookupError):  # raised if the process has ended, or has not called setsid() yet
        os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.join()
