# SPDX-License-Identifier: GPL-3.0-or-later
"""The possible results of a model, and the line that reports each."""

from typing import Any

from ..report import Kind, Verdict

READY, NEEDS_STRETCH = "ready to cut", "needs stretch fabric"
FAILED, REFUSED, STOPPED = "not ready to cut", "refused", "stopped"
PROPOSED, NOTHING = "proposed", "nothing to propose"
# Exit codes: the command ends with that of the worst model. With 0, every length is exact and a fabric can do it.
EXIT_CODES = {READY: 0, NEEDS_STRETCH: 0, PROPOSED: 0, FAILED: 1, NOTHING: 1, REFUSED: 2, STOPPED: 3}
Line = dict[str, Any]


def word_of(verdict: Verdict) -> str:
    """Return the word in the printed line for the report's verdict."""
    if verdict.is_ready:
        return READY
    return NEEDS_STRETCH if verdict.kind is Kind.NEEDS_STRETCH else FAILED


def unfinished(verdict: str, code: str, problem: str) -> Line:
    """Return the line of a model of which nothing was written."""
    return {"verdict": verdict, "problems": [problem], "codes": [code]}
