# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the pieces as the object "<name> Flat" in the collection "WireWarp", and as UV maps."""

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import bpy
import numpy as np

from ..blender.attributes import check_free, write_marked, write_values
from ..blender.mesh import add_seams, add_sharp_edges, write_corners, write_edges, write_edited_uv, write_faces
from ..blender.mesh import write_uv as write_layer
from ..blender.objects import remove_object
from ..blender.selection import deselect_all
from ..core import Note
from ..issues import object_error
from ..names import (
    COLLECTION,
    FAILED_MATERIAL,
    FLAT_LENGTH,
    PIECE,
    PIECE_INDEX,
    SEAM,
    SIDE_EASE,
    SOURCE_CORNER,
    SOURCE_FACE,
    SOURCE_VERTEX,
    UV_LAYER,
    UV_SCALE,
)
from ..solve.arrays import MeshArrays, edge_lengths
from ..solve.flat_mesh import FlatMarks, FlatMesh, flat_marks
from ..state.flat_pieces import is_true_size
from ..state.identities import write_names
from ..state.marked_mesh import write_marks
from ..state.owners import find_flat_object, flat_name, model_of
from ..state.record import FlatRecord, write_maps, write_record
from .places import free_place

MAX_UV_LAYERS = 8  # the limit of Blender


def check_uv_room(target: bpy.types.Object) -> None:
    mesh = target.data
    if UV_LAYER in mesh.uv_layers:
        return
    check_free(target, UV_LAYER, "the map of the pieces")
    if len(mesh.uv_layers) >= MAX_UV_LAYERS:
        raise object_error(
            "no_uv_room",
            f'Mesh "{mesh.name}" already has {MAX_UV_LAYERS} UV maps, and Blender allows no more: '
            "delete one under Object Data > UV Maps.",
        )


def write_uv(mesh: bpy.types.Mesh, flat: FlatMesh, corner_count: int) -> float:
    """Write the UV map of the packed pieces in the unit square. Faces without a layout get (0,0). Return the scale in
    Blender units per UV unit, which is also stored on the mesh."""
    places, scale = _in_unit_square(flat.vertices)
    of_corners = np.zeros((corner_count, 2), dtype=np.float32)
    _pairs(of_corners)[flat.source_corner] = _pairs(places)[flat.loop_vertices]
    if mesh.is_editmode:
        write_edited_uv(mesh, UV_LAYER, of_corners)
    else:
        write_layer(mesh.uv_layers.get(UV_LAYER) or mesh.uv_layers.new(name=UV_LAYER, do_init=False), of_corners)
    mesh.uv_layers.active = mesh.uv_layers[UV_LAYER]
    mesh[UV_SCALE] = scale
    return scale


def _in_unit_square(vertices: np.ndarray) -> tuple[np.ndarray, float]:
    """Return vertices (p,2) as float32, scaled to the unit square, and the side of the square before the scaling."""
    low, high = ([pick(column) for column in vertices.T] for pick in (np.min, np.max))
    scale = float(np.subtract(high, low).max()) or 1.0
    return ((vertices - low) / scale).astype(np.float32), scale


def _pairs(places: np.ndarray) -> np.ndarray:
    """Return rows (k,2) of float32 as complex numbers (k,), because indexing complex numbers is much faster."""
    return places.view(np.complex64)[:, 0]


def write_flat_maps(mesh: bpy.types.Mesh, flat: FlatMesh, arrays: MeshArrays) -> None:
    """Write UV maps on a flat mesh that has none: the source's own maps, for textures such as printed fabric,
    and a map of the pieces."""
    for name, places in list(arrays.uv_maps.items())[: MAX_UV_LAYERS - 1]:
        _write_new(mesh, name, _pairs(places)[flat.source_corner])
    places, _ = _in_unit_square(flat.vertices)
    _write_new(mesh, UV_LAYER, _pairs(places)[flat.loop_vertices])
    mesh.uv_layers.active = mesh.uv_layers[0]  # a map of the source, if there is one


