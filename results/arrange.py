# SPDX-License-Identifier: GPL-3.0-or-later
"""Places the pieces of several flattenings of one surface in the same way, so that their pictures can be compared."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import wirewarp

LEVEL = 0.3  # mean slope below which a piece is level
GAP = 0.04  # between pieces, as a fraction of the square root of the area of all cells


@dataclass(frozen=True)
class Arrangement:
    """The place of each piece, in cells; the same piece of each flattening fits in a cell."""

    # Per flattening, the positions (p, 2) of each piece, with the middle of its box at 0.
    turned: list[list[np.ndarray]]
    centers: np.ndarray  # (pieces, 2)
    size: np.ndarray  # (2,) of the whole, from 0

    def positions(self, flattening: int) -> list[np.ndarray]:
        """Return the positions (p, 2) of each piece."""
        return [uv + center for uv, center in zip(self.turned[flattening], self.centers, strict=True)]


def turn_like(uv: np.ndarray, model: np.ndarray) -> np.ndarray:
    """Rotate uv to match model (least squares), with the middle of its box at 0."""
    z, w = (p[:, 0] + 1j * p[:, 1] - (p[:, 0] + 1j * p[:, 1]).mean() for p in (uv, model))
    direction = (np.conj(z) * w).sum()
    z = z * direction / abs(direction)
    turned = np.stack([z.real, z.imag], axis=-1)
    return turned - (turned.min(axis=0) + turned.max(axis=0)) / 2


def turn_upright(uv: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Rotate uv so that up on the surface, or back on a level piece, is up in the plane. points: (p, 3)."""
    system = np.column_stack([uv, np.ones(len(uv))])
    rise, back = (np.linalg.lstsq(system, points[:, axis], rcond=None)[0][:2] for axis in (2, 1))
    u, v = rise if np.linalg.norm(rise) > LEVEL else back
    return uv @ np.array([[v, u], [-u, v]]) / np.linalg.norm([u, v])


def arrange(vertices: np.ndarray, results: list[wirewarp.FlattenResult], aspect: float) -> Arrangement:
    """Place the pieces of the surface with these vertices (n, 3) on shelves.

    Pieces of the last result are upright, and the others are rotated like them. aspect: preferred width over height.
    """
    models = [turn_upright(piece.vertices, vertices[piece.source_vertex]) for piece in results[-1].pieces]
    turned = [[turn_like(p.vertices, m) for p, m in zip(r.pieces, models, strict=True)] for r in results]
    sizes = np.array([np.max([np.ptp(uvs[k], axis=0) for uvs in turned], axis=0) for k in range(len(models))])
    sizes += GAP * np.sqrt(sizes.prod(axis=1).sum()) if len(sizes) > 1 else 0
    widths = np.linspace(sizes[:, 0].max(), sizes[:, 0].sum(), 60)
    options = [_on_shelves(sizes, width) for width in widths]
    centers, size = max(options, key=lambda option: min(aspect / option[1][0], 1 / option[1][1]))
    return Arrangement(turned, centers, size)


def _on_shelves(sizes: np.ndarray, width: float) -> tuple[np.ndarray, np.ndarray]:
    """Return centers of boxes side by side on shelves of this width, the tallest first, and the size of the whole."""
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
