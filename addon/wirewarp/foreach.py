# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's collections to numpy arrays."""

import bpy
import numpy as np


def read(collection: bpy.types.bpy_prop_collection, name: str, dtype: type, columns: int = 1) -> np.ndarray:
    """One property of all elements: (k,), or (k, columns). The dtype must be the property's own to be fast."""
    values = np.empty(len(collection) * columns, dtype=dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values
