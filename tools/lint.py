# SPDX-License-Identifier: GPL-3.0-or-later
"""Style and static checks of all sources."""

from pathlib import Path

from tools.environment import ROOT, StepError, require_apt, run, venv
from tools.package import DEBIAN_PYTHON

RUFF = "ruff==0.17.6"
PYTHON_SOURCES = (".", "dev")


def ruff() -> Path:
    require_apt("python3-venv")
    return venv("lint", DEBIAN_PYTHON, RUFF).parent / "ruff"


def cpp_sources() -> list[Path]:
    folders = (ROOT / "native", ROOT / "tests")
    return sorted(p for folder in folders for suffix in ("*.h", "*.cpp") for p in folder.rglob(suffix))


def lint() -> None:
    require_apt("clang-format")
    findings = []
    for command in (
        [ruff(), "check", "--no-cache", *PYTHON_SOURCES],
        [ruff(), "format", "--no-cache", "--check", *PYTHON_SOURCES],
        ["clang-format", "--dry-run", "-Werror", "--ferror-limit=20", *cpp_sources()],
    ):
        try:
            run(command)
        except StepError as error:
            findings.append(str(error))
    if findings:
        raise StepError("; ".join(findings))


def format_sources() -> None:
    require_apt("clang-format")
    run([ruff(), "check", "--no-cache", "--fix", *PYTHON_SOURCES])
    run([ruff(), "format", "--no-cache", *PYTHON_SOURCES])
    run(["clang-format", "-i", *cpp_sources()])
