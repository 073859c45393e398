# SPDX-License-Identifier: GPL-3.0-or-later
"""Returns the commit of this repository. Pages name it beside their figures."""

import subprocess
from pathlib import Path


def commit() -> str:
    command = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    return subprocess.check_output(command, text=True).strip()
