# SPDX-License-Identifier: GPL-3.0-or-later
"""How much of the core its tests run, by what the compiler counts in build/asan."""

import json
import re
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from tools.environment import BUILD, ROOT, StepError, output_of, say

SOURCES = ROOT / "native" / "src"
TREE = BUILD / "asan"
OBJECTS = TREE / "CMakeFiles" / "wirewarp.dir"


@dataclass
class Counts:
    """Of one source file: which lines and functions there are, and which of them were run."""

    lines: dict[int, bool] = field(default_factory=lambda: defaultdict(bool))
    functions: dict[tuple[int, str], bool] = field(default_factory=lambda: defaultdict(bool))


def begin() -> None:
    """Forgets what was counted before."""
    for counts in OBJECTS.rglob("*.gcda"):
        counts.unlink()


def show() -> None:
    """Prints the share of lines run, in all and by folder, and names the functions that no test runs.

    Raises StepError if no function of a source file was run.
    """
    files = _read()
    say(f"coverage of the core: {_share(list(files.values()))} of the lines; by folder:")
    folders = defaultdict(list)
    for name, counts in files.items():
        folders[str(Path(name).parent)].append(counts)
    for folder in sorted(folders):
        say(f"  {_share(folders[folder])}  {folder}")
    for name, counts in files.items():
        for (line, function), is_run in sorted(counts.functions.items()):
            if not is_run:
                say(f"  no test runs {name}:{line} {function}")
    untested = [name for name, counts in files.items() if counts.functions and not any(counts.functions.values())]
    if untested:
        raise StepError(f"the tests run no function of {', '.join(untested)}")


def _share(files: list[Counts]) -> str:
    lines = [is_run for counts in files for is_run in counts.lines.values()]
    return f"{100 * sum(lines) / len(lines):5.1f}%"


def _read() -> dict[str, Counts]:
    """What gcov says of each source of the core, by name. Of headers it knows little: where a test includes one, too,
    the linker takes the test's copy, which counts nothing."""
    commands = (TREE / "compile_commands.json").read_text()
    outputs = [TREE / name for name in re.findall(r" -o (\S+)", commands)]
    notes = [output.with_suffix(".gcno") for output in outputs if OBJECTS in output.parents]
    lines = output_of(["gcov", "--json-format", "--stdout", *notes]).splitlines()  # one for each object
    found: dict[str, Counts] = defaultdict(Counts)
    for file in (file for line in lines for file in json.loads(line)["files"]):
        path = (TREE / file["file"]).resolve()
        if SOURCES not in path.parents or path.suffix != ".cpp":
            continue
        counts = found[str(path.relative_to(ROOT))]
        for line in file["lines"]:
            counts.lines[line["line_number"]] |= line["count"] != 0
        for function in file["functions"]:
            name = function["demangled_name"].replace("(anonymous namespace)::", "").partition("(")[0]
            counts.functions[function["start_line"], name] |= function["execution_count"] != 0
    return dict(sorted(found.items()))
