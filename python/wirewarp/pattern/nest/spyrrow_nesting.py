# SPDX-License-Identifier: GPL-3.0-or-later
"""Nests with spyrrow, if it is installed, in a separate process that can be stopped."""

import importlib.util
import json
import math
import subprocess
import sys
import time
from collections.abc import Generator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from ..geometry import Motion
from .items import Grain, Item, angles
from .slide_packing import Place

PROGRAM = Path(__file__).with_name("spyrrow_process.py")
OFTEN = 0.02  # seconds between checks for results
OVERTIME = 5.0  # seconds to wait for a search that does not end by itself
NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # hides the console on Windows; other systems lack the flag


class SpyrrowError(Exception):
    """Raised if spyrrow fails. str() is its error."""


def is_installed() -> bool:
    return importlib.util.find_spec("spyrrow") is not None


def searched(
    items: Sequence[Item], grain: Grain, width: float, seconds: float
) -> Generator[list[Place] | None, None, None]:
    """Yield better and better places on a roll, and None after a short time without new places. The search ends when
    its time is over or when the generator is closed. Raises SpyrrowError."""
    spec = importlib.util.find_spec("spyrrow")
    assert spec is not None and spec.origin is not None
    task = {
        "library": str(Path(spec.origin).parents[1]),
        "width": width,
        "seconds": max(math.ceil(seconds), 1),
        "items": [_described(item, grain) for item in items],
    }
    # Data is exchanged in files, because some systems cannot check a pipe for data without a thread.
    with TemporaryDirectory(prefix="wirewarp-") as folder:
        given, found, said = (Path(folder) / name for name in ("given", "found", "said"))
        given.write_text(json.dumps(task), encoding="utf-8")
        with found.open("wb") as writes, said.open("wb") as complains:
            try:
                process = subprocess.Popen(
                    [sys.executable, "-I", str(PROGRAM), str(given)],
                    # Nothing is written to this pipe. It closes when this process is killed, and the search then ends.
                    stdin=subprocess.PIPE,
                    stdout=writes,
                    stderr=complains,
                    creationflags=NO_WINDOW,
                )
            except OSError as error:
                raise SpyrrowError(f"{sys.executable} does not run: {error.strerror}") from error
        with process:
            try:
                yield from _read(process, found, seconds + OVERTIME, width)
                if process.poll():
                    lines = said.read_text(encoding="utf-8", errors="replace").strip().splitlines()
                    raise SpyrrowError(lines[-1] if lines else f"its process ended with {process.returncode}")
            finally:
                process.kill()


def _described(item: Item, grain: Grain) -> dict[str, object]:
    """Return an item for spyrrow, turned by -90 degrees, because spyrrow has x along the fabric."""
    allowed = None if grain == "free" else [angle % 360.0 for angle in angles(item, grain, math.inf)]
    return {"outline": item.turned(-90.0).tolist(), "count": item.count, "angles": allowed}


def _read(
    process: "subprocess.Popen[bytes]", found: Path, seconds: float, width: float
) -> Generator[list[Place] | None, None, None]:
    back = Motion(np.array([width, 0.0]), 90.0)
    end, line, has_ended = time.monotonic() + seconds, b"", False
    with found.open("rb") as lines:
        while not has_ended and time.monotonic() < end:
            has_ended = process.poll() is not None  # checked before reading, so that the last lines are read
            for part in lines:
                line += part  # the last line may be incomplete
                if line.endswith(b"\n"):
                    places, line = json.loads(line), b""
                    yield [Place(number, turn, back.points(np.array([x, y])), 0) for number, turn, x, y in places]
            yield None
            time.sleep(OFTEN)