def _write_new(mesh: bpy.types.Mesh, name: str, pairs: np.ndarray) -> None:
    write_layer(mesh.uv_layers.new(name=name, do_init=False), pairs.view(np.float32).reshape(-1, 2))


# The name of our collection has a suffix in a second scene, or if a linked collection has the plain name.
OUR_NAMES = re.compile(rf"{COLLECTION}(\.\d+)?")
RED = (0.8, 0.02, 0.02, 1.0)  # linear; similar to the lines of failed areas in overlay/lines.py


def write_flat_object(
    scene: bpy.types.Scene,
    source: bpy.types.Object,
    flat: FlatMesh,
    arrays: MeshArrays,
    record: FlatRecord,
    models: Sequence[bpy.types.Object],
) -> bpy.types.Object:
    """Make the flat object of `source`, or replace its mesh. After an error, restore the earlier pieces.

    models: all models of the run, which a new flat object does not overlap
    """
    earlier, name = find_flat_object(source), flat_name(source.name)
    target = earlier or bpy.data.objects.new(name, bpy.data.meshes.new(name))
    if earlier and _is_shared(target):
        target.data = bpy.data.meshes.new(target.name)
    with _restored_on_failure(target, is_new=earlier is None):
        _write_mesh(target, source, flat, arrays, record)
        if earlier is None:
            target.location = free_place(scene, source, flat.vertices.max(axis=0, initial=0.0), models)
            target.wirewarp_source = source
    if scene not in target.users_scene:
        our_collection(scene).objects.link(target)
    target.scale = target.delta_scale = (1, 1, 1)  # place and rotation do not change, but the scale must be 1
    return target


@contextmanager
def _restored_on_failure(target: bpy.types.Object, *, is_new: bool) -> Iterator[None]:
    earlier = None if is_new else target.data.copy()
    try:
        yield
    except BaseException:
        if earlier is None:
            remove_object(target)
            raise
        written, name = target.data, target.data.name
        written.user_remap(earlier)
        bpy.data.meshes.remove(written)
        earlier.name = name
        raise
    if earlier:
        bpy.data.meshes.remove(earlier)


def _is_shared(flat: bpy.types.Object) -> bool:
    """Return whether the mesh of the pieces must not change: it is linked, or another object, such as the model, uses
    it."""
    model, users = model_of(flat), (each for each in bpy.data.objects if each.data == flat.data)
    return flat.data.library is not None or any(model_of(user) != model for user in users)


def show_flat_object(view_layer: bpy.types.ViewLayer, target: bpy.types.Object) -> list[Note]:
    """Make the object visible in the Outliner. Return notes that say why the object is still hidden, or not in actual
    size."""
    notes = []
    if target in view_layer.objects.values():
        target.hide_set(False)
    if not target.visible_get(view_layer=view_layer):
        why = "it is disabled in viewports, or its collection is hidden"
        notes.append(Note(f'"{target.name}" is hidden: {why}. Show it in the Outliner.'))
    if not is_true_size(target):
        text = f'"{target.name}" is not shown in actual size, because its parent or a constraint scales it.'
        notes.append(Note(text, is_warning=True))
    return notes


def _write_mesh(
    target: bpy.types.Object, source: bpy.types.Object, flat: FlatMesh, arrays: MeshArrays, record: FlatRecord
) -> None:
    """Replace the mesh of the flat object. Shape keys and vertex groups of the former vertices are removed."""
    mesh = target.data
    target.shape_key_clear()
    target.vertex_groups.clear()
    _write_faces(mesh, flat)
    deselect_all(mesh)  # so that L (Select Linked) in Edit Mode selects one piece only
    _write_attributes(mesh, flat)
    write_record(mesh, record)
    write_maps(mesh, flat)
    _write_marks(mesh, flat_marks(flat.source_edge, arrays))
    write_marked(mesh, SIDE_EASE, flat.side_eases)
    write_names(mesh, {wire.chain.wire_id: wire.name for wire in arrays.wires})
    write_flat_maps(mesh, flat, arrays)
    _write_materials(mesh, source, flat, arrays)


