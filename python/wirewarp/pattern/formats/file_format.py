# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes a kind of file. Commands, dialogs and tests use the descriptions, so they need no code for each format."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..pattern_data import PatternData
from ..progress import Steps

Writer = Callable[..., Steps[tuple[int, list[str]]]]  # (path, pattern, **options) -> (number of pages, warnings)


class Choice(NamedTuple):
    value: str
    label: str
    description: str


@dataclass(frozen=True)
class Option:
    """An option of the writer, which dialogs show as a setting."""

    name: str
    label: str
    description: str
    choices: tuple[Choice, ...] = ()  # the first choice is the default; without choices, the option is on or off
    unless: tuple[str, str] | None = None  # (name, value): disabled if the option of this name has this value


@dataclass(frozen=True)
class Format:
    suffix: str  # ".svg"
    label: str
    description: str
    write: Writer
    # This function returns the cutting lines (k,2) in millimeters. It shares no code with the writers, because it
    # checks their files.
    read_cut_lines: Callable[[Path], Iterator[np.ndarray]]
    options: tuple[Option, ...] = ()
    has_pages: bool = False  # whether the writer also accepts `paper` and `keep_places`
    is_along_cloth: bool = False  # whether files of markers have x along the fabric; otherwise, y is along it
    # This function returns the size (2,) of a file without pages, in millimeters.
    size_of: Callable[[PatternData], np.ndarray] = lambda pattern: pattern.size
