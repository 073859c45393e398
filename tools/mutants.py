# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how many mutants the tests catch. A mutant is a source with one changed comparison, sign or logical
operator.

Run this program before and after you remove tests: the share of caught mutants must not fall.
"""

import io
import random
import re
import shutil
import subprocess
import tokenize
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from tools.bindings import bindings_python
from tools.environment import BUILD, CORES, DEBIAN_VERSION, ROOT, StepError, clean_environment, say
from tools.native import build_native

SAMPLE = 60  # number of mutants; the standard error of the share is then about 5%
SECONDS = 900.0  # limit for the tests of a mutant; if the tests take longer, the mutant counts as caught
SWAPPED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+"}
CPP_SWAPPED = SWAPPED | {"&&": "||", "||": "&&"}
PYTHON_SWAPPED = SWAPPED | {"and": "or", "or": "and"}
# This matches comments, texts and preprocessor lines, whose contents are never changed, and operators between spaces.
# The formatter puts no spaces around < and > of templates.
CPP_TOKEN = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"|^#[^\n]*|(?<= )(?:[<>=!]=|[<>+-]|&&|\|\|)(?= )', re.MULTILINE)
PACKAGE = ROOT / "python" / "wirewarp"
COPY = BUILD / "mutants"  # folder with a copy of the package and the compiled module


@dataclass(frozen=True)
class Mutant:
    file: Path
    start: int  # position of the operator in the text of the file
    operator: str
    other: str

    def __str__(self) -> str:
        text = self.file.read_text()
        line = text.count("\n", 0, self.start)
        place = f"{self.file.relative_to(ROOT)}:{line + 1}"
        return f"{place}: {self.operator} as {self.other}: {text.splitlines()[line].strip()}"

    def text(self) -> str:
        text = self.file.read_text()
        return text[: self.start] + self.other + text[self.start + len(self.operator) :]


# A judge returns whether tests fail on a mutant, or on the original source if the argument is None. It returns None if
# the mutant does not compile.
Judge = Callable[[Mutant | None], bool | None]


def mutants(words: list[str]) -> None:
    """Print the share of caught mutants, and the mutants that no test catches.

    words: a source or a folder of sources, then the tests: files for pytest, or a GoogleTest filter.
    """
    if len(words) < 2:
        raise StepError("name a source or its folder, and its tests: ./dev mutants native/src/measure 'Measure*'")
    path, *tests = words
    top = (ROOT / path).resolve()
    sources = sorted(top.rglob("*.*")) if top.is_dir() else [top]
    every = [mutant for source in sources if source.suffix in (".py", ".cpp") for mutant in _mutants_of(source)]
    if not every:
        raise StepError(f"{path} has no comparison or sign to change")
    chosen = random.Random(0).sample(every, min(SAMPLE, len(every)))
    is_caught = _in_python(tests) if chosen[0].file.suffix == ".py" else _in_cpp(tests)
    if is_caught(None):
        raise StepError(f"{' '.join(tests)} fail before anything is changed")
    caught = 0
    survivors = []
    for mutant in chosen:
        outcome = is_caught(mutant)
        caught += outcome is True
        if outcome is False:
            survivors.append(mutant)
            say(f"not caught: {mutant}")
    say(f"{caught} of {caught + len(survivors)} mutants that compile were caught; {len(every)} mutants can be made")


def _mutants_of(source: Path) -> Iterator[Mutant]:
    text = source.read_text()
    if source.suffix == ".cpp":
        for match in CPP_TOKEN.finditer(text):
            if other := CPP_SWAPPED.get(match[0]):
                yield Mutant(source, match.start(), match[0], other)
        return
    lines = [0]
    for line in text.splitlines(keepends=True):
        lines.append(lines[-1] + len(line))
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in (tokenize.OP, tokenize.NAME) and (other := PYTHON_SWAPPED.get(token.string)):
            yield Mutant(source, lines[token.start[0] - 1] + token.start[1], token.string, other)


def _in_python(tests: list[str]) -> Judge:
    """Return a function that runs the tests on a copy of the package."""
    python = bindings_python(DEBIAN_VERSION)
    (compiled,) = python.parent.parent.glob("lib/*/site-packages/wirewarp/_wirewarp*.so")
    shutil.rmtree(COPY, ignore_errors=True)
    shutil.copytree(PACKAGE, COPY / "wirewarp")
    shutil.copy(compiled, COPY / "wirewarp")

    command: list[str | Path] = [python, "-m", "pytest", "-q", "-x", *tests]

    def is_caught(mutant: Mutant | None) -> bool:
        if mutant is None:
            return _fails(command)
        copied = COPY / mutant.file.relative_to(PACKAGE.parent)
        copied.write_text(mutant.text())
        try:
            return _fails(command)
        finally:
            shutil.copy(mutant.file, copied)

    return is_caught


def _in_cpp(tests: list[str]) -> Judge:
    """Return a function that changes the source itself, and restores it afterward."""
    program = BUILD / "release" / "wirewarp_tests"
    command: list[str | Path] = [program, f"--gtest_filter={':'.join(tests)}", "--gtest_fail_fast", "--gtest_brief=1"]

    def is_caught(mutant: Mutant | None) -> bool | None:
        if mutant is None:
            build_native("release", "wirewarp_tests")
            return _fails(command)
        original = mutant.file.read_text()
        mutant.file.write_text(mutant.text())
        try:
            if _fails(["cmake", "--build", "--preset", "release", "-j", str(CORES), "--target", "wirewarp_tests"]):
                return None
            return _fails(command)
        finally:
            mutant.file.write_text(original)

    return is_caught


def _fails(command: list[str | Path]) -> bool:
    settings = clean_environment(PYTHONPATH=str(COPY))
    try:
        done = subprocess.run(
            command, cwd=ROOT, env=settings, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=SECONDS
        )
    except subprocess.TimeoutExpired:
        return True
    return done.returncode != 0
