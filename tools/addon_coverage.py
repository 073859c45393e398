# SPDX-License-Identifier: GPL-3.0-or-later
"""How much of the add-on its tests in Debian's Blender run, with and without the window."""

import json
from pathlib import Path

from tools.environment import BUILD, ROOT, require_apt, run_quietly, say

FOLDER = BUILD / "coverage"
KINDS = ("headless", "window")


def begin(kind: str) -> dict[str, str]:
    """Forgets what was measured before of this kind; returns environment variables for the tests."""
    require_apt("python3-coverage")
    FOLDER.mkdir(parents=True, exist_ok=True)
    for old in FOLDER.glob(f"{kind}.*"):
        old.unlink()
    return {"COVERAGE_PROCESS_START": str(ROOT / "pyproject.toml"), "COVERAGE_FILE": str(FOLDER / kind)}


def show() -> None:
    """Prints the share of all lines and the least covered modules, by what was measured last of both kinds."""
    measured = [file for kind in KINDS for file in FOLDER.glob(f"{kind}.*")]
    report = FOLDER / "report.json"
    commands: list[list[str | Path]] = [["combine", "--keep", "--quiet", *measured], ["json", "--quiet", "-o", report]]
    for command in commands:
        whole = {"COVERAGE_FILE": str(FOLDER / "all")}
        run_quietly(f"coverage {command[0]}", ["/usr/bin/python3", "-m", "coverage", *command], **whole)
    found = json.loads(report.read_text())
    shares = {name: file["summary"]["percent_covered"] for name, file in found["files"].items()}
    say(f"coverage of the add-on: {found['totals']['percent_covered']:.0f} % of the lines; least covered:")
    for name in sorted(shares, key=lambda name: shares[name])[:8]:
        say(f"  {shares[name]:3.0f} %  {name}")
