# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures which lines of the core are run by its tests. The program in build/asan counts, and gcovr reports."""

import json
from pathlib import Path

from tools.environment import BUILD, DEBIAN_PYTHON, ROOT, StepError, run, say, venv

TREE = BUILD / "asan"
OBJECTS = TREE / "CMakeFiles" / "wirewarp.dir"
GCOVR = "gcovr==8.8"


def begin() -> None:
    """Delete earlier counts, and all files for sources that were moved or deleted, on which gcovr would fail."""
    for counts in OBJECTS.rglob("*.gcda"):
        counts.unlink()
    run(["ninja", "-C", TREE, "-t", "cleandead"])
    for notes in OBJECTS.rglob("*.gcno"):
        if not notes.with_suffix(".o").exists():
            notes.unlink()


def show() -> None:
    """Print the shares of covered lines and functions, and the functions that no test runs.

    Raises StepError if no function of a source file was run.
    """
    gcovr = venv("coverage", DEBIAN_PYTHON, GCOVR).parent / "gcovr"
    report = TREE / "coverage.json"
    # Headers are excluded, because their counts are incomplete: of a function in a header, the linker may keep the copy
    # that was compiled with a test, and this copy does not count its runs.
    sources: list[str | Path] = ["--root", ROOT, "--filter", "native/src/", "--exclude", r".*\.h$"]
    # Without these options, gcovr would fail on a function that starts on several lines, on a count that threads have
    # damaged, and on high counts.
    tolerant = ["--merge-mode-functions=separate", "--gcov-ignore-parse-errors=all"]
    run([gcovr, *sources, *tolerant, "--json", report, "--print-summary", OBJECTS])
    untested = []
    for file in json.loads(report.read_text())["files"]:
        # Entries without an execution_count have no code.
        functions = [function for function in file["functions"] if "execution_count" in function]
        missed = [function for function in functions if not function["execution_count"]]
        for function in missed:
            name = function["demangled_name"].replace("(anonymous namespace)::", "").partition("(")[0]
            say(f"  no test runs {file['file']}:{function['lineno']} {name}")
        if functions and len(missed) == len(functions):
            untested.append(file["file"])
    if untested:
        raise StepError(f"the tests run no function of {', '.join(untested)}")
