# SPDX-License-Identifier: GPL-3.0-or-later
"""From the flat object of an earlier run to the places of the new pieces."""

import json
from collections.abc import Sequence
from dataclasses import replace

import bpy
import numpy as np

from ..flat_attributes import has_flat_attributes, read_flat_attribute
from ..flat_mesh import FlatMesh
from ..foreach import read
from ..mesh_topology import corner_vertices, face_sizes
from ..pattern.flat_pieces import piece_of_vertices
from .attribute import PIECE
from .identity import PieceIdentity
from .motion import STAY, Motion
from .places import LaidOut, find_places, laid_out

# Of the report: with other ones the user wants another layout.
LAYOUT_OPTIONS = ("layout", "orientation", "grain_wire", "gap", "mirror")
LAYOUT = "wirewarp_layout"  # of the flat mesh: with which ones it was laid out


def pieces_in_place(
    flat: FlatMesh, earlier: bpy.types.Object | None, gap: float
) -> tuple[FlatMesh, dict[int, Motion], list[int]]:
    """The pieces where they lie in the flat object `earlier`, if there is one.

    Also how each was moved for it, by its id, and the ids of those that lie elsewhere now because they have grown into
    others. gap: see find_places.
    """
    known = _read(earlier.data) if earlier else None
    if known is None:
        return flat, {}, []
    places = find_places(laid_out(flat), known, gap)
    vertices = flat.vertices.copy()
    piece = piece_of_vertices(len(vertices), flat.loop_vertices, flat.polygon_sizes, flat.piece_id)
    for piece_id, motion in places.motions.items():
        own = piece == piece_id
        vertices[own] = motion(vertices[own])
    return replace(flat, vertices=vertices), places.motions, places.crowded


def motions_in_order(motions: dict[int, Motion], identities: Sequence[PieceIdentity]) -> list[Motion]:
    """One per piece of the result."""
    return [motions.get(identity.piece_id, STAY) for identity in identities]


def wants_new_layout(options: dict, earlier: bpy.types.Object) -> bool:
    """Whether a run with these options lays out otherwise than the one that made the flat object `earlier`."""
    return earlier.data.get(LAYOUT) != _layout_text(options)


def remember_layout(flat: bpy.types.Object, options: dict) -> None:
    flat.data[LAYOUT] = _layout_text(options)


def _layout_text(options: dict) -> str:
    return json.dumps({name: options[name] for name in LAYOUT_OPTIONS})


def crowded_text(names: list[str]) -> str:
    subject = f"{names[0]} has" if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]} have"
    return f"{subject} grown into other pieces and now {'lies' if len(names) == 1 else 'lie'} beside them."


def _read(mesh: bpy.types.Mesh) -> LaidOut | None:
    """None where the user has left nothing to go by."""
    places = read(mesh.vertices, "co", np.float32, 3)[:, :2].astype(np.float64)
    if not len(mesh.polygons) or not has_flat_attributes(mesh, "source_vertex", PIECE):
        return None
    if not np.isfinite(places).all():
        return None
    return LaidOut(
        vertices=places,
        source_vertex=read_flat_attribute(mesh, "source_vertex"),
        loop_vertices=corner_vertices(mesh),
        face_sizes=face_sizes(mesh),
        piece_id=read_flat_attribute(mesh, PIECE),
    )
