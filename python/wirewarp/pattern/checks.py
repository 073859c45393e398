# SPDX-License-Identifier: GPL-3.0-or-later
"""Refuses impossible values. Each kind of value has its own error sentence."""

from collections.abc import Sequence

from .._errors import ErrorCode, FlattenError

WIDEST = 1000.0  # millimeters; a larger width is probably in another unit


def problem(message: str, code: ErrorCode | str = "invalid_option") -> FlattenError:
    return FlattenError(code, message)


def checked_length(name: str, value: float, least: float = 0.0, most: float = WIDEST) -> float:
    """Return the value as a float. Raises FlattenError if it is not a number from `least` to `most` millimeters."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise problem(f"{name} is {value!r}: give a number of millimeters.") from None
    if not least <= number <= most:  # also true for NaN, for which both comparisons are false
        raise problem(f"{name} is {number:g}: give millimeters from {least:g} to {most:g}.")
    return number


def checked_names(names: Sequence[str] | None, count: int) -> list[str]:
    if count == 0:
        raise problem("The result has no pieces.")
    if names is None:
        return [f"Piece {number}" for number in range(1, count + 1)]
    if isinstance(names, str) or len(names) != count or not all(isinstance(name, str) for name in names):
        raise problem(f"piece_names must be {count} texts, one for each piece.")
    return list(names)
