# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the user wants no seam: faces with an attribute of our name, and vertices of a group of it.

The attribute may be of any of these numbers, as Geometry Nodes or a script leaves it; what is above 0 counts.
"""

import bpy
import numpy as np

from ..blender.mesh import read_attribute
from ..issues import object_error
from ..names import NO_SEAM
from ..solve.suggest import NoSeam

NUMBERS = ("BOOLEAN", "INT8", "INT", "FLOAT")
OTHER_KIND = (
    'The attribute "{}" of mesh "{}" is not of type BOOLEAN, INT8, INT or FLOAT on faces: '
    "rename or delete it under Object Data > Attributes."
)
LEAST_WEIGHT = 0.5  # of a vertex in the group: painted with half the strength, or more


def read_no_seam(source: bpy.types.Object) -> NoSeam:
    """Of an object in Object Mode. Raises ObjectError if the attribute is of another type or domain."""
    mesh, group = source.data, source.vertex_groups.get(NO_SEAM)
    found = (read_attribute(mesh, NO_SEAM, kind, "FACE") for kind in NUMBERS)
    values = next((each for each in found if each is not None), None)
    if values is None:
        if NO_SEAM in mesh.attributes:
            raise object_error("attribute_type", OTHER_KIND.format(NO_SEAM, mesh.name))
        values = np.zeros(len(mesh.polygons))
    vertices = np.zeros(len(mesh.vertices), dtype=bool)
    if group is not None:
        vertices[:] = [
            any(each.group == group.index and each.weight >= LEAST_WEIGHT for each in vertex.groups)
            for vertex in mesh.vertices
        ]
    return NoSeam(values > 0, vertices)
