# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads an object's mesh with its seams, wires and regions into arrays, and checks, adds and applies modifiers."""

from dataclasses import replace

import bpy
import numpy as np

from ..blender.mesh import (
    current_mesh,
    edge_vertices,
    evaluated_mesh,
    face_starts,
    faces_at_edges,
    groups_of,
    read_attribute,
    read_uv,
    triangle_corners,
    vertex_places,
)
from ..blender.objects import linear_part
from ..core import Note, counted
from ..issues import object_error
from ..names import NO_SEAM, PIECE, SEAM, UV_LAYER
from ..solve.arrays import FaceRegions, MeshArrays, NamedWire, Region, with_split_quads
from ..solve.chains import WireChain, chains_of_marks
from .allowances import SIDE_EASES, corner_widths, widest_allowance
from .identities import chain_names
from .marked_mesh import MarkedMesh, own_ids, read_ids, read_marked

# This is the number of levels of a new modifier. The largest turn that counts as a curve has 60 degrees. Two levels
# divide it into turns of 15 degrees.
LEVELS = 2
MOST_LEVELS = 4  # maximum number of levels, because each level has four times as many faces
ROUNDING = 1e-5  # rounding error of the vertices' places under an armature at rest, as a share of the model's size


def left_out(source: bpy.types.Object, arrays: MeshArrays | None, use_modifiers: bool) -> list[Note]:
    """Return notes about data of the model that the run does not use or change."""
    notes = []
    if use_modifiers and UV_LAYER in source.data.uv_layers:
        text = f'The UV map "{UV_LAYER}" is from an earlier run without Modifiers. It does not show these pieces.'
        notes.append(Note(text))
    if arrays and arrays.loose_marks:
        ignored = counted(arrays.loose_marks, "marked edge has no face and was", "marked edges have no face and were")
        notes.append(Note(f"{ignored} ignored.", is_warning=True))
    if arrays and arrays.loose_eases:
        edges = counted(
            arrays.loose_eases,
            "edge has an ease but is not a wire, so the ease was not used. Select it",
            "edges have an ease but are not wires, so the ease was not used. Select them",
        )
        notes.append(Note(f"{edges} and press All Sides.", is_warning=True))
    return notes


