# SPDX-License-Identifier: GPL-3.0-or-later
"""What went wrong, in one sentence, and the elements of the source mesh it speaks of."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class LooserWire:
    """A wire that can be kept if it gets this tolerance."""

    name: str
    tolerance: float
    edges: list[tuple[int, int]]  # vertex pairs


@dataclass(frozen=True)
class Issue:
    """code is the core library's error code or one of the add-on's own; all indices are of the source mesh."""

    code: str
    sentence: str
    piece: int | None = None
    vertices: list[int] = field(default_factory=list)
    edges: list[tuple[int, int]] = field(default_factory=list)  # vertex pairs
    faces: list[int] = field(default_factory=list)  # polygons
    proposed_seams: list[tuple[int, int]] = field(default_factory=list)  # edges of the mesh as vertex pairs
    proposed_tolerances: list[LooserWire] = field(default_factory=list)
    both_sides: bool = False  # what is proposed mends this piece and its twin


@dataclass(frozen=True)
class Hint(Issue):
    """What would make a good piece better."""

    short: str = ""  # the sentence without the advice, for a list under it


class ObjectError(Exception):
    """One object cannot be flattened or written; the others can."""

    def __init__(self, issue: Issue) -> None:
        super().__init__(issue.sentence)
        self.issue = issue


def object_error(code: str, sentence: str) -> ObjectError:
    return ObjectError(Issue(code, sentence))


def changed_error(name: str) -> ObjectError:
    """name: of an object whose report is of another shape."""
    return object_error("changed", f'"{name}" has changed since it was flattened. Flatten it again.')


def note(text: str) -> dict:
    return {"text": text, "is_warning": False}


def warning(text: str) -> dict:
    return {"text": text, "is_warning": True}
