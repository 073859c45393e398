# SPDX-License-Identifier: GPL-3.0-or-later
"""The error for an object that cannot be flattened or written. It contains an issue of the library's report."""

from .core import Issue


class ObjectError(Exception):
    """Raised if one object cannot be flattened or written. Other objects are not affected."""

    def __init__(self, issue: Issue) -> None:
        super().__init__(issue.sentence)
        self.issue = issue


def object_error(code: str, sentence: str) -> ObjectError:
    return ObjectError(Issue(code, sentence))


def changed_error(name: str) -> ObjectError:
    """Return the error for an object whose report describes another shape. name: name of the object."""
    return object_error("changed", f'"{name}" has changed since it was flattened. Flatten it again.')
