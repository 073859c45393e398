# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs spyrrow on a file with a task, and prints each better solution as a line of JSON.

spyrrow needs its own process, because a search cannot be canceled and a panic ends the process.
"""

import json
import os
import shutil
import sys
import threading
import time
from pathlib import Path
from typing import Any

OFTEN = 0.1  # seconds between checks for better solutions


def main() -> None:
    path = Path(sys.argv[1])
    task = json.loads(path.read_text(encoding="utf-8"))
    sys.path.insert(0, task["library"])
    import spyrrow

    threading.Thread(target=_end_with_caller, args=(path.parent,), daemon=True).start()
    items = [
        spyrrow.Item(str(number), [tuple(point) for point in each["outline"]], each["count"], each["angles"])
        for number, each in enumerate(task["items"])
    ]
    instance = spyrrow.StripPackingInstance("", task["width"], items)
    # The seed is fixed, but the time limit still makes each search different.
    config = spyrrow.StripPackingConfig(total_computation_time=task["seconds"], seed=1)
    reports = spyrrow.ProgressQueue()
    failures: list[BaseException] = []
    search = threading.Thread(target=_solve, args=(instance, config, reports, failures), daemon=True)
    search.start()
    best = float("inf")
    while True:
        is_over, better = not search.is_alive(), None
        for kind, solution in reports.drain():
            is_feasible = kind in (spyrrow.ReportType.ExplFeas, spyrrow.ReportType.CmprFeas, spyrrow.ReportType.Final)
            if is_feasible and solution.width < best:
                best, better = solution.width, solution
        if better:
            placed = [[int(each.id), each.rotation, *each.translation] for each in better.placed_items]
            print(json.dumps(placed), flush=True)
        if failures:
            sys.exit(f"{type(failures[0]).__name__}: {failures[0]}")
        if is_over:
            return
        time.sleep(OFTEN)


def _end_with_caller(folder: Path) -> None:
    """End this process when its caller ends. The standard input closes then, and nobody writes to it earlier, so
    reading it waits until then.

    folder: folder with the task, which is removed.
    """
    os.read(0, 1)  # waits; reading sys.stdin would hold a lock that keeps Python from ending
    shutil.rmtree(folder, ignore_errors=True)  # Windows keeps files that this process has open
    os._exit(1)


def _solve(instance: Any, config: object, reports: object, failures: list[BaseException]) -> None:  # noqa: ANN401
    try:
        instance.solve(config, reports)
    except BaseException as error:  # a panic of Rust is not an Exception
        failures.append(error)


if __name__ == "__main__":
    main()
