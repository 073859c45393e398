# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens many small models twice: undisturbed, and interrupted by kill -9. The files of both runs must be equal.

Usage on Linux: python tests/bindings/many_models.py COUNT FOLDER [--jobs N]
"""

import argparse
import fcntl
import hashlib
import json
import os
import random
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np
import psutil

KILLS = ("worker", "driver", "worker")
SMALL_PIPE = 4096  # bytes, about ten lines; a full pipe halts the run, so that it cannot end before it is killed


def write_models(folder, count):
    """Write OBJ files of sheets of 50 to 200 triangles, in folders of a hundred files.

    Every 20th model is closed and cannot be flattened. Every 50th file is not a model.
    """
    for number in range(count):
        path = folder / f"{number // 100:03d}" / f"model {number:05d}.obj"
        path.parent.mkdir(parents=True, exist_ok=True)
        if number % 50 == 49:
            path.write_text("nothing\n")
        else:
            path.write_text(_ball() if number % 20 == 19 else _sheet(np.random.default_rng(number)))


def _sheet(random_numbers):
    """Return a sheet 100 mm wide, with 5 to 10 squares in each direction. Its UV map has one or two islands."""
    columns, rows = random_numbers.integers(5, 11, 2)
    x, y = np.meshgrid(np.linspace(0, 0.1, columns + 1), np.linspace(0, 0.1, rows + 1))
    phase, bump = random_numbers.random(2) * 6, random_numbers.random() * 0.02
    z = bump * np.sin(30 * x + phase[0]) * np.cos(30 * y + phase[1])
    lines = [f"v {a!r} {b!r} {c!r}" for a, b, c in np.column_stack([x.ravel(), y.ravel(), z.ravel()]).tolist()]
    lines += [f"vt {u!r} {v!r}" for u, v in np.column_stack([x.ravel(), y.ravel()]).tolist()]
    lines += [f"vt {u + 1!r} {v!r}" for u, v in np.column_stack([x.ravel(), y.ravel()]).tolist()]
    cut = random_numbers.integers(0, columns)  # number of columns in the first island; if it is 0, there is only one
    wide, count = columns + 1, (columns + 1) * (rows + 1)
    for row in range(rows):
        for column in range(columns):
            first = row * wide + column + 1
            island = count if column < cut else 0
            corners = (first, first + 1, first + wide + 1, first + wide)
            lines.append("f " + " ".join(f"{corner}/{corner + island}" for corner in corners))
    return "\n".join(lines) + "\n"


def _ball():
    """Return a closed box whose UV map is a single point."""
    corners = [(x, y, z) for x in (0, 0.1) for y in (0, 0.1) for z in (0, 0.1)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["vt 0 0"]
    for face in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)):
        lines.append("f " + " ".join(f"{corner}/1" for corner in face))
    return "\n".join(lines) + "\n"


def start(models, out, jobs):
    words = ["batch", models, "--out", out, "--seams", "uv", "--format", "svg", "--jobs", jobs]
    process = subprocess.Popen(
        [sys.executable, "-m", "wirewarp", *map(str, words)],
        stdout=subprocess.PIPE,
        text=True,
        env=os.environ | {"SOURCE_DATE_EPOCH": "0"},  # a fixed date, so that both runs write equal files
    )
    fcntl.fcntl(process.stdout, fcntl.F_SETPIPE_SZ, SMALL_PIPE)
    return process


def run(models, out, jobs):
    with start(models, out, jobs) as process:
        return [json.loads(line) for line in process.stdout]


def run_with_kills(models, out, jobs, seed=0):
    """Kill workers and drivers, and run again until all models are done.

    Return the printed lines of the last run, and the list of kills.
    """
    count = sum(1 for _ in models.rglob("*.obj"))
    # Each kill is at a later line than the kill before it, because a repeated run prints the lines of finished models
    # again. All kills are in the first half of the models.
    places = sorted(random.Random(seed).sample(range(1, count // 2), len(KILLS)))
    killed = []
    while len(killed) < len(KILLS):
        with start(models, out, jobs) as process:
            for number, _ in enumerate(process.stdout):
                if len(killed) < len(KILLS) and number >= places[len(killed)]:
                    killed += _kill(process.pid, KILLS[len(killed)])
        # Exit codes: -9 if the driver was killed, 3 if a worker was killed, otherwise 2, as some files are not models.
        assert process.returncode in (-9, 2, 3), process.returncode
    while any(line["verdict"] == "stopped" for line in run(models, out, jobs)):
        pass  # repeats until every interrupted model is finished
    # A process that ends just after its driver may leave a hidden folder, which the next run removes.
    return run(models, out, jobs), killed


def _kill(driver, kind):
    """Kill a process of this kind. Return [kind], or [] if no such process runs, for example between two models."""
    if kind == "driver":
        os.kill(driver, 9)
        return [kind]
    for process in psutil.Process(driver).children(recursive=True):
        try:
            if process.ppid() != driver and process.status() != psutil.STATUS_ZOMBIE:
                process.kill()
                return [kind]
        except psutil.NoSuchProcess:
            pass
    return []


def contents(folder):
    """Return the digests of all files, including hidden files, keyed by name."""
    files = (path for path in folder.rglob("*") if path.is_file() or path.name.startswith("."))
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def comparable(lines):
    """Return the lines keyed by model, without values that differ between runs."""
    return {line["model"]: {key: line[key] for key in line if key not in ("seconds", "skipped")} for line in lines}


def check_kills(folder, count, jobs):
    """Flatten models without and with kills. Check that no model is lost or duplicated, and that the files are equal.

    Return the seconds without kills, the seconds with kills, and the number of each verdict.
    """
    models = folder / "models"
    write_models(models, count)
    begin = time.monotonic()
    once = run(models, folder / "once", jobs)
    between = time.monotonic()
    lines, killed = run_with_kills(models, folder / "killed", jobs)
    end = time.monotonic()
    assert tuple(killed) == KILLS
    assert len(once) == len(lines) == len(comparable(lines)) == count
    assert comparable(lines) == comparable(once)
    verdicts = Counter(line["verdict"] for line in lines)
    refused = count // 50
    failed = count // 20 - count // 100  # every 100th file is a 20th and a 50th file, so it is not a model
    assert (verdicts["refused"], verdicts["not ready to cut"]) == (refused, failed)
    assert verdicts["ready to cut"] + verdicts["needs stretch fabric"] == count - refused - failed
    assert contents(folder / "killed") == contents(folder / "once")
    return between - begin, end - between, verdicts


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("count", type=int)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    seconds, seconds_killed, found = check_kills(given.folder, given.count, given.jobs)
    print(f"{given.count} models, {dict(found)}: {seconds:.0f} s; {', '.join(KILLS)} killed: {seconds_killed:.0f} s")
