# SPDX-License-Identifier: GPL-3.0-or-later
"""clang-tidy on every C++ source but the fuzzer's, which needs a clang of its own; .clang-tidy says which checks."""

import json
import re
import subprocess
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tools.environment import (
    BUILD,
    CORES,
    DEBIAN_PYTHON,
    ROOT,
    StepError,
    clean_environment,
    fingerprint,
    is_current,
    require_apt,
    run_quietly,
    say,
    set_current,
    venv,
)
from tools.native import NATIVE_APT
from tools.package import PYBIND11

TIDY_APT = (*NATIVE_APT, "libbenchmark-dev")
TOOLS = ("clang-tidy==23.1.4", PYBIND11)
COMMANDS = BUILD / "tidy" / "compile_commands.json"


def tidy() -> None:
    """Checks the sources that have changed, or include what has changed, since they were last found clean."""
    require_apt(*TIDY_APT)
    python = venv("tidy", DEBIAN_PYTHON, *TOOLS)
    (packages,) = python.parent.parent.glob("lib/python*/site-packages")
    run_quietly("configuring build/tidy", ["cmake", "--preset", "tidy"], pybind11_ROOT=str(packages / "pybind11"))
    commands = {Path(entry["file"]): entry["command"] for entry in json.loads(COMMANDS.read_text())}
    headers = headers_by_name()
    keys = {source: fingerprint(what_decides(source, headers), *TOOLS, commands[source]) for source in commands}
    changed = [source for source in commands if not is_current(stamp(source), keys[source])]
    say(f"clang-tidy on {len(changed)} of {len(commands)} sources")
    with ThreadPoolExecutor(CORES) as pool:
        clean = list(pool.map(lambda source: is_clean(python.parent / "clang-tidy", source, keys[source]), changed))
    if not all(clean):
        raise StepError(f"clang-tidy has findings in {clean.count(False)} sources")


def is_clean(program: Path, source: Path, key: str) -> bool:
    """Prints what clang-tidy finds in this source; keeps in mind where that is nothing."""
    command: list[str | Path] = [program, "--quiet", "-p", COMMANDS.parent, source]
    done = subprocess.run(command, capture_output=True, text=True, env=clean_environment())
    if done.returncode:
        print(done.stdout + done.stderr, flush=True)
        return False
    set_current(stamp(source), key)
    return True


def stamp(source: Path) -> str:
    return "tidy-" + "-".join(source.relative_to(ROOT).parts)


def headers_by_name() -> dict[str, list[Path]]:
    found: dict[str, list[Path]] = {}
    for folder in ("native", "tests"):
        for header in sorted((ROOT / folder).rglob("*.h")):
            found.setdefault(header.name, []).append(header)
    return found


def what_decides(source: Path, headers: dict[str, list[Path]]) -> Iterable[Path]:
    """The settings, the source and all headers of ours that it includes, directly or not.

    Headers go by name: of two with one name, both count."""
    seen = {source}
    todo = [source]
    while todo:
        for name in re.findall(r'^\s*#include\s+[<"](?:[^">]*/)?([^">/]+)[">]', todo.pop().read_text(), re.MULTILINE):
            new = set(headers.get(name, [])) - seen
            seen |= new
            todo += sorted(new)
    return [ROOT / ".clang-tidy", *sorted(seen)]
