# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures which lines of the add-on are run by its tests in Debian's Blender, with and without the window."""

import ast
import json
import os
from collections.abc import Iterator
from pathlib import Path

from tools.environment import BUILD, ROOT, StepError, output_of, require_apt, say

ADDON = ROOT / "addon" / "wirewarp"
FOLDER = BUILD / "coverage"
COVERAGE_APT = ("python3-coverage",)
KINDS = ("headless", "window")
NEEDS_WINDOW = {  # modules that run in a window only; all other modules are tested without a window
    "addon/wirewarp/overlay/view3d.py": "draws in a view and in a UV editor",
    "addon/wirewarp/overlay/screen.py": "draws text",
}
REGISTERING = {"attach", "detach", "register", "unregister"}  # these functions run in every module, even without a test


def begin(kind: str) -> dict[str, str]:
    """Delete earlier measurements of this kind. Return environment variables for the tests."""
    require_apt(*COVERAGE_APT)
    FOLDER.mkdir(parents=True, exist_ok=True)
    for old in FOLDER.glob(f"{kind}.*"):
        old.unlink()
    return {"COVERAGE_PROCESS_START": str(ROOT / "pyproject.toml"), "COVERAGE_FILE": str(FOLDER / kind)}


def show(kind: str) -> None:
    """Print the share of covered lines and the least covered modules, for both kinds of tests together.

    Raises StepError if the tests of this kind run no function of a module that they should test.
    """
    if os.environ.get("PYTEST_ADDOPTS"):  # this may select a part of the tests, which covers less
        return
    found = _report(*KINDS)
    shares = {name: file["summary"]["percent_covered"] for name, file in found["files"].items()}
    say(f"coverage of the add-on: {found['totals']['percent_covered']:.0f}% of the lines; least covered:")
    for name in sorted(shares, key=lambda name: shares[name])[:8]:
        say(f"  {shares[name]:3.0f}%  {name}")
    files = _report(kind)["files"]
    modules = {str(path.relative_to(ROOT)): path for path in ADDON.rglob("*.py")}
    theirs = NEEDS_WINDOW.keys() if kind == "window" else modules.keys() - NEEDS_WINDOW.keys()
    untested = [name for name in sorted(theirs) if not _is_run(modules[name], files.get(name))]
    if untested:
        raise StepError(f"the {kind} tests run no function of {', '.join(untested)}")


def _report(*kinds: str) -> dict:
    measured = [file for kind in kinds for file in FOLDER.glob(f"{kind}.*")]
    report = FOLDER / "report.json"
    commands: list[list[str | Path]] = [
        ["combine", "--keep", "--quiet", *measured],
        # Without --ignore-errors, a source that was removed after the tests of the other kind would be an error.
        ["json", "--quiet", "--ignore-errors", "-o", report],
    ]
    for command in commands:
        whole = {"COVERAGE_FILE": str(FOLDER / "all")}
        output_of(["/usr/bin/python3", "-m", "coverage", *command], **whole)
    return json.loads(report.read_text())


def _is_run(module: Path, file: dict | None) -> bool:
    """Return whether the tests ran the body of any function of the module. True for a module without functions."""
    bodies = list(_bodies(module))
    return not bodies or (file is not None and any(not body.isdisjoint(file["executed_lines"]) for body in bodies))


def _bodies(module: Path) -> Iterator[set[int]]:
    """Yield the line numbers of each function's body, except for functions that only register."""
    for node in ast.walk(ast.parse(module.read_text())):
        if isinstance(node, ast.FunctionDef) and node.name not in REGISTERING:
            yield set(range(node.body[0].lineno, (node.end_lineno or 0) + 1))
