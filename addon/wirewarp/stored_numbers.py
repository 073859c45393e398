# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of numbers among the custom properties of a data-block. Users and other scripts may have written anything."""

import bpy
import numpy as np


def read_numbers(owner: bpy.types.ID, name: str) -> np.ndarray | None:
    """(k,) the numbers of a property that is a list of them; None if there is none such."""
    stored = owner.get(name)
    is_list = hasattr(stored, "typecode")  # of an IDPropertyArray
    return np.array(stored) if is_list else None
