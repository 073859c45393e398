# SPDX-License-Identifier: GPL-3.0-or-later
"""How much of the core its tests run, by what the compiler counts in build/asan and gcovr reports."""

import json
from pathlib import Path

from tools.environment import BUILD, DEBIAN_PYTHON, ROOT, StepError, run, say, venv

TREE = BUILD / "asan"
OBJECTS = TREE / "CMakeFiles" / "wirewarp.dir"
GCOVR = "gcovr==8.8"


def begin() -> None:
    """Delete earlier counts, and those of moved sources, at which gcovr would stop."""
    for counts in OBJECTS.rglob("*.gcda"):
        counts.unlink()
    run(["ninja", "-C", TREE, "-t", "cleandead"])
    for notes in OBJECTS.rglob("*.gcno"):
        if not notes.with_suffix(".o").exists():
            notes.unlink()


def show() -> None:
    """Prints the shares of lines and functions run, and names the functions that no test runs.

    Of headers the compiler knows little: if a test includes one, too, the linker takes the test's copy, which counts
    nothing. Raises StepError if no function of a source file was run.
    """
    gcovr = venv("coverage", DEBIAN_PYTHON, GCOVR).parent / "gcovr"
    report = TREE / "coverage.json"
    sources: list[str | Path] = ["--root", ROOT, "--filter", "native/src/", "--exclude", r".*\.h$"]
    # A function may begin on several lines; threads may spoil a count, and inner loops pass what gcovr finds plausible.
    tolerant = ["--merge-mode-functions=separate", "--gcov-ignore-parse-errors=all"]
    run([gcovr, *sources, *tolerant, "--json", report, "--print-summary", OBJECTS])
    untested = []
    for file in json.loads(report.read_text())["files"]:
        # other lines have no code
        functions = [function for function in file["functions"] if "execution_count" in function]
        missed = [function for function in functions if not function["execution_count"]]
        for function in missed:
            name = function["demangled_name"].replace("(anonymous namespace)::", "").partition("(")[0]
            say(f"  no test runs {file['file']}:{function['lineno']} {name}")
        if functions and len(missed) == len(functions):
            untested.append(file["file"])
    if untested:
        raise StepError(f"the tests run no function of {', '.join(untested)}")
