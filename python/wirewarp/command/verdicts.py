# SPDX-License-Identifier: GPL-3.0-or-later
"""What may become of a model, and the line that says it."""

from typing import Any

READY, FAILED, REFUSED, STOPPED = "ready to cut", "not ready to cut", "refused", "stopped"
PROPOSED, NOTHING = "proposed", "nothing to propose"
# That of the worst ends the command.
EXIT_CODES = {READY: 0, PROPOSED: 0, FAILED: 1, NOTHING: 1, REFUSED: 2, STOPPED: 3}
Line = dict[str, Any]


def unfinished(verdict: str, code: str, problem: str) -> Line:
    """Of a model of which nothing was written."""
    return {"verdict": verdict, "problems": [problem], "codes": [code]}
