# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every model in its own process. A crash, a hang or too much memory affects no other model.

Pools (multiprocessing, pebble) are not used: a worker killed at a wrong moment breaks its pool.
"""

import itertools
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from typing import Generic, TypeVar

import psutil

# The main process is never forked, because threads of libraries do not survive a fork.
if sys.platform == "win32":
    CONTEXT = multiprocessing.get_context("spawn")  # Windows has no fork, so each process loads the libraries
    MOST = 60  # largest number of processes, because Windows can wait for at most 63 at once
else:
    CONTEXT = multiprocessing.get_context("forkserver")  # loads libraries once, so processes start in milliseconds
    MOST = sys.maxsize
OFTEN = 0.5  # seconds between checks of time and memory; a check takes milliseconds
LEAVE = 5.0  # seconds that a process may need to end after its result or after a kill
Item = TypeVar("Item")
Result = TypeVar("Result")


@dataclass(frozen=True)
class Limits:
    seconds: float
    memory: int  # bytes, including the memory of Blender


@dataclass(frozen=True)
class Stopped:
    """The reason why a process ended without a result."""

    code: str  # "time_limit", "memory_limit" or "crashed"
    sentence: str
    seconds: float


def each_apart(
    work: Callable[[Item], Result], items: Iterable[Item], jobs: int, limits: Limits, modules: list[str]
) -> Generator[tuple[int, Result | Stopped], None, None]:
    """Yield the index and the result of each item as soon as its work ends.

    If the caller closes the generator or is killed, all processes end.

    - work: function of a module that other processes can import
    - jobs: number of processes at a time
    - modules: names of modules to load once for all processes
    """
    CONTEXT.set_forkserver_preload(modules)
    if sys.platform != "win32":
        resource_tracker.ensure_running()  # before Ctrl+C is blocked, because starting the tracker unblocks Ctrl+C
    waiting = enumerate(items)
    running: list[_Run[Result]] = []
    looked = time.monotonic()
    try:
        while True:
            results = []
            with _ctrl_c_waits():
                for number, item in itertools.islice(waiting, min(jobs, MOST) - len(running)):
                    running.append(_Run(number, work, item))
                if not running:
                    return
                wait([run.results for run in running], OFTEN)
                is_time = time.monotonic() - looked > OFTEN
                looked = time.monotonic() if is_time else looked
                for run in list(running):
                    ended = run.ended() or (run.stopped_by(limits) if is_time else None)
                    if ended:
                        running.remove(run)
                        results.append((run.number, ended[0]))
            yield from results
    finally:
        with _ctrl_c_waits():
            for run in running:
                run.kill()


@contextmanager
def _ctrl_c_waits() -> Iterator[None]:
    """Delay Ctrl+C until the end of the block. Otherwise, a process that starts or ends could be left behind.

    The fork server inherits the blocked signal, because it starts inside the first block.
    """
    pressed: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, _: pressed.append(number))
    masked = None if sys.platform == "win32" else signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        if masked is not None:
            signal.pthread_sigmask(signal.SIG_SETMASK, masked)
        signal.signal(signal.SIGINT, before)
    if pressed and callable(before):  # not callable if Ctrl+C was ignored before, as in the background of a shell
        before(signal.SIGINT, None)


class _Run(Generic[Result]):
    def __init__(self, number: int, work: Callable[[Item], Result], item: Item) -> None:
        self.number, self._begin = number, time.monotonic()
        self.results, sender = CONTEXT.Pipe(duplex=False)
        self._process = CONTEXT.Process(target=_do, args=(work, item, sender))
        self._process.start()
        sender.close()  # only the other process keeps this end, so the pipe closes when that process ends

    def ended(self) -> tuple[Result | Stopped] | None:
        try:
            if not self.results.poll():
                return None
            result: Result | Stopped = self.results.recv()
        except (EOFError, OSError):  # the other process has closed the pipe; on Windows, poll() raises the error
            self._process.join()
            result = Stopped("crashed", _crash(self._process.exitcode), self._seconds())
        self._close()
        return (result,)

    def stopped_by(self, limits: Limits) -> tuple[Stopped] | None:
        seconds = self._seconds()
        if seconds > limits.seconds:
            sentence = f"The model took longer than {limits.seconds:g} seconds: see --time-limit."
            stopped = Stopped("time_limit", sentence, seconds)
        elif _memory(self._process.pid) > limits.memory:
            most = f"{limits.memory / 1e9:.3g} GB"
            stopped = Stopped("memory_limit", f"The model needed over {most} of memory: see --memory-limit.", seconds)
        else:
            return None
        self.kill()
        return (stopped,)

    def _seconds(self) -> float:
        return time.monotonic() - self._begin

    def kill(self) -> None:
        family = _family(self._process.pid)
        for process in family:
            with suppress(psutil.Error):
                process.kill()
        psutil.wait_procs(family[1:], LEAVE)
        self._close()

    def _close(self) -> None:
        self.results.close()
        self._process.join(LEAVE)
        if self._process.exitcode is None:
            self._process.kill()
            self._process.join()
        self._process.close()


def _do(work: Callable[[Item], Result], item: Item, sender: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent ends this process on Ctrl+C
    threading.Thread(target=_end_with_parent, daemon=True).start()
    sender.send(work(item))


def _end_with_parent() -> None:
    """End this process when its parent ends, because a killed parent cannot send a message."""
    parent = multiprocessing.parent_process()
    if parent:
        parent.join()
        os._exit(1)


def _family(pid: int | None) -> list[psutil.Process]:
    try:
        process = psutil.Process(pid)
        return [process, *process.children(recursive=True)]
    except psutil.NoSuchProcess:
        return []


def _memory(pid: int | None) -> int:
    total = 0
    for process in _family(pid):
        with suppress(psutil.Error):
            total += process.memory_info().rss
    return total


def _crash(code: int | None) -> str:
    if code is None or code >= 0:
        return f"The model's process ended with code {code}."
    name = signal.Signals(-code).name if -code in set(signal.Signals) else str(-code)
    hint = ", probably because memory ran out" if name == "SIGKILL" else ""
    return f"The model's process was ended by {name}{hint}."
