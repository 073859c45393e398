# SPDX-License-Identifier: GPL-3.0-or-later
"""The name and the area of each flat piece as a text object that lies on it."""

import math
import random

import bpy
import numpy as np
from bpy.app.handlers import persistent
from mathutils import Matrix, Vector

from ..blender.objects import remove_object
from ..blender.units import length_text
from ..issues import note
from ..pattern.make import inner_wires
from ..pattern.outlines import FlatPieces, outline_of
from ..pattern.pattern import PieceText
from ..pattern.piece_texts import piece_texts
from .object import our_collection

PIECE_ID = "wirewarp_piece"  # custom property of a text, a child of the flat object
FLAT_ID = "wirewarp_flat"  # custom property of a flat object and of its texts: a random number
AREA = "wirewarp_area"  # custom property of a text: of its piece, in square Blender units
AREA_LINE = "wirewarp_area_line"  # custom property of a text: the area as it was written last
LARGEST = 0.04  # height of the letters, by the size of all pieces together
THICKNESS = 0.0007  # by the same size: from the pieces up, so that both are seen
MATERIAL = "WireWarp Text"
MOST = 200  # pieces that get texts; Blender is slow with many objects
_owner = object()  # of the subscriptions to Blender's message bus


def write_texts(context: bpy.types.Context, flat: bpy.types.Object, arrays: FlatPieces, report: dict) -> None:
    """Replaces the texts of the flat object by those of the report's pieces; arrays: its mesh, in Blender units."""
    remove_texts(flat)
    pieces = [piece for piece in report["pieces"] if piece["has_layout"]]
    if len(pieces) > MOST:
        report["notes"].append(note(f"Texts are written on up to {MOST} pieces, these are {len(pieces)}."))
        return
    flat[FLAT_ID] = _id(flat, FLAT_ID) or random.randint(1, 2**31 - 1)
    text = length_text(context.scene)
    size = float(np.linalg.norm(np.ptp(arrays.vertices, axis=0)))
    lines = {piece["index"]: (_one_line(piece["name"]), text.area(piece["area_2d"])) for piece in pieces}
    outline = outline_of(arrays)
    wires = {
        index: [arrays.vertices[wire.vertices] for wire in own] for index, own in inner_wires(arrays, outline).items()
    }
    placed = piece_texts(arrays, outline, wires, lines, LARGEST * size)
    corners = _corners_by_piece(arrays)
    targets = []
    for piece in pieces:
        place = placed[piece["index"]]
        below = _face_below(arrays.vertices, corners[piece["index"]], place.center)
        target = _new_text(flat, piece["name"], place, arrays.vertices[below].mean(axis=0), THICKNESS * size)
        target[PIECE_ID], target[FLAT_ID], target[AREA] = piece["piece_id"], flat[FLAT_ID], piece["area_2d"]
        target[AREA_LINE] = lines[piece["index"]][1]
        target.parent_vertices = below
        our_collection(context.scene).objects.link(target)
        targets.append(target)
    _fasten(context.view_layer, flat, targets)


def remove_texts(flat: bpy.types.Object) -> None:
    """Also those whose flat object the user has deleted."""
    for target in [*find_texts(flat), *_find_orphans()]:
        remove_object(target)


def find_texts(flat: bpy.types.Object) -> list[bpy.types.Object]:
    return [target for target in _all_texts() if target.parent == flat]


def _find_orphans() -> list[bpy.types.Object]:
    """Without a parent alone they are the user's, who has taken them off their piece."""
    present = {_id(target, FLAT_ID) for target in bpy.data.objects if target.type == "MESH"}
    return [target for target in _all_texts() if target.parent is None and _id(target, FLAT_ID) not in present]


def _all_texts() -> list[bpy.types.Object]:
    """Of this file."""
    return list(filter(_is_text, bpy.data.objects))


def _is_text(target: bpy.types.Object) -> bool:
    return target.type == "FONT" and target.library is None and bool(_id(target, PIECE_ID))


def _id(target: bpy.types.Object, name: str) -> int:
    """0 where there is none."""
    stored = target.get(name)
    return stored if isinstance(stored, int) else 0


def rename_text(flat: bpy.types.Object, piece_id: int, name: str) -> None:
    """The first line of a piece's text becomes its new name."""
    for target in find_texts(flat):
        if target.get(PIECE_ID) == piece_id:
            _, *rest = target.data.body.split("\n")
            target.data.body = "\n".join([_one_line(name), *rest])


