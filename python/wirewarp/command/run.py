# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes all requests, and prints the result of each model."""

import json
import os
import sys
import time
from collections.abc import Generator, Iterator
from contextlib import closing, suppress

from tqdm import tqdm

from .apart import Stopped, each_apart
from .arguments import Arguments
from .flatten import flatten_model
from .propose import propose_for
from .request import AnyRequest, Request
from .staged import remove_staged, with_left
from .verdicts import EXIT_CODES, STOPPED, Line, unfinished

MODULES = ["trimesh", __name__]


class PrintError(Exception):
    """Raised if lines cannot be written to the standard output. str() is a sentence."""


def run(arguments: Arguments) -> int:
    """Print a line of JSON for each model, in the given order. Return the worst exit code. Raises PrintError."""
    # Matrices are small and there are many models, so threads for each matrix would only slow the run down.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    for request in with_left([each for each in arguments.requests if isinstance(each, Request)]):
        _remove_staged(request)  # now, because skipped models would keep their hidden folders
    worst = 0
    # With disable=None, the bar is drawn only if standard error is a terminal.
    with (
        tqdm(total=len(arguments.requests), unit="model", file=sys.stderr, disable=None) as bar,
        closing(_in_order(arguments, bar)) as lines,
    ):
        for line in lines:
            with tqdm.external_write_mode(sys.stdout):
                _print(line)
            worst = max(worst, EXIT_CODES[line["verdict"]])
    return worst


def _print(line: Line) -> None:
    try:
        print(json.dumps(line), flush=True)  # written in ASCII, which every console can show
    except OSError as error:
        raise PrintError(f"The lines cannot be printed: {error.strerror or error}") from error


def _in_order(arguments: Arguments, bar: "tqdm[None]") -> Generator[Line, None, None]:
    begun: dict[int, AnyRequest] = {}

    def begin() -> Iterator[AnyRequest]:
        for number, request in enumerate(arguments.requests):
            begun[number] = request
            yield request

    ended: dict[int, Line] = {}
    following = 0
    results = each_apart(timed, begin(), arguments.jobs, arguments.limits, MODULES)
    try:
        for number, result in results:
            ended[number] = _line(begun.pop(number), result)
            bar.update()
            while following in ended:
                yield ended.pop(following)
                following += 1
    finally:
        results.close()
        for request in begun.values():  # unfinished, because the run was stopped
            _remove_staged(request)


def timed(request: AnyRequest) -> Line:
    begin = time.monotonic()
    line = flatten_model(request) if isinstance(request, Request) else propose_for(request)
    return {**line, "seconds": round(time.monotonic() - begin, 3)}


def _line(request: AnyRequest, result: Line | Stopped) -> Line:
    if isinstance(result, Stopped):
        _remove_staged(request)
        result = {**unfinished(STOPPED, result.code, result.sentence), "seconds": round(result.seconds, 3)}
    return {"model": str(request.model), **result}


def _remove_staged(request: AnyRequest) -> None:
    if isinstance(request, Request):
        with suppress(OSError):  # the next run of this model tries again and reports the fault
            remove_staged(request)
