# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas of triangles. No Blender in here."""

import numpy as np


def area_vectors(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(3,m): along each triangle's normal and as long as its area. vertices (n,3), triangles (m,3)."""
    x, y, z = (np.ascontiguousarray(column)[triangles] for column in vertices.T)  # (m,3), one per corner
    ux, uy, uz = (each[:, 1] - each[:, 0] for each in (x, y, z))
    vx, vy, vz = (each[:, 2] - each[:, 0] for each in (x, y, z))
    return np.array([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]) / 2


def triangle_areas(vertices: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(m,)"""
    x, y, z = area_vectors(vertices, triangles)
    return np.sqrt(x * x + y * y + z * z)
