# SPDX-License-Identifier: GPL-3.0-or-later
"""The one exception type and its codes, made from the table of the compiled core."""

from collections.abc import Iterable
from enum import StrEnum
from typing import Any

from ._wirewarp import error_descriptions


class _DescribedCode(StrEnum):
    meaning: str
    remedy: str

    def __new__(cls, value: str, meaning: str, remedy: str) -> "_DescribedCode":
        member = str.__new__(cls, value)
        member._value_ = value
        member.meaning = meaning
        member.remedy = remedy
        return member


ErrorCode = _DescribedCode(
    "ErrorCode",
    [(name, (name, meaning, remedy)) for name, (meaning, remedy) in error_descriptions().items()],
    module=__package__,
)
ErrorCode.__doc__ = "What went wrong; each code has a meaning and a remedy, one sentence each."


class FlattenError(ValueError):
    """Bad input (raised), or a piece that breaks a promise (carried by the piece).

    `str(error)` is one sentence that names the elements and the remedy. `vertices`, `edges` (vertex pairs) and `faces`
    are the elements it speaks of, as indices of the input. `has_layout` is true where the piece has coordinates to look
    at all the same.

    `proposed_seams` are vertex pairs that would mend the piece: flatten again with `[*seams, *error.proposed_seams]`.
    `proposed_tolerances` are pairs of the index of a wire and a tolerance under which its length can be kept. Both are
    empty where there is no proposal.
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
        )

    def to_dict(self) -> dict[str, Any]:
        """All fields as plain, JSON-able values."""
        return {
            "code": self.code.value,
            "message": self.message,
            "vertices": list(self.vertices),
            "edges": [list(edge) for edge in self.edges],
            "faces": list(self.faces),
            "has_layout": self.has_layout,
            "proposed_seams": [list(edge) for edge in self.proposed_seams],
            "proposed_tolerances": [list(pair) for pair in self.proposed_tolerances],
        }
