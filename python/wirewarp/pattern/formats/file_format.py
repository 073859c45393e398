# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes a kind of file. Commands, dialogs and tests read the descriptions, so they need no format by name."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..pattern_data import PatternData
from ..progress import Steps

Writer = Callable[..., Steps[tuple[int, list[str]]]]  # (path, pattern, **options) -> number of pages, warnings


class Choice(NamedTuple):
    value: str
    label: str
    description: str


@dataclass(frozen=True)
class Option:
    """A keyword argument of the writer, which dialogs show as a setting."""

    name: str
    label: str
    description: str
    choices: tuple[Choice, ...] = ()  # the first choice is the default; without choices, the option is on or off
    unless: tuple[str, str] | None = None  # another option, and the value with which it disables this one


@dataclass(frozen=True)
class Format:
    suffix: str  # ".svg"
    label: str
    description: str
    write: Writer
    # outlines (k,2) in millimeters, read by code that no writer uses
    read_cut_lines: Callable[[Path], Iterator[np.ndarray]]
    options: tuple[Option, ...] = ()
    has_pages: bool = False  # whether the writer also accepts `paper` and `keep_places`
    is_along_cloth: bool = False  # whether markers are drawn with x along the cloth
    size_of: Callable[[PatternData], np.ndarray] = lambda pattern: pattern.size  # (2,) size of a file without pages
