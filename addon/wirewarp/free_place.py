# SPDX-License-Identifier: GPL-3.0-or-later
"""Where flat pieces lie at first: on the floor beside their model, clear of what else stands there."""

from collections.abc import Sequence

import bpy
import numpy as np
from mathutils import Vector

from .owners import is_helper, model_of

GAP = 0.1  # of the model's largest dimension
LARGE = 5.0  # times that: a room or a landscape, in which the pieces may lie
SOLID = {"MESH", "CURVE", "SURFACE", "META"}

Box = np.ndarray  # (2,3), the lowest and the highest corner


def free_place(scene: bpy.types.Scene, source: bpy.types.Object, size: np.ndarray) -> Vector:
    """For the lower left corner of pieces of this size (2,) in Blender units.

    Right of the source and of all flat pieces there are, on the level of the source's lowest point.
    """
    own, largest = _world_box(source), max(source.dimensions)
    others = [each for each in scene.objects if each.type in SOLID and each.visible_get() and not is_helper(each)]
    ours = [each for each in scene.objects if model_of(each)]
    right = max(_world_box(each)[1, 0] for each in (source, *ours))
    obstacles = [box for box in map(_world_box, others) if np.ptp(box, axis=0).max() <= LARGE * largest]
    return Vector(_clear_of(obstacles, np.array([right + GAP * largest, own[0, 1], own[0, 2]]), size, GAP * largest))


def _clear_of(obstacles: Sequence[Box], place: np.ndarray, size: np.ndarray, gap: float) -> np.ndarray:
    """The place (3,), or the next to the right of it where no obstacle rises out of the floor or cuts through it."""
    for low, high in sorted(obstacles, key=lambda box: box[0, 0]):
        rises = low[2] <= place[2] + gap and high[2] > place[2]
        if rises and np.all((low[:2] < place[:2] + size) & (high[:2] > place[:2])):
            place = np.array([high[0] + gap, *place[1:]])
    return place


def _world_box(target: bpy.types.Object) -> Box:
    corners = np.array([target.matrix_world @ Vector(corner) for corner in target.bound_box])
    return np.array([corners.min(axis=0), corners.max(axis=0)])
