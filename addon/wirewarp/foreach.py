# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's collections to numpy arrays."""

import bpy
import numpy as np


def read(collection: bpy.types.bpy_prop_collection, name: str, dtype: type, columns: int = 1) -> np.ndarray:
    """One property of all elements: (k,), or (k, columns). The dtype must be the property's own to be fast."""
    values: np.ndarray = np.empty(len(collection) * columns, dtype=dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values


_VALUES = {
    "BOOLEAN": ("value", bool, 1),
    "INT": ("value", np.int32, 1),
    "FLOAT": ("value", np.float32, 1),
    "FLOAT_VECTOR": ("vector", np.float32, 3),
    "FLOAT_COLOR": ("color", np.float32, 4),
}


def read_attribute(mesh: bpy.types.Mesh, name: str, data_type: str, domain: str) -> np.ndarray | None:
    """(k,), (k,3) or (k,4), the values of an attribute; None if there is none of this type on this domain.

    Of a mesh that is not in Edit Mode.
    """
    attribute = mesh.attributes.get(name)
    if attribute is None or (attribute.data_type, attribute.domain) != (data_type, domain):
        return None
    return read(attribute.data, *_VALUES[data_type])
