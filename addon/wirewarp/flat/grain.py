# SPDX-License-Identifier: GPL-3.0-or-later
"""The grain of each flat piece: the direction that stood upright when the pieces were laid out.

It turns with the piece when the user turns that: it is kept by its angle from the line between two of its vertices.
"""

import bpy
import numpy as np

from ..blender.mesh import read_numbers
from ..names import GRAIN
from ..solve.flat_mesh import FlatMesh

COLUMNS = 5  # piece, two vertices, cosine and sine of the angle from their line to the grain, counterclockwise
UP = np.array([0.0, 1.0])


def remember_grain(mesh: bpy.types.Mesh, flat: FlatMesh) -> None:
    """On the flat mesh. flat: the pieces as laid out, upright, wherever they were put since."""
    rows = []
    sums, begins = flat.vertices.sum(axis=1), np.flatnonzero(np.diff(flat.vertex_piece, prepend=-1))
    for begin, end in zip(begins.tolist(), [*begins[1:].tolist(), len(sums)], strict=True):
        piece, own = int(flat.vertex_piece[begin]), sums[begin:end]
        first, last = (begin + int(pick(own)) for pick in (np.argmin, np.argmax))
        along = _unit(flat.vertices[last] - flat.vertices[first])
        rows += [piece, first, last, along @ UP, along[0] * UP[1] - along[1] * UP[0]]
    mesh[GRAIN] = [float(number) for number in rows]


def grain_directions(mesh: bpy.types.Mesh, vertices: np.ndarray) -> dict[int, np.ndarray]:
    """By piece, unit vectors (2,) of the pieces as they lie now. vertices (n,2) of the flat mesh.

    Pieces whose vertices or whose note are gone have none.
    """
    numbers = read_numbers(mesh, GRAIN)
    if numbers is None or len(numbers) % COLUMNS:
        return {}
    found = {}
    for piece, first, last, cosine, sine in numbers.reshape(-1, COLUMNS).tolist():
        if 0 <= first < len(vertices) and 0 <= last < len(vertices):
            x, y = _unit(vertices[int(last)] - vertices[int(first)])
            found[int(piece)] = np.array([cosine * x - sine * y, sine * x + cosine * y])
    return found


def has_grain_wire(report: dict, piece: int) -> bool:
    """Whether the user has chosen the grain of this piece: the grain wire runs through it."""
    options = report.get("options", {})
    ids = {wire["wire"]: wire["wire_id"] for wire in report["wires"]}
    own = {ids[part["wire"]] for part in report["pieces"][piece]["wires"]}
    return options.get("orientation") == "wire" and options.get("grain_wire") in own


def _unit(vector: np.ndarray) -> np.ndarray:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0 else UP
