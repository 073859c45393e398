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


CLEAN = ROOT / ".clang-tidy-clean"  # committed, so that a clone need not check again what was clean elsewhere
SHORT = 16  # hexadecimal digits, of the 64 of a fingerprint


def tidy() -> None:
    """Checks the sources that have changed, or include what has changed, since they were last found clean: here, or
    where .clang-tidy-clean was written."""
    clean = set(CLEAN.read_text().splitlines())
    keys = source_keys()
    check(keys, [source for source, key in keys.items() if line_of(source, key) not in clean])


def tidy_everything() -> None:
    """Checks every source that was not found clean here, as it is, and writes .clang-tidy-clean."""
    keys = source_keys()
    check(keys, list(keys))
    CLEAN.write_text("".join(f"{line_of(source, keys[source])}\n" for source in sorted(keys)))


def line_of(source: Path, key: str) -> str:
    """Of .clang-tidy-clean."""
    return f"{key[:SHORT]} {source.relative_to(ROOT)}"


def source_keys() -> dict[Path, str]:
    """Of each source a fingerprint of all that decides what clang-tidy says of it; the same in every clone."""
    require_apt(*TIDY_APT)
    (packages,) = clang_tidy().parent.parent.glob("lib/python*/site-packages")
    run_quietly("configuring build/tidy", ["cmake", "--preset", "tidy"], pybind11_ROOT=str(packages / "pybind11"))
    commands = {Path(entry["file"]): entry["command"] for entry in json.loads(COMMANDS.read_text())}
    headers = headers_by_name()
    return {
        source: fingerprint(what_decides(source, headers), *TOOLS, command.replace(str(ROOT), ""))
        for source, command in commands.items()
    }


def check(keys: dict[Path, str], sources: list[Path]) -> None:
    """Runs clang-tidy on those of the sources that were not found clean here."""
    unknown = [source for source in sources if not is_current(stamp(source), keys[source])]
    say(f"clang-tidy on {len(unknown)} of {len(keys)} sources")
    program = clang_tidy()
    with ThreadPoolExecutor(CORES) as pool:
        clean = list(pool.map(lambda source: is_clean(program, source, keys[source]), unknown))
    if not all(clean):
        raise StepError(f"clang-tidy has findings in {clean.count(False)} sources")


def clang_tidy() -> Path:
    return venv("tidy", DEBIAN_PYTHON, *TOOLS).parent / "clang-tidy"


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
