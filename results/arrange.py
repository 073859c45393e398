# SPDX-License-Identifier: GPL-3.0-or-later
"""Places the pieces of several flattenings of one surface in the same way, so that their pictures can be compared."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import wirewarp

LEVEL = 0.3  # a piece with a smaller mean slope counts as level
GAP = 0.04  # gap between pieces, as a fraction of the square root of the area of all cells


@dataclass(frozen=True)
class Arrangement:
    """The places of the pieces. A piece has the same cell in all flattenings, large enough for each of its shapes."""

    # by flattening and piece: positions (p, 2), with the middle of the piece's box at 0
    turned: list[list[np.ndarray]]
    centers: np.ndarray  # (pieces, 2) centers of the cells
    size: np.ndarray  # (2,) width and height of the box around all cells; its lower left corner is at 0

    def positions(self, flattening: int) -> list[np.ndarray]:
        """Return the positions (p, 2) of each piece of a flattening, in its cell."""
        return [uv + center for uv, center in zip(self.turned[flattening], self.centers, strict=True)]


def turn_like(uv: np.ndarray, model: np.ndarray) -> np.ndarray:
    """Return uv (p, 2), rotated to match `model` (p, 2) by least squares, with the middle of its box at 0."""
    z, w = (p[:, 0] + 1j * p[:, 1] - (p[:, 0] + 1j * p[:, 1]).mean() for p in (uv, model))
    direction = (np.conj(z) * w).sum()
    z = z * direction / abs(direction)
    turned = np.stack([z.real, z.imag], axis=-1)
    return turned - (turned.min(axis=0) + turned.max(axis=0)) / 2


def turn_upright(uv: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return uv, rotated so that up on the surface is up in the plane. For a level piece, the back is at the top.

    points (p, 3): the vertices on the surface.
    """
    system = np.column_stack([uv, np.ones(len(uv))])
    rise, back = (np.linalg.lstsq(system, points[:, axis], rcond=None)[0][:2] for axis in (2, 1))
    u, v = rise if np.linalg.norm(rise) > LEVEL else back
    return uv @ np.array([[v, u], [-u, v]]) / np.linalg.norm([u, v])


def arrange(vertices: np.ndarray, results: list[wirewarp.FlattenResult], aspect: float) -> Arrangement:
    """Return the arrangement of the pieces of all results on shelves.

    vertices: (n, 3), of the surface
    aspect: preferred width over height
    """
    # Pieces of the last result are upright, and the pieces of the other results are rotated like them.
    models = [turn_upright(piece.vertices, vertices[piece.source_vertex]) for piece in results[-1].pieces]
    turned = [[turn_like(p.vertices, m) for p, m in zip(r.pieces, models, strict=True)] for r in results]
    sizes = np.array([np.max([np.ptp(uvs[k], axis=0) for uvs in turned], axis=0) for k in range(len(models))])
    sizes += GAP * np.sqrt(sizes.prod(axis=1).sum()) if len(sizes) > 1 else 0
    widths = np.linspace(sizes[:, 0].max(), sizes[:, 0].sum(), 60)
    options = [_on_shelves(sizes, width) for width in widths]
    centers, size = max(options, key=lambda option: min(aspect / option[1][0], 1 / option[1][1]))
    return Arrangement(turned, centers, size)


def _on_shelves(sizes: np.ndarray, width: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the centers of boxes on shelves of this width, the tallest boxes first, and the size of all shelves."""
    order = sorted(range(len(sizes)), key=lambda k: (-round(sizes[k, 1], 3), k))
    corners = np.zeros_like(sizes)
    x = top = bottom = 0.0
    for k in order:
        if x + sizes[k, 0] > width * (1 + 1e-9):
            x, top = 0.0, bottom
        corners[k] = x, top - sizes[k, 1]
        x += sizes[k, 0]
        bottom = min(bottom, top - sizes[k, 1])
    corners -= corners.min(axis=0)
    return corners + sizes / 2, (corners + sizes).max(axis=0)
