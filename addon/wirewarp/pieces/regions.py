# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of faces that have a name. No Blender in here."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Region:
    name: str
    faces: np.ndarray  # (k,) int64, faces of the sample


@dataclass(frozen=True)
class FaceRegions:
    sample: np.ndarray  # (s,) int64: faces of which the regions are known
    groups: list[Region]
    materials: list[Region]