def _write_faces(mesh: bpy.types.Mesh, flat: FlatMesh) -> None:
    mesh.clear_geometry()
    coordinates = np.zeros((len(flat.vertices), 3), dtype=np.float32)
    coordinates[:, :2] = flat.vertices
    mesh.vertices.add(len(flat.vertices))
    mesh.vertices.foreach_set("co", coordinates.ravel())
    mesh.loops.add(len(flat.loop_vertices))
    mesh.edges.add(len(flat.edges))
    write_edges(mesh, flat.edges)
    write_corners(mesh, flat.loop_vertices, flat.loop_edges)
    mesh.polygons.add(len(flat.face_starts))
    write_faces(mesh, flat.face_starts, flat.face_sizes)
    mesh.update()


def _write_attributes(mesh: bpy.types.Mesh, flat: FlatMesh) -> None:
    write_values(mesh, SOURCE_VERTEX, flat.source_vertex)
    write_values(mesh, SOURCE_CORNER, flat.source_corner)
    write_values(mesh, SOURCE_FACE, flat.source_face)
    write_values(mesh, PIECE_INDEX, flat.face_piece)
    write_values(mesh, PIECE, flat.piece_id)
    write_values(mesh, FLAT_LENGTH, edge_lengths(flat.vertices, flat.edges).astype(np.float32))


def _write_marks(mesh: bpy.types.Mesh, marks: FlatMarks) -> None:
    """Mark the seams and wires. Wires also become sharp edges, so that Edit Mode shows them in blue."""
    add_seams(mesh, np.flatnonzero(marks.seams))
    add_sharp_edges(mesh, marks.wires.rows)
    write_marks(mesh, marks.wires)
    write_values(mesh, SEAM, marks.seam_ids)


def our_collection(scene: bpy.types.Scene) -> bpy.types.Collection:
    """Return the scene's collection for flat pieces. Create it if it is missing."""
    for collection in scene.collection.children_recursive:
        if OUR_NAMES.fullmatch(collection.name) and not (collection.library or collection.override_library):
            return collection
    collection = bpy.data.collections.new(COLLECTION)
    scene.collection.children.link(collection)
    return collection


def _write_materials(mesh: bpy.types.Mesh, source: bpy.types.Object, flat: FlatMesh, arrays: MeshArrays) -> None:
    """Assign the model's materials to the faces, and the add-on's material to failed faces. If the model has no
    materials, keep those of the flat object."""
    kept = [material for material in mesh.materials if not (material and material.name == FAILED_MATERIAL)]
    own = [slot.material for slot in source.material_slots]
    shown = own or kept
    slots = np.minimum(arrays.materials[flat.source_face], max(len(own) - 1, 0))
    if flat.failed.any():
        shown = [*(shown or [None]), bpy.data.materials.get(FAILED_MATERIAL) or _new_material()]
        slots = np.where(flat.failed, len(shown) - 1, slots)
    mesh.materials.clear()
    for material in shown:
        mesh.materials.append(material)
    if slots.any():  # new faces already use the first slot
        indices = mesh.attributes.get("material_index") or mesh.attributes.new("material_index", "INT", "FACE")
        indices.data.foreach_set("value", slots.astype(np.int32))


def _new_material() -> bpy.types.Material:
    material = bpy.data.materials.new(FAILED_MATERIAL)
    material.diffuse_color = RED
    return material


def follow_name(source: bpy.types.Object, earlier: str) -> None:
    """Rename the flat object after the model, unless the user has renamed it. earlier: the model's former name."""
    flat = find_flat_object(source)
    # The mesh has the same name as the object.
    for each in (flat, flat.data) if flat and earlier != source.name else ():
        if each.name == flat_name(earlier) and each.library is None:
            each.name = flat_name(source.name)
