# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the style of all sources, and runs static checks."""

from collections.abc import Sequence
from pathlib import Path

from tools.environment import BUILD, DEBIAN_PYTHON, ROOT, StepError, require_apt, run, venv

TOOLS = (
    "check-jsonschema==0.39.0",
    "clang-format==14.0.6",
    "import-linter==2.17",
    "mypy==2.4.1",
    "numpy==2.3.5",
    "ruff==0.17.6",
)
PYTHON_SOURCES = (".", "dev")
TYPED_SOURCES = ("dev", "tools", "python/wirewarp", "addon/wirewarp")
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
Command = Sequence[str | Path]


def tool(name: str) -> Path:
    require_apt("python3-venv")
    return venv("lint", DEBIAN_PYTHON, *TOOLS).parent / name


def cpp_sources() -> list[Path]:
    folders = (ROOT / "native", ROOT / "tests")
    return sorted(p for folder in folders for suffix in ("*.h", "*.cpp") for p in folder.rglob(suffix))


def lint() -> None:
    mypy: Command = [tool("mypy"), "--cache-dir", BUILD / "mypy", "--explicit-package-bases", "--scripts-are-modules"]
    commands: list[Command] = [
        [tool("ruff"), "check", "--no-cache", *PYTHON_SOURCES],
        [tool("ruff"), "format", "--no-cache", "--check", *PYTHON_SOURCES],
        [tool("clang-format"), "--dry-run", "-Werror", "--ferror-limit=20", *cpp_sources()],
        [*mypy, *TYPED_SOURCES],
        [tool("lint-imports"), "--no-cache"],
        [tool("check-jsonschema"), "--builtin-schema", "vendor.github-workflows", *WORKFLOWS],
    ]
    findings = []
    for command in commands:
        try:
            run(command, PYTHONPATH=str(ROOT / "python"))  # lint-imports imports the package
        except StepError as error:
            findings.append(str(error))
    if findings:
        raise StepError("; ".join(findings))


def format_sources() -> None:
    run([tool("ruff"), "check", "--no-cache", "--fix", *PYTHON_SOURCES])
    run([tool("ruff"), "format", "--no-cache", *PYTHON_SOURCES])
    run([tool("clang-format"), "-i", *cpp_sources()])
