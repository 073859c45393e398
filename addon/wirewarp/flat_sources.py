# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading from a flat mesh what of the model its elements are."""

import bpy
import numpy as np

from .flat_attributes import has_flat_attributes, read_flat_attribute
from .foreach import read
from .issues import object_error
from .owners import find_flat_object
from .report_elements import FlatSources


def flat_sources(source: bpy.types.Object, report: dict) -> tuple[bpy.types.Object, FlatSources]:
    """The flat object of the model, in Object Mode. Raises ObjectError if there is none to this report."""
    flat = find_flat_object(source)
    if (
        flat is None
        or "flat_object" not in report
        or not has_flat_attributes(flat.data, "piece", "source_vertex", "source_face")
    ):
        raise object_error("no_flat_pieces", f'There are no flat pieces to this report: flatten "{source.name}" again.')
    mesh = flat.data
    return flat, FlatSources(
        vertices=read_flat_attribute(mesh, "source_vertex"),
        edges=read(mesh.edges, "vertices", np.int32, 2),
        faces=read_flat_attribute(mesh, "source_face"),
        piece=read_flat_attribute(mesh, "piece"),
        loop_vertices=read(mesh.loops, "vertex_index", np.int32),
        face_sizes=read(mesh.polygons, "loop_total", np.int32),
    )
