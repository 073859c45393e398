# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs OptCuts, built from its public sources, and keeps its output in three files:

- NAME.obj: the surface with its flat shape as texture coordinates
- NAME.json: the PeerRun
- NAME.log: the messages
"""

import json
import os
import resource
import shutil
import subprocess
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

from mesh_files import read_obj

BOUND = 4.1  # maximum energy of a flat shape: the default of OptCuts and of its authors' benchmark
LIMIT = 600  # seconds of processor time for one surface
HEADLESS = "100"


@dataclass(frozen=True)
class PeerRun:
    seconds: float  # processor time of OptCuts
    without: str  # reason why OptCuts has no result; empty if it has one


def command(program: Path | str, mesh: Path | str, bound: float) -> list[str]:
    """Return the command. Its words, as in OptCuts' README: mode, mesh, first weight, name, method, bound, bijective,
    start.
    """
    return [str(program), HEADLESS, str(mesh), "0.999", "1", "0", str(bound), "1", "0"]


def by_size(meshes: Path) -> list[Path]:
    return sorted(meshes.glob("*.obj"), key=lambda path: (len(read_obj(path)[1]), path.name))


def limit_processor_time() -> None:
    """Limit the processor time of this process to LIMIT, and make it use one core."""
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 5))


def kept_run(program: Path, mesh: Path, folder: Path, bound: float) -> PeerRun:
    stored = folder / f"{mesh.stem}.json"
    if not stored.exists():
        stored.write_text(json.dumps(asdict(run(program, mesh, folder, bound))), encoding="utf-8")
    return PeerRun(**json.loads(stored.read_text()))


def run(program: Path, mesh: Path, folder: Path, bound: float) -> PeerRun:
    with tempfile.TemporaryDirectory() as work:  # OptCuts writes to a folder inside its working directory
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with (folder / f"{mesh.stem}.log").open("w") as log:
            call = command(program.resolve(), mesh.resolve(), bound)
            ended = subprocess.run(call, cwd=work, stdout=log, stderr=log, preexec_fn=limit_processor_time)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        for shape in Path(work).glob("output/*/finalResult_mesh.obj"):
            shutil.copyfile(shape, folder / f"{mesh.stem}.obj")
            return PeerRun(seconds, "")
    return PeerRun(seconds, f"over {LIMIT} s" if seconds >= LIMIT else f"it ended with code {ended.returncode}")
