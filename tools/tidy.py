# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs clang-tidy on the C++ sources.

The sources of a folder in native/src with its subfolders are checked as one file: warp/ then takes 8 s instead of 14 s
with a file for each subfolder. Only `./dev tidy` checks the native tests, which take as long as all other sources.
"""

import json
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tools.environment import (
    BUILD,
    CORES,
    DEBIAN_PYTHON,
    StepError,
    clean_environment,
    require_apt,
    run_quietly,
    say,
    venv,
)
from tools.native import FUZZ_APT, NATIVE_APT
from tools.package import PYBIND11

TIDY_APT = (*NATIVE_APT, *FUZZ_APT, "libbenchmark-dev")
TOOLS = ("clang-tidy==23.1.4", PYBIND11)
FOLDER = BUILD / "tidy"
NATIVE_TEST = re.compile(r"/wirewarp_tests\.dir/|/tests/native/")
INCLUDED = ("native/include", "native/src", "tests/judge", "tests/random_cases", "/usr/include/eigen3")
# One file includes the sources of a folder, so clang-tidy treats them as headers. --header-filter shows their findings.
OPTIONS = ("--quiet", "-p", FOLDER, "--header-filter=/(native|tests)/", "--checks=-bugprone-suspicious-include")


def tidy() -> None:
    check(with_tests=False)


def tidy_everything() -> None:
    check(with_tests=True)


def check(with_tests: bool) -> None:
    require_apt(*TIDY_APT)
    program = venv("tidy", DEBIAN_PYTHON, *TOOLS).parent / "clang-tidy"
    (packages,) = program.parent.parent.glob("lib/python*/site-packages")
    run_quietly("configuring build/tidy", ["cmake", "--preset", "tidy"], pybind11_ROOT=str(packages / "pybind11"))
    entries = json.loads((FOLDER / "compile_commands.json").read_text())
    every = [entry["file"] for entry in entries]
    sources = [source for source in every if with_tests or not NATIVE_TEST.search(source)]
    check_fuzzer()
    say(f"clang-tidy on {len(sources)} of {len(every)} sources")
    with ThreadPoolExecutor(CORES) as pool:
        clean = list(pool.map(lambda source: is_clean(program, source), sources))
    if not all(clean):
        raise StepError(f"clang-tidy has findings in {clean.count(False)} sources")


def check_fuzzer() -> None:
    """Check that the fuzzer compiles, because no other step of ./dev test compiles it. It needs clang."""
    folders = [f"-I{folder}" for folder in INCLUDED]
    command = ["clang++", "-std=c++17", "-fsyntax-only", *folders, "tests/fuzz/fuzz_flatten.cpp"]
    run_quietly("compiling the fuzzer", command)


def is_clean(program: Path, source: str) -> bool:
    """Print clang-tidy's findings in this source. Return whether it has none."""
    done = subprocess.run([program, *OPTIONS, source], capture_output=True, text=True, env=clean_environment())
    if done.returncode:
        print(done.stdout + done.stderr, flush=True)
    return done.returncode == 0
