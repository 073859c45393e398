# SPDX-License-Identifier: GPL-3.0-or-later
"""What a kind of file says of itself: commands, dialogs and tests read it from here and know no format by name."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..pattern_data import PatternData
from ..progress import Steps

Writer = Callable[..., Steps[tuple[int, list[str]]]]  # (path, pattern, **options): pages, and sentences that warn


class Choice(NamedTuple):
    value: str
    label: str
    description: str


@dataclass(frozen=True)
class Option:
    """A keyword of the writer that dialogs offer."""

    name: str
    label: str
    description: str
    choices: tuple[Choice, ...] = ()  # the first is the default; without choices it is on or off
    unless: tuple[str, str] | None = None  # another option, and the value with which this one has no effect


@dataclass(frozen=True)
class Format:
    suffix: str  # ".svg"
    label: str
    description: str
    write: Writer
    read_cut_lines: Callable[[Path], Iterator[np.ndarray]]  # (k,2) millimeters each, by code of its own
    options: tuple[Option, ...] = ()
    has_pages: bool = False  # then the writer also takes `paper` and `keep_places`
    is_along_cloth: bool = False  # markers are drawn with x along the cloth
    size_of: Callable[[PatternData], np.ndarray] = lambda pattern: pattern.size  # (2,) of a file without pages
