# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the verdicts on a model, and makes the line of the output that reports the verdict."""

from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any, TypeVar

from .. import ErrorCode, FlattenError
from ..report import Kind, Report, Verdict, verdict
from .figures import figures_of
from .request import AnyRequest, InputError

READY, NEEDS_STRETCH = "ready to cut", "needs stretch fabric"
FAILED, REFUSED, STOPPED = "not ready to cut", "refused", "stopped"
PROPOSED, NOTHING = "proposed", "nothing to propose"
# The command ends with the exit code of the worst model. NEEDS_STRETCH has code 0, because the model can be cut from
# stretch fabric.
EXIT_CODES = {READY: 0, NEEDS_STRETCH: 0, PROPOSED: 0, FAILED: 1, NOTHING: 1, REFUSED: 2, STOPPED: 3}
Line = dict[str, Any]
R = TypeVar("R", bound=AnyRequest)


def finished(
    reports: Sequence[Report], problems: Sequence[tuple[str, str]], warnings: list[str], files: list[str]
) -> Line:
    """Return the line of a model whose files were written. problems: pairs of a sentence and its code."""
    found = verdict(*reports)
    return {
        "verdict": _word_of(found),
        "says": [line.text for line in found.lines],
        "pieces": sum(len(report.pieces) for report in reports),
        "figures": figures_of(reports),
        "problems": [sentence for sentence, _ in problems],
        "codes": [code for _, code in problems],
        "warnings": warnings,
        "files": files,
    }


def _word_of(found: Verdict) -> str:
    if found.is_ready:
        return READY
    return NEEDS_STRETCH if found.kind is Kind.NEEDS_STRETCH else FAILED


def unfinished(word: str, code: str, problem: str) -> Line:
    """Return the line of a model whose files were not written. word: the verdict."""
    return {"verdict": word, "problems": [problem], "codes": [code]}


def with_faults_answered(work: Callable[[R], Line]) -> Callable[[R], Line]:
    """Return a function that calls work. If work raises one of the errors below, the function returns a line with the
    fault."""

    @wraps(work)
    def answer(request: R) -> Line:
        try:
            return work(request)
        except InputError as error:
            return unfinished(REFUSED, "input", str(error))
        except FlattenError as error:
            word = NOTHING if error.code == ErrorCode.no_proposal else REFUSED
            return unfinished(word, error.code.value, str(error))
        except OSError as error:
            place = error.filename or getattr(request, "folder", request.model)
            return unfinished(REFUSED, "file", f"{place}: {error.strerror or error}")
        except MemoryError:
            return unfinished(STOPPED, "memory_limit", "There is not enough memory for this model.")

    return answer
