# SPDX-License-Identifier: GPL-3.0-or-later
"""The commit of the figures."""

import subprocess
from pathlib import Path


def commit() -> str:
    command = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    return subprocess.check_output(command, text=True).strip()