def write_areas(scene: bpy.types.Scene) -> None:
    """The second line of each text in the scene says the area in the units that the scene has now, if it is ours."""
    units = length_text(scene)
    for target in filter(_is_text, scene.objects):
        area, (name, *rest) = target.get(AREA), target.data.body.split("\n")
        if isinstance(area, float) and rest and rest[0] == target.get(AREA_LINE) != units.area(area):
            target[AREA_LINE] = units.area(area)
            target.data.body = "\n".join([name, target[AREA_LINE], *rest[1:]])


def _one_line(name: str) -> str:
    return " ".join(name.splitlines())


def _new_text(
    flat: bpy.types.Object, name: str, text: PieceText, origin: np.ndarray, thickness: float
) -> bpy.types.Object:
    """The text stands aside of the object's origin (2,), to which Blender draws a line from what it is fastened to."""
    curve = bpy.data.curves.new(f"{flat.name} {name}", "FONT")
    curve.body = "\n".join(text.lines)
    curve.size, curve.extrude = max(text.height, 1e-6), thickness
    curve.align_x, curve.align_y = "CENTER", "CENTER"
    curve.materials.append(bpy.data.materials.get(MATERIAL) or _new_material())
    target = bpy.data.objects.new(f"{flat.name} {name}", curve)
    target.parent = flat
    target.location = (*origin, 0)
    target.rotation_euler.z = math.radians(text.angle)
    aside = Vector(text.center - origin)
    aside.rotate(Matrix.Rotation(-target.rotation_euler.z, 2))
    curve.offset_x, curve.offset_y = aside
    return target


def _new_material() -> bpy.types.Material:
    material = bpy.data.materials.new(MATERIAL)
    material.diffuse_color = (0.01, 0.01, 0.02, 1.0)
    return material


def _corners_by_piece(flat: FlatPieces) -> dict[int, np.ndarray]:
    """(k,3) the first three vertices of each face of the piece."""
    first = np.cumsum(flat.face_sizes) - flat.face_sizes
    corners = flat.loop_vertices[first[:, None] + np.arange(3)]
    order = np.argsort(flat.face_piece, kind="stable")
    pieces, begin = np.unique(flat.face_piece[order], return_index=True)
    return dict(zip(pieces.tolist(), np.split(corners[order], begin[1:]), strict=True))


def _face_below(vertices: np.ndarray, corners: np.ndarray, center: np.ndarray) -> list[int]:
    """The corners (k,3) of the face that is nearest to the center, of those with an area."""
    (ax, bx, cx), (ay, by, cy) = (column[corners.T] for column in map(np.ascontiguousarray, vertices.T))
    distance = np.hypot((ax + bx + cx) / 3 - center[0], (ay + by + cy) / 3 - center[1])
    distance[(bx - ax) * (cy - ay) == (by - ay) * (cx - ax)] = np.inf
    return corners[np.argmin(distance)].tolist()


def _fasten(view_layer: bpy.types.ViewLayer, flat: bpy.types.Object, targets: list[bpy.types.Object]) -> None:
    """To three vertices each, its origin in the middle of them: so a text moves with its piece, and the dashed line
    that Blender draws to it has no length. Texts that the view layer does not show stay with the whole object.
    """
    poses = [target.matrix_basis.copy() for target in targets]
    for target in targets:
        target.parent_type, target.matrix_basis = "VERTEX_3", Matrix()
    view_layer.update()  # once: Blender makes the whole flat mesh anew as soon as something hangs on its vertices
    present = view_layer.objects.values()
    for target, pose in zip(targets, poses, strict=True):
        if target in present:
            target.matrix_parent_inverse = target.matrix_world.inverted_safe() @ flat.matrix_world
        else:
            target.parent_type = "OBJECT"
        target.matrix_basis = pose


def write_all_areas() -> None:
    for scene in bpy.data.scenes:
        write_areas(scene)


@persistent
def _on_undo(*_: object) -> None:
    """The step of a change of units does not hold what was written after it."""
    write_all_areas()


@persistent
def _subscribe(*_: object) -> None:
    """Another file ends all subscriptions."""
    bpy.msgbus.clear_by_owner(_owner)
    for name in ("system", "scale_length", "length_unit"):
        key = (bpy.types.UnitSettings, name)
        bpy.msgbus.subscribe_rna(key=key, owner=_owner, args=(), notify=write_all_areas)


def attach() -> None:
    _subscribe()
    bpy.app.handlers.load_post.append(_subscribe)
    bpy.app.handlers.undo_post.append(_on_undo)
    bpy.app.handlers.redo_post.append(_on_undo)


def detach() -> None:
    bpy.app.handlers.redo_post.remove(_on_undo)
    bpy.app.handlers.undo_post.remove(_on_undo)
    bpy.app.handlers.load_post.remove(_subscribe)
    bpy.msgbus.clear_by_owner(_owner)
