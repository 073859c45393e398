# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the outline of a letter from a font."""

from collections.abc import Sequence

import numpy as np

Part = tuple[str, np.ndarray]  # "m", "l", "c" or "h" as PDF has them, and its points (k,2)


class GlyphPen:
    """Takes outlines as fonttools' pens do; PDF has cubic curves alone."""

    def __init__(self) -> None:
        self.parts: list[Part] = []
        self._at = np.zeros(2)

    def moveTo(self, point: Sequence[float]) -> None:  # noqa: N802
        self._add("m", point)

    def lineTo(self, point: Sequence[float]) -> None:  # noqa: N802
        self._add("l", point)

    def qCurveTo(self, control: Sequence[float], end: Sequence[float]) -> None:  # noqa: N802
        middle, last = np.array(control, dtype=float), np.array(end, dtype=float)
        self._add("c", (self._at + 2 * middle) / 3, (last + 2 * middle) / 3, last)

    def curveTo(self, *points: Sequence[float]) -> None:  # noqa: N802
        self._add("c", *points)

    def closePath(self) -> None:  # noqa: N802
        self.parts.append(("h", np.empty((0, 2))))

    def _add(self, operator: str, *points: Sequence[float] | np.ndarray) -> None:
        self.parts.append((operator, np.array(points, dtype=float)))
        self._at = self.parts[-1][1][-1]
