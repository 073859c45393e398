# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex groups and materials of a model as sets of faces, for naming pieces after them."""

import bpy
import numpy as np

from ..foreach import read_attribute
from .regions import FaceRegions, Region

SAMPLE = 5_000  # faces that are looked at: Blender tells groups vertex by vertex only, which is slow on large meshes
CARRIED = 0.5  # weight from which on a vertex is in its group


def face_regions(source: bpy.types.Object, mesh: bpy.types.Mesh) -> FaceRegions:
    """Of the mesh, which is the object's own or what its modifiers make of it."""
    count = len(mesh.polygons)
    sample = np.arange(0, count, max(1, -(-count // SAMPLE)))
    return FaceRegions(sample, _groups(source, mesh, sample), _materials(source, mesh, sample))


def _groups(source: bpy.types.Object, mesh: bpy.types.Mesh, sample: np.ndarray) -> list[Region]:
    """A face is in the groups that all its vertices are in."""
    if not source.vertex_groups:
        return []
    groups_of: dict[int, set[int]] = {}
    members: list[list[int]] = [[] for _ in source.vertex_groups]
    for face in sample.tolist():
        corners = mesh.polygons[face].vertices
        for vertex in corners:
            if vertex not in groups_of:
                elements = mesh.vertices[vertex].groups
                groups_of[vertex] = {element.group for element in elements if element.weight >= CARRIED}
        for group in set.intersection(*(groups_of[vertex] for vertex in corners)):
            if group < len(members):  # a group that was removed may have left weights
                members[group].append(face)
    named = zip(source.vertex_groups, members, strict=True)
    return [Region(group.name, np.array(faces, dtype=np.int64)) for group, faces in named if faces]


def _materials(source: bpy.types.Object, mesh: bpy.types.Mesh, sample: np.ndarray) -> list[Region]:
    slots = read_attribute(mesh, "material_index", "INT", "FACE")
    of_sample = np.zeros(len(sample), dtype=np.int32) if slots is None else slots[sample]
    materials = [slot.material for slot in source.material_slots]
    present = [(material, sample[of_sample == index]) for index, material in enumerate(materials) if material]
    return [Region(material.name, faces) for material, faces in present if len(faces)]
