# SPDX-License-Identifier: GPL-3.0-or-later
"""How a piece comes to lie somewhere else."""

import math
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Motion:
    """Mirrored first, so that x becomes -x, then turned about the origin, then moved."""

    offset: np.ndarray  # (2,) millimeters
    angle: float = 0.0  # degrees counterclockwise
    mirrored: bool = False

    def directions(self, vectors: np.ndarray) -> np.ndarray:
        """Of vectors (..., 2) that have no place."""
        cosine, sine = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        turned: np.ndarray = vectors * (-1 if self.mirrored else 1, 1) @ np.array([[cosine, sine], [-sine, cosine]])
        return turned

    def points(self, points: np.ndarray) -> np.ndarray:
        """Of points (..., 2)."""
        moved: np.ndarray = (self.directions(points) if self.angle or self.mirrored else points) + self.offset
        return moved

    def text_angle(self, degrees: float) -> float:
        """Of a text, which is never mirrored, and is read from below or from the right."""
        if not self.angle and not self.mirrored:
            return degrees
        turned = (-degrees if self.mirrored else degrees) + self.angle
        return 90.0 - (90.0 - turned) % 180.0
