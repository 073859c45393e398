# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading from a flat mesh what of the model its elements are."""

import bpy

from .flat_attributes import has_flat_attributes, read_flat_attribute
from .issues import object_error
from .mesh_topology import corner_vertices, edge_vertices, face_sizes
from .owners import find_flat_object, has_flat_object
from .report_elements import FlatSources


def no_pieces_sentence(source: bpy.types.Object) -> str:
    return f'There are no flat pieces to this report: flatten "{source.name}" again.'


def flat_sources(source: bpy.types.Object, report: dict) -> tuple[bpy.types.Object, FlatSources]:
    """The flat object of the model, in Object Mode. Raises ObjectError if there is none to this report."""
    flat = find_flat_object(source)
    if (
        not has_flat_object(source)
        or "flat_object" not in report
        or not has_flat_attributes(flat.data, "piece", "source_vertex", "source_face")
    ):
        raise object_error("no_flat_pieces", no_pieces_sentence(source))
    mesh = flat.data
    return flat, FlatSources(
        vertices=read_flat_attribute(mesh, "source_vertex"),
        edges=edge_vertices(mesh),
        faces=read_flat_attribute(mesh, "source_face"),
        piece=read_flat_attribute(mesh, "piece"),
        loop_vertices=corner_vertices(mesh),
        face_sizes=face_sizes(mesh),
    )
