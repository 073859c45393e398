# SPDX-License-Identifier: GPL-3.0-or-later
"""Chooses places of flat pieces: first beside their model, later where the user has moved them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import bpy
import numpy as np
from mathutils import Vector

from ..blender.attributes import has_attributes
from ..blender.objects import linear_part, world_box
from ..core import listed
from ..issues import ObjectError
from ..names import PIECE, SOURCE_VERTEX
from ..solve.flat_mesh import FlatMesh
from ..solve.identity import PieceIdentity
from ..solve.outlines import FlatPieces, piece_of_vertices
from ..solve.places import NONE_AWAY, find_places, points_of
from ..solve.report import ObjectReport
from ..state.flat_pieces import read_flat_pieces
from ..state.owners import model_of
from ..state.record import layout_of, read_record

GAP = 0.1  # distance of the pieces from models and obstacles, as a share of the model's largest dimension
LARGE = 5.0  # largest size of an obstacle, as a multiple of the model's size; rooms and landscapes are larger
SOLID = {"MESH", "CURVE", "SURFACE", "META"}
Box = np.ndarray  # (2,3) lowest and highest corner of a box in the world
TURNED = 0.999  # cosine of 2.5 degrees, the largest angle by which a model may be rotated without TURNED_TEXT
TURNED_TEXT = (
    "The model was rotated after its pieces were laid out, and Keep Places left the pieces as they were. To make them "
    "upright again, select the model and press Lay Out Again in the Pieces panel."
)


def free_place(
    scene: bpy.types.Scene, source: bpy.types.Object, size: np.ndarray, models: Sequence[bpy.types.Object]
) -> Vector:
    """Return the place (3,) of the lower left corner of a layout of this size (2,), in Blender units.

    - The layout is to the right of the source and of all flat pieces.
    - Its height is that of the lowest point of `models`, the models of this run. It is not above or below any of them.
    - It touches no other visible object, except objects that are more than LARGE times as large as the source.
    """
    own, largest = world_box(source), max(source.dimensions)
    together = [world_box(each) for each in models]
    others = [each for each in scene.objects if each.type in SOLID and each.visible_get() and each not in models]
    ours = [each for each in scene.objects if model_of(each)]
    right, floor = max(world_box(each)[1, 0] for each in (source, *ours)), min(box[0, 2] for box in together)
    obstacles = [box for box in map(world_box, others) if np.ptp(box, axis=0).max() <= LARGE * largest]
    corner = np.array([right + GAP * largest, own[0, 1], floor])
    obstacles = [box for box in obstacles if _rises(box, floor, GAP * largest)] + together
    return Vector(_clear_of(obstacles, corner, size, GAP * largest))


def _rises(box: Box, floor: float, gap: float) -> bool:
    return bool(box[0, 2] <= floor + gap and box[1, 2] > floor)


def _clear_of(obstacles: Sequence[Box], place: np.ndarray, size: np.ndarray, gap: float) -> np.ndarray:
    """Return the place (3,), moved to the right until no obstacle is above or below a layout of this size there."""
    for low, high in sorted(obstacles, key=lambda box: box[0, 0]):
        if np.all((low[:2] < place[:2] + size) & (high[:2] > place[:2])):
            place = np.array([high[0] + gap, *place[1:]])
    return place


@dataclass(frozen=True)
class Earlier:
    """Pieces of an earlier run, which the user may have moved."""

    flat: bpy.types.Object
    pieces: FlatPieces
    away: np.ndarray  # (k,4) places of pieces that had no flat shape, see NONE_AWAY
    up: np.ndarray  # (3,) upward direction when the pieces were laid out, in the model's own space


def earlier_layout(flat: bpy.types.Object | None, options: dict) -> Earlier | None:
    """Return the pieces in the flat object. Return None if all pieces must be laid out again, because these options
    differ from those of the earlier layout, or because there are no earlier pieces that can be read."""
    record = read_record(flat.data) if flat else None
    if record is None or record.layout != layout_of(options):
        return None
    if not len(flat.data.polygons) or not has_attributes(flat.data, SOURCE_VERTEX, PIECE):
        return None
    try:
        pieces = read_flat_pieces(flat.data)
    except ObjectError:  # an attribute of another add-on has one of our names
        return None
    if not np.isfinite(pieces.vertices).all():
        return None
    return Earlier(flat, pieces, np.array(record.away) if record.away else NONE_AWAY, np.array(record.up))


def pieces_in_place(flat: FlatMesh, earlier: Earlier | None, spacing: float) -> tuple[FlatMesh, list[int]]:
    """Return the pieces, each in its earlier place if it has one. Also return the ids of pieces that had to move,
    because they would overlap other pieces. spacing: see find_places."""
    if earlier is None:
        return flat, []
    places = find_places(flat, earlier.pieces, earlier.away, spacing)
    vertices = flat.vertices.copy()
    piece = piece_of_vertices(len(vertices), flat.loop_vertices, flat.face_sizes, flat.piece_id)
    for piece_id, motion in places.motions.items():
        own = piece == piece_id
        vertices[own] = motion(vertices[own])
    return replace(flat, vertices=vertices), places.crowded


def places_of_absent(flat: FlatMesh, earlier: Earlier | None, identities: Sequence[PieceIdentity]) -> np.ndarray:
    """Return the earlier places (k,4) of pieces that have no flat shape now, see NONE_AWAY."""
    present = set(np.unique(flat.piece_id).tolist())
    absent = [identity.piece_id for identity in identities if identity.piece_id not in present]
    return points_of(earlier.pieces, earlier.away, absent) if earlier and absent else NONE_AWAY


def present_up(source: bpy.types.Object) -> np.ndarray:
    """Return the unit vector (3,) in the model's own space that is up in the world."""
    up = linear_part(source)[2]
    return up / np.linalg.norm(up)


def is_turned(up: np.ndarray, then: np.ndarray, report: ObjectReport) -> bool:
    """Return whether a new layout would rotate pieces because the model was rotated. up, then: upward directions (3,)
    in the model's own space, now and when the pieces were laid out."""
    if float(up @ then) > TURNED or report.options["orientation"] not in ("up", "grain"):
        return False
    return not all(report.follows_grain_wire(piece) for piece in range(len(report.pieces)))


def crowded_text(names: list[str]) -> str:
    if len(names) == 1:
        return f"{names[0]} no longer fits in its place and was moved aside."
    return f"{listed(names)} no longer fit in their places and were moved aside."
