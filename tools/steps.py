# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the steps of ./dev test: named steps one after the other, otherwise two steps at a time.

nox is not used, because it runs one session at a time and knows no dependencies.
"""

import multiprocessing
import os
import signal
import sys
import time
import traceback
from collections.abc import Callable, Container, Iterable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from multiprocessing.connection import wait
from multiprocessing.context import ForkProcess

from tools.environment import BUILD, NotTestedError, StepError, say

PASSED, FAILED, NOT_TESTED = "passed", "FAILED", "NOT TESTED"
EXIT_CODES: dict[int | None, str] = {0: PASSED, 1: FAILED, 2: NOT_TESTED}
LOGS = BUILD / "log"
AT_ONCE = 2  # number of steps at a time: more than one, because a step may use only one core
FAILURE_LINES = 400  # number of last lines shown of a failed step, enough for some failed tests with their values
PROCESSES = multiprocessing.get_context("fork")


class When(IntEnum):
    """Says which runs of ./dev test include a step that they do not name."""

    ALWAYS = 0
    ALL = 1  # only in ./dev test --all
    NAMED = 2  # in no run: the step must be named


@dataclass(frozen=True)
class Step:
    name: str
    work: Callable[[], None]  # raises StepError or NotTestedError
    after: str = ""  # name of the step whose builds this step uses
    when: When = When.ALWAYS


@dataclass(frozen=True)
class Outcome:
    name: str
    word: str
    seconds: float


def run_in_order(steps: Iterable[Step]) -> list[Outcome]:
    """Run the steps one after the other, and show their output while they run."""
    outcomes = []
    for step in steps:
        print(f"\n===== {step.name}", flush=True)
        begin = time.monotonic()
        word = _word_of(step)
        outcomes.append(Outcome(step.name, word, time.monotonic() - begin))
    return outcomes


def run_side_by_side(steps: Sequence[Step]) -> list[Outcome]:
    """Run each step in its own process, two at a time, with output in build/log. Return outcomes in the given order."""
    LOGS.mkdir(parents=True, exist_ok=True)
    waiting = list(steps)
    running: list[tuple[Step, ForkProcess, float]] = []
    outcomes: dict[str, Outcome] = {}
    while waiting or running:
        while len(running) < AT_ONCE and (step := _next(waiting, outcomes)):
            waiting.remove(step)
            process = PROCESSES.Process(target=_run_apart, args=(step,))
            process.start()
            running.append((step, process, time.monotonic()))
            say(f"{step.name} begins")
        ended = wait([process.sentinel for _, process, _ in running])
        for step, process, begin in [entry for entry in running if entry[1].sentinel in ended]:
            process.join()
            word = EXIT_CODES.get(process.exitcode, FAILED)
            outcomes[step.name] = Outcome(step.name, word, time.monotonic() - begin)
            say(f"{step.name} {outcomes[step.name].word}, as shown in {LOGS / step.name}")
        running = [entry for entry in running if entry[1].sentinel not in ended]
    return [outcomes[step.name] for step in steps]


def show_failed_steps(outcomes: Iterable[Outcome]) -> None:
    """Show the end of the output of each step that failed or was not tested."""
    for outcome in outcomes:
        if outcome.word != PASSED:
            lines = (LOGS / outcome.name).read_text(errors="replace").splitlines()
            print(f"\n===== {outcome.name}", *lines[-FAILURE_LINES:], sep="\n", flush=True)


def show(outcomes: Sequence[Outcome], seconds: float) -> None:
    """Print a table. seconds: wall time of all steps. Raises StepError if a step failed."""
    print("\n===== summary")
    for outcome in (*outcomes, Outcome("all", "", seconds)):
        print(f"{outcome.name:24} {outcome.word:10} {outcome.seconds:6.0f} s")
    if failed := [outcome.name for outcome in outcomes if outcome.word == FAILED]:
        raise StepError(f"failed: {', '.join(failed)}")


def _next(waiting: list[Step], ended: Container[str]) -> Step | None:
    return next((step for step in waiting if not step.after or step.after in ended), None)


def _word_of(step: Step) -> str:
    try:
        step.work()
    except NotTestedError as reason:
        say(f"{step.name} is NOT TESTED: {reason}")
        return NOT_TESTED
    except StepError as failure:
        say(str(failure))
        return FAILED
    return PASSED


def _run_apart(step: Step) -> None:
    """Run the step and end this process with the exit code of its outcome."""
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    with (LOGS / step.name).open("w", buffering=1) as log:
        os.dup2(log.fileno(), 1)  # also redirects the output of programs that the step starts
        os.dup2(log.fileno(), 2)
        sys.stdout = sys.stderr = log
        try:
            word = _word_of(step)
        except Exception:  # a fault of this program, which the end of the log then shows
            traceback.print_exc()
            word = FAILED
    sys.exit(next(code for code, name in EXIT_CODES.items() if name == word))
