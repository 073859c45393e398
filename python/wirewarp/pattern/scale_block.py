# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured before cutting: two squares, and bars in both directions, for printers stretch one of them."""

from collections.abc import Iterator

import numpy as np

from .drawing import Stroke
from .model import Text
from .units import INCH, UnitSystem

SIZE = np.array([166.0, 158.0])  # millimeters; fits on A4 and Letter
CORNER = 4.0
TICK = 3.0
UNIT = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def scale_block(corner: np.ndarray, units: UnitSystem) -> tuple[list[Stroke], list[Text]]:
    """At this lower left corner (2,)."""
    origin = corner + CORNER
    if units.name == "metric":
        bar, first, second = (150.0, "150 mm"), (100.0, "100 mm"), (2 * INCH, "2 in")
    else:
        bar, first, second = (6 * INCH, "6 in"), (4 * INCH, "4 in"), (50.0, "50 mm")
    strokes = [*_bar(origin, bar[0], np.array([1.0, 0.0])), *_bar(origin, bar[0], np.array([0.0, 1.0]))]
    texts = [
        Text((bar[1],), origin + (bar[0] - 10, 5.0), 4.0),
        Text((bar[1],), origin + (5.0, bar[0] - 10), 4.0, 90.0),
    ]
    at = origin + 8.0
    for (side, label), lines in ((first, ("Measure before cutting",)), (second, ())):
        strokes.append(Stroke("scale", at + side * UNIT, True))
        texts.append(Text((label, *lines), at + side / 2, 5.0))
        at = at + (side + 4.0, 0.0)
    return strokes, texts


def _bar(origin: np.ndarray, length: float, along: np.ndarray) -> Iterator[Stroke]:
    """With a tick at both ends, whose distance is the length."""
    aside = np.array([-along[1], along[0]]) * TICK
    yield Stroke("scale", np.array([origin, origin + length * along]))
    for end in (origin, origin + length * along):
        yield Stroke("scale", np.array([end - aside, end + aside]))
