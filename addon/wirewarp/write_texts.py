# SPDX-License-Identifier: GPL-3.0-or-later
"""The name and the area of each flat piece as a text object that lies on it."""

import math

import bpy
import numpy as np

from .pattern.pattern import PieceText
from .pattern.texts import piece_texts
from .read_flat_pieces import read_flat_pieces
from .unit_text import length_text
from .write_flat_object import our_collection

PIECE_ID = "wirewarp_piece"  # custom property of a text, a child of the flat object
LARGEST = 0.03  # height of the letters, by the size of all pieces together
ABOVE = 0.002  # the pieces, by the same size: so that both are seen
MOST = 200  # pieces that get texts; Blender is slow with many objects


def write_texts(scene: bpy.types.Scene, flat: bpy.types.Object, report: dict) -> None:
    """Replaces the texts of the flat object by those of the report's pieces."""
    remove_texts(flat)
    pieces = [piece for piece in report["pieces"] if piece["has_layout"]]
    if len(pieces) > MOST:
        report["notes"].append(f"Texts are written on up to {MOST} pieces, these are {len(pieces)}.")
        return
    text = length_text(scene)
    arrays = read_flat_pieces(flat.data, 1.0)
    size = float(np.linalg.norm(np.ptp(arrays.vertices, axis=0)))
    lines = {piece["index"]: (piece["name"], text.area(piece["area_2d"])) for piece in pieces}
    placed = piece_texts(arrays, lines, LARGEST * size)
    for piece in pieces:
        target = _new_text(flat, piece["name"], placed[piece["index"]], ABOVE * size)
        target[PIECE_ID] = piece["piece_id"]
        our_collection(scene).objects.link(target)


def remove_texts(flat: bpy.types.Object) -> None:
    """Also those whose flat object the user has deleted."""
    for target in [*find_texts(flat), *find_texts(None)]:
        bpy.data.curves.remove(target.data)  # and with it the object


def find_texts(flat: bpy.types.Object | None) -> list[bpy.types.Object]:
    fonts = [target for target in bpy.data.objects if target.type == "FONT" and PIECE_ID in target]
    return [target for target in fonts if target.parent == flat]


def rename_text(flat: bpy.types.Object, piece_id: int, name: str) -> None:
    """The first line of a piece's text becomes its new name."""
    for target in find_texts(flat):
        if target.get(PIECE_ID) == piece_id:
            _, *rest = target.data.body.split("\n")
            target.data.body = "\n".join([name, *rest])


def _new_text(flat: bpy.types.Object, name: str, text: PieceText, above: float) -> bpy.types.Object:
    curve = bpy.data.curves.new(f"{flat.name} {name}", "FONT")
    curve.body = "\n".join(text.lines)
    curve.size = max(text.height, 1e-6)
    curve.align_x, curve.align_y = "CENTER", "CENTER"
    target = bpy.data.objects.new(f"{flat.name} {name}", curve)
    target.parent = flat
    target.location = (*text.center, above)
    target.rotation_euler.z = math.radians(text.angle)
    target.color = (0.05, 0.05, 0.05, 1.0)
    return target