def shaped_by(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> list[str]:
    """Return "modifiers" and "shape keys" if these change the evaluated shape of the object.

    For example, an armature at rest changes nothing. The object must be in Object Mode.
    """
    makers = ["modifiers"] if any(modifier.show_viewport for modifier in source.modifiers) else []
    makers += ["shape keys"] if source.data.shape_keys else []
    if not makers:
        return []
    return [] if _is_same_shape(source.data, source.evaluated_get(depsgraph).data) else makers


def subdivide(source: bpy.types.Object, is_used: bool) -> None:
    """Add a Subdivision Surface modifier that keeps corners of outlines, or a level to the present modifier.

    is_used: whether the last run used modifiers; if not, the present modifier keeps its level
    """
    found = [modifier for modifier in source.modifiers if modifier.type == "SUBSURF" and modifier.show_viewport]
    if found and is_used:
        found[-1].levels = max(found[-1].levels, min(found[-1].levels + 1, MOST_LEVELS))
    elif not found:
        added = source.modifiers.new("Subdivision", "SUBSURF")
        added.levels = added.render_levels = LEVELS
        added.boundary_smooth = "PRESERVE_CORNERS"


def outline_change(source: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> float:
    """Return the relative change of the outlines' length by modifiers, below 0 if outlines become shorter. The object
    must be in Object Mode."""
    before = _outline_length(source.data)
    with evaluated_mesh(source, depsgraph) as mesh:
        return _outline_length(mesh) / before - 1 if before else 0.0


def _outline_length(mesh: bpy.types.Mesh) -> float:
    ends = vertex_places(mesh)[edge_vertices(mesh)[faces_at_edges(mesh) == 1]]
    return float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum())


def check_modifiers(source: bpy.types.Object) -> None:
    if source.data.shape_keys or source.data.users > 1:
        why = "has shape keys" if source.data.shape_keys else "shares its mesh with other objects"
        remedy = "Delete the shape keys" if source.data.shape_keys else "Use Object > Relations > Make Single User"
        raise object_error("modifiers", f'"{source.name}" {why}, so modifiers cannot be applied. {remedy} first.')


def apply_modifiers(source: bpy.types.Object) -> None:
    """Apply all visible modifiers in Object Mode. Raises ObjectError, with nothing changed, if Blender cannot apply
    them."""
    check_modifiers(source)
    with bpy.context.temp_override(object=source, active_object=source):
        for name in [modifier.name for modifier in source.modifiers if modifier.show_viewport]:
            bpy.ops.object.modifier_apply(modifier=name)


def _is_same_shape(base: bpy.types.Mesh, seen: bpy.types.Mesh) -> bool:
    """Return whether the two meshes have the same shape. Vertices that a modifier repeats by splitting edges do not
    matter."""
    if len(base.polygons) != len(seen.polygons):
        return False
    places, seen_places = (vertex_places(mesh) for mesh in (base, seen))
    if len(places) != len(seen_places):
        return np.array_equal(np.unique(places, axis=0), np.unique(seen_places, axis=0))
    size = float(np.abs(places).max(initial=0))
    return bool(np.allclose(places, seen_places, rtol=0, atol=ROUNDING * size, equal_nan=True))


LARGEST = 1e18  # largest coordinate, in Blender units; areas (1e36) stay within single precision (3e38)
SAMPLE = 5_000  # maximum number of faces whose regions are read, because reading groups vertex by vertex is slow
NO_REGIONS = {NO_SEAM, "sharp_face"}  # boolean face attributes that do not name a part of a model


def object_to_arrays(source: bpy.types.Object, base: MarkedMesh, depsgraph: bpy.types.Depsgraph | None) -> MeshArrays:
    """Return the object's base mesh as arrays, or with a depsgraph the mesh with modifiers. Raises ObjectError if the
    mesh or its marks are unusable. base: data already read from the base mesh."""
    linear = linear_part(source)
    if depsgraph is None:
        with current_mesh(source) as mesh:
            return _to_arrays(mesh, base, source, linear, has_modifiers=False)
    with evaluated_mesh(source, depsgraph) as mesh:
        return _to_arrays(mesh, read_marked(mesh), source, linear, has_modifiers=True)


def _check_size(source: bpy.types.Object, vertices: np.ndarray) -> None:
    """Raises ObjectError if areas would not be finite in single precision. Ignores coordinates that are not finite,
    because the core reports them."""
    if LARGEST < np.abs(vertices).max(initial=0) < np.inf:
        raise object_error(
            "too_large",
            f'"{source.name}" is more than {LARGEST:.0e} Blender units wide, so its areas cannot be computed. '
            "Scale it down.",
        )


def _to_arrays(
    mesh: bpy.types.Mesh, marked: MarkedMesh, source: bpy.types.Object, linear: np.ndarray, *, has_modifiers: bool
) -> MeshArrays:
    """Return the mesh as arrays. marked: data already read from the mesh; linear (3,3): see linear_part; has_modifiers:
    whether modifiers made the mesh."""
    mirrored = bool(np.linalg.det(linear) < 0)
    mesh.calc_loop_triangles()
    # Faces of a mirrored object still face outward in Blender, but the order of their corners is reversed.
    starts, sizes = face_starts(mesh), marked.face_sizes
    loops = with_split_quads(triangle_corners(mesh), starts, sizes, marked.places[marked.corner_vertices])
    if mirrored:
        loops = np.ascontiguousarray(loops[:, ::-1])
    vertices = marked.places.astype(np.float64) @ linear.T
    _check_size(source, vertices)
    SIDE_EASES.check(mesh, has_modifiers=has_modifiers)
    edges = marked.edges
    face_count = np.bincount(marked.corner_edges, minlength=len(edges))
    in_face = face_count > 0
    seams = np.flatnonzero(marked.seams & in_face)  # without loose edges, which do not cut faces
    return MeshArrays(
        vertices=vertices,
        triangles=marked.corner_vertices[loops],
        triangle_loops=loops,
        # Blender stores triangles in the order of their polygons: n - 2 triangles for a polygon of n corners.
        triangle_polygons=np.repeat(np.arange(len(sizes), dtype=np.int32), sizes - 2),
        loop_vertices=marked.corner_vertices,
        loop_edges=marked.corner_edges,
        polygon_starts=starts,
        polygon_sizes=sizes,
        edges=edges,
        seam_edges=seams,
        seams=edges[seams],
        seam_ids=read_ids(mesh, SEAM)[seams],
        outline=edges[face_count == 1],
        wires=_name_wires(source.data, chains_of_marks(edges, marked.marks.without(~in_face), vertices)),
        side_eases=marked.side_eases,
        grain_wire=source.data.wirewarp_grain,
        piece_ids=read_ids(mesh, PIECE),
        regions=face_regions(source, mesh),
        materials=_slots(mesh),
        uv_maps={layer.name: read_uv(layer) for layer in mesh.uv_layers if layer.name != UV_LAYER},
        own_map=own_map.name if (own_map := own_uv_map(mesh)) else "",
        allowance=widest_allowance(mesh),
        side_allowances=corner_widths(mesh),
        loose_marks=len(marked.marks.take(~in_face).rows),
        loose_eases=int(np.count_nonzero(marked.marks.eases[~marked.marks.are_wires])),
        mirrored=mirrored,
    )


def own_uv_map(mesh: bpy.types.Mesh) -> bpy.types.MeshUVLoopLayer | None:
    """Return the user's active UV map; None if there is only WireWarp's map.

    If WireWarp's map is active, return the user's map for rendering, or else the user's first map.
    """
    active, others = mesh.uv_layers.active, [each for each in mesh.uv_layers if each.name != UV_LAYER]
    if active is None or active.name != UV_LAYER:
        return active
    return next((each for each in others if each.active_render), others[0] if others else None)


def _name_wires(named: bpy.types.Mesh, chains: list[WireChain]) -> list[NamedWire]:
    """Return the wires, each with a separate name and id. named: the mesh with the list of names."""
    ids = [chain.wire_id for chain in chains]
    return [
        NamedWire(name, replace(chain, wire_id=own), chain.wire_id)
        for name, own, chain in zip(chain_names(named, ids), own_ids(ids), chains, strict=True)
    ]


def face_regions(source: bpy.types.Object, mesh: bpy.types.Mesh) -> FaceRegions:
    """Return the regions of the mesh, which is the object's own or the result of its modifiers."""
    count = len(mesh.polygons)
    sample = np.arange(0, count, max(1, -(-count // SAMPLE)))
    groups = [*_face_attributes(mesh, sample), *_groups(source, mesh, sample)]
    return FaceRegions(sample, groups, _materials(source, mesh, sample))


def _slots(mesh: bpy.types.Mesh) -> np.ndarray:
    slots = read_attribute(mesh, "material_index", "INT", "FACE")
    return np.zeros(len(mesh.polygons), dtype=np.int32) if slots is None else slots


def _groups(source: bpy.types.Object, mesh: bpy.types.Mesh, sample: np.ndarray) -> list[Region]:
    """Return a region for each vertex group: the sampled faces whose vertices all belong to the group."""
    if not source.vertex_groups:
        return []
    groups_at: dict[int, set[int]] = {}
    members: list[list[int]] = [[] for _ in source.vertex_groups]
    for face in sample.tolist():
        corners = mesh.polygons[face].vertices
        for vertex in corners:
            if vertex not in groups_at:
                groups_at[vertex] = groups_of(mesh.vertices[vertex])
        for group in set.intersection(*(groups_at[vertex] for vertex in corners)):
            if group < len(members):  # a weight may refer to a group that was removed
                members[group].append(face)
    named = zip(source.vertex_groups, members, strict=True)
    return [Region(group.name, np.array(faces, dtype=np.int64)) for group, faces in named if faces]


def _face_attributes(mesh: bpy.types.Mesh, sample: np.ndarray) -> list[Region]:
    """Return a region for each boolean face attribute. Attributes of Blender, whose names begin with a
    dot, are left out."""
    found = []
    for attribute in mesh.attributes:
        if (attribute.data_type, attribute.domain) != ("BOOLEAN", "FACE") or attribute.name in NO_REGIONS:
            continue
        if not attribute.name.startswith("."):
            is_in = read_attribute(mesh, attribute.name, "BOOLEAN", "FACE")
            found.append(Region(attribute.name, sample[is_in[sample]]))
    return [region for region in found if len(region.faces)]


def _materials(source: bpy.types.Object, mesh: bpy.types.Mesh, sample: np.ndarray) -> list[Region]:
    of_sample = _slots(mesh)[sample]
    materials = [slot.material for slot in source.material_slots]
    present = [(material, sample[of_sample == index]) for index, material in enumerate(materials) if material]
    return [Region(material.name, faces) for material, faces in present if len(faces)]
