# SPDX-License-Identifier: GPL-3.0-or-later
"""Nesting by spyrrow, where it is installed, in a process that can be stopped."""

import importlib.util
import json
import math
import queue
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Generator, Iterator, Sequence
from pathlib import Path
from typing import IO

import numpy as np

from .motion import Motion
from .nest_items import Grain, Item, angles
from .slide_packing import Place

PROGRAM = Path(__file__).with_name("spyrrow_process.py")
OFTEN = 0.1  # seconds between chances to stop
OVERTIME = 5.0  # seconds for which a search that does not end by itself is waited for
NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # of Windows, which shows a console otherwise


class SpyrrowError(Exception):
    """str() says what it stumbled over."""


def is_installed() -> bool:
    return importlib.util.find_spec("spyrrow") is not None


def searched(
    items: Sequence[Item], grain: Grain, width: float, seconds: float
) -> Generator[list[Place] | None, None, None]:
    """Ever better places on a roll; None at least every tenth of a second while there are no new ones.

    The search ends when its time is over, and when the iterator is closed. Raises SpyrrowError.
    """
    spec = importlib.util.find_spec("spyrrow")
    assert spec is not None and spec.origin is not None
    task = {
        "library": str(Path(spec.origin).parents[1]),
        "width": width,
        "seconds": max(math.ceil(seconds), 1),
        "items": [_described(item, grain) for item in items],
    }
    with tempfile.TemporaryFile() as said:
        try:
            process = subprocess.Popen(
                [sys.executable, "-I", str(PROGRAM)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=said,
                text=True,
                encoding="utf-8",
                creationflags=NO_WINDOW,
            )
        except OSError as error:
            raise SpyrrowError(f"{sys.executable} does not run: {error.strerror}") from error
        try:
            yield from _read(process, json.dumps(task), seconds + OVERTIME, width)
            if process.poll():
                said.seek(0)
                lines = said.read().decode("utf-8", errors="replace").strip().splitlines()
                raise SpyrrowError(lines[-1] if lines else f"its process ended with {process.returncode}")
        finally:
            process.kill()
            process.wait()


def _described(item: Item, grain: Grain) -> dict[str, object]:
    """Its strip has x along the cloth: everything is turned by -90 degrees there."""
    allowed = None if grain == "free" else [angle % 360.0 for angle in angles(item, grain, math.inf)]
    return {"outline": item.turned(-90.0).tolist(), "count": item.count, "angles": allowed}


def _read(process: "subprocess.Popen[str]", task: str, seconds: float, width: float) -> Iterator[list[Place] | None]:
    assert process.stdin is not None and process.stdout is not None
    try:
        process.stdin.write(task)
        process.stdin.close()
    except OSError:  # it is ending already, and has said why
        process.wait()
        return
    lines: queue.Queue[str | None] = queue.Queue()
    threading.Thread(target=_hand_over, args=(process.stdout, lines), daemon=True).start()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            line = lines.get(timeout=OFTEN)
        except queue.Empty:
            yield None
            continue
        if line is None:
            process.wait()
            return
        back = Motion(np.array([width, 0.0]), 90.0)
        yield [Place(number, turn, back.points(np.array([x, y])), 0) for number, turn, x, y in json.loads(line)]


def _hand_over(output: IO[str], lines: "queue.Queue[str | None]") -> None:
    for line in output:
        lines.put(line)
    lines.put(None)
