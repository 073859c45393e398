# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the only exception type of wirewarp, and the codes of errors. The compiled core has the table of codes."""

import copy
from collections.abc import Iterable, Mapping
from enum import StrEnum
from types import MappingProxyType
from typing import Any

from ._wirewarp import error_descriptions


class _DescribedCode(StrEnum):
    meaning: str
    remedy: str
    arguments: str

    def __new__(cls, value: str, meaning: str, remedy: str, arguments: str) -> "_DescribedCode":
        member = str.__new__(cls, value)
        member._value_ = value
        member.meaning = meaning
        member.remedy = remedy
        member.arguments = arguments
        return member


ErrorCode = _DescribedCode(
    "ErrorCode",
    [(name, (name, *description)) for name, description in error_descriptions().items()],
    module=__package__,
)
ErrorCode.__doc__ = """The kind of an error. `meaning` and `remedy` are one sentence each.

`arguments` documents the keys of `FlattenError.arguments` as "name: meaning", separated by semicolons.
"""


class FlattenError(ValueError):
    """An error of the input (raised), or a fault of one piece (stored as `Piece.error`).

    - `str(error)`: the fault, its place and a remedy
    - `vertices`, `edges` (vertex pairs), `faces`: the faulty elements, as indices of the input
    - `has_layout`: whether the failed piece has flat coordinates to inspect
    - `proposed_seams`: vertex pairs that fix the piece if you flatten again with `[*seams, *error.proposed_seams]`
    - `proposed_tolerances`: pairs of a wire's index and a tolerance within which the wire can keep its length
    - Without a proposal, `proposed_seams` and `proposed_tolerances` are empty.
    - `arguments`: the other values in `str(error)`, as bool, int, float, str or lists of one of these types
    - `code.arguments`: what each of these values means, for example to write the sentence in another language
    """

    __module__ = __package__

    def __init__(
        self,
        code: ErrorCode | str,
        message: str,
        vertices: Iterable[int] = (),
        edges: Iterable[tuple[int, int]] = (),
        faces: Iterable[int] = (),
        has_layout: bool = False,
        proposed_seams: Iterable[tuple[int, int]] = (),
        proposed_tolerances: Iterable[tuple[int, float]] = (),
        arguments: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        super().__init__(message)
        self.code = ErrorCode(code)
        self.message = message
        self.vertices = tuple(vertices)
        self.edges = tuple((a, b) for a, b in edges)
        self.faces = tuple(faces)
        self.has_layout = has_layout
        self.proposed_seams = tuple((a, b) for a, b in proposed_seams)
        self.proposed_tolerances = tuple((wire, tolerance) for wire, tolerance in proposed_tolerances)
        self.arguments = dict(arguments)

    def __reduce__(self) -> tuple[type["FlattenError"], tuple[Any, ...]]:
        return type(self), (
            self.code,
            self.message,
            self.vertices,
            self.edges,
            self.faces,
            self.has_layout,
            self.proposed_seams,
            self.proposed_tolerances,
            self.arguments,
        )

    def to_dict(self) -> dict[str, Any]:
        """Return all fields as plain values that JSON can store."""
        return {
            "code": self.code.value,
            "message": self.message,
            "vertices": list(self.vertices),
            "edges": [list(edge) for edge in self.edges],
            "faces": list(self.faces),
            "has_layout": self.has_layout,
            "proposed_seams": [list(edge) for edge in self.proposed_seams],
            "proposed_tolerances": [list(pair) for pair in self.proposed_tolerances],
            "arguments": copy.deepcopy(self.arguments),
        }
