# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimizes the symmetric Dirichlet energy of a flat shape by L-BFGS. OptCuts minimizes this energy, too.

Only inner vertices move, so that the lengths of the outlines stay exact.
"""

from collections import deque

import numpy as np

STEPS = 20  # number of steps that L-BFGS remembers; also number of steps over which the decrease is measured
ENOUGH = 1e-6  # the search ends if the energy decreases by less than this over STEPS steps
SUFFICIENT = 1e-4  # share of the predicted decrease that a step must reach (Armijo)
SHORTEST = 1e-12  # the search ends if not even this share of a step decreases the energy enough

Slope = tuple[float, np.ndarray]  # energy and its gradient


def least_energy(vertices: np.ndarray, faces: np.ndarray, corner_uv: np.ndarray) -> np.ndarray:
    """Return the corners (m, 3, 2) of the shape that the search finds if it starts at corner_uv (m, 3, 2)."""
    named = np.concatenate([faces.reshape(-1, 1), corner_uv.reshape(-1, 2)], axis=1)
    places, index = np.unique(named, axis=0, return_inverse=True)
    index = index.reshape(-1, 3)
    triangles = Triangles(vertices[faces], index, on_outline(index))
    return minimize(triangles, places[:, 1:])[index]


def on_outline(index: np.ndarray) -> np.ndarray:
    edges = np.sort(np.concatenate([index[:, [i, i - 1]] for i in range(3)]), axis=1)
    names, counts = np.unique(edges, axis=0, return_counts=True)
    return np.unique(names[counts == 1])


class Triangles:
    def __init__(self, points: np.ndarray, index: np.ndarray, fixed: np.ndarray) -> None:
        first, second = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
        length = np.linalg.norm(first, axis=1)
        height = np.linalg.norm(np.cross(first, second), axis=1) / length
        self.index, self.fixed = index, fixed
        self.shares = length * height / (length * height).sum()
        # These are the inverses of a matrix for each triangle. The columns of the matrix are two edges of the triangle,
        # in the plane of the triangle.
        self.inverse = np.zeros((len(points), 2, 2))
        self.inverse[:, 0, 0] = 1 / length
        self.inverse[:, 0, 1] = -(first * second).sum(axis=1) / (length**2 * height)
        self.inverse[:, 1, 1] = 1 / height

    def energy(self, uv: np.ndarray) -> Slope:
        """Return the energy and its gradient (n, 2). If a triangle is flipped, the energy is infinite."""
        corners = uv[self.index]
        jacobian = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2) @ self.inverse
        area = np.linalg.det(jacobian)
        if (area <= 0).any():
            return np.inf, np.zeros_like(uv)
        square = (jacobian**2).sum(axis=(1, 2))
        change_of_area = np.empty_like(jacobian)
        change_of_area[:, 0, 0], change_of_area[:, 0, 1] = jacobian[:, 1, 1], -jacobian[:, 1, 0]
        change_of_area[:, 1, 0], change_of_area[:, 1, 1] = -jacobian[:, 0, 1], jacobian[:, 0, 0]
        weights = (2 * self.shares * (1 + area**-2), 2 * self.shares * square * area**-3)
        change = weights[0][:, None, None] * jacobian - weights[1][:, None, None] * change_of_area
        by_edges = change @ np.swapaxes(self.inverse, 1, 2)
        gradient = np.zeros_like(uv)
        np.add.at(gradient, self.index[:, 1], by_edges[:, :, 0])
        np.add.at(gradient, self.index[:, 2], by_edges[:, :, 1])
        np.add.at(gradient, self.index[:, 0], -by_edges.sum(axis=2))
        gradient[self.fixed] = 0
        return float((self.shares * square * (1 + area**-2)).sum()), gradient


def minimize(triangles: Triangles, uv: np.ndarray) -> np.ndarray:
    energy, gradient = triangles.energy(uv)
    past = deque([energy], maxlen=STEPS)
    # The last steps are kept, each with the change of the gradient that it caused.
    moves: deque[tuple[np.ndarray, np.ndarray]] = deque(maxlen=STEPS)
    while True:
        step = direction(gradient, moves)
        share, slope = 1.0, float((gradient * step).sum())
        while (after := triangles.energy(uv + share * step))[0] > energy + SUFFICIENT * share * slope:
            share /= 2
            if share < SHORTEST:
                return uv
        if float((step * (after[1] - gradient)).sum()) > 0:
            moves.append((share * step, after[1] - gradient))
        uv, (energy, gradient) = uv + share * step, after
        if len(past) == STEPS and past[0] - energy < ENOUGH:
            return uv
        past.append(energy)


def direction(gradient: np.ndarray, moves: deque[tuple[np.ndarray, np.ndarray]]) -> np.ndarray:
    """Return the step of L-BFGS (Nocedal and Wright 2006, Algorithm 7.4)."""
    step, shares = -gradient, []
    for move, change in reversed(moves):
        shares.append((move * step).sum() / (move * change).sum())
        step = step - shares[-1] * change
    if moves:
        move, change = moves[-1]
        step = step * (move * change).sum() / (change**2).sum()
    for (move, change), share in zip(moves, reversed(shares), strict=True):
        step = step + move * (share - (change * step).sum() / (move * change).sum())
    return step
