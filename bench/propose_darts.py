# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares proposed darts with every dart of a large selection, on the most distorted piece of each sample.

Usage: PYTHONPATH=blend_samples python bench/propose_darts.py [SAMPLE...]
"""

import heapq
import sys
import time

import numpy as np
import wirewarp
from shapes import Shape, all_shapes

OUTLINE_POINTS, INNER_POINTS = 14, 22
LONGEST = 2.0  # seconds for the flattening with a dart; a dart that needs more time does not count


def ways_from(start: int, vertices: np.ndarray, neighbors: dict[int, set[int]], inside: set[int]) -> dict[int, int]:
    """Return, for each vertex, the previous vertex on the shortest path from the start through inner vertices.

    The value of the start is -1.
    """
    distance, before = {start: 0.0}, {start: -1}
    queue = [(0.0, start)]
    while queue:
        reached, vertex = heapq.heappop(queue)
        if reached > distance[vertex] or (vertex not in inside and before[vertex] >= 0):
            continue
        for near in neighbors[vertex]:
            length = reached + float(np.linalg.norm(vertices[near] - vertices[vertex]))
            if length < distance.get(near, np.inf):
                distance[near], before[near] = length, vertex
                heapq.heappush(queue, (length, near))
    return before


def spread(vertices: np.ndarray, choice: list[int], count: int) -> list[int]:
    """Return `count` of the vertices in `choice`, each as far as possible from the vertices before it."""
    taken = [choice[0]]
    far = np.linalg.norm(vertices[choice] - vertices[taken[0]], axis=1)
    while len(taken) < min(count, len(choice)):
        taken.append(choice[int(far.argmax())])
        far = np.minimum(far, np.linalg.norm(vertices[choice] - vertices[taken[-1]], axis=1))
    return taken


def every_dart(shape: Shape, piece: wirewarp.Piece) -> list[np.ndarray]:
    """Return the edges (k, 2) of each dart: a shortest path from a point on the outline to a point inside.

    spread() chooses the points.
    """
    faces = piece.source_vertex[piece.faces]
    neighbors: dict[int, set[int]] = {int(v): set() for v in faces.ravel()}
    for face in faces:
        for a in face:
            neighbors[int(a)] |= {int(b) for b in face if b != a}
    outline = {int(v) for chain in piece.boundaries for v in chain.vertices}
    on_wires = {int(v) for wire in shape.wires for v in wire.vertices} - outline
    inside = set(neighbors) - outline - on_wires
    darts = []
    for start in spread(shape.vertices, sorted(outline), OUTLINE_POINTS):
        before = ways_from(start, shape.vertices, neighbors, inside)
        for end in spread(shape.vertices, sorted(inside), INNER_POINTS):
            way = [end]
            while before.get(way[-1], -1) >= 0:
                way.append(before[way[-1]])
            if way[-1] == start:
                darts.append(np.array(list(zip(way[:-1], way[1:], strict=True))))
    return darts


def measure(shape: Shape) -> str:
    wires = [wirewarp.Wire(wire.vertices, wire.tolerance, wire.name) for wire in shape.wires]
    request = {"vertices": shape.vertices, "faces": shape.triangles(), "wires": wires}
    uncut = wirewarp.flatten(seams=shape.seams, **request)
    totals = [piece.metrics.arap_energy * piece.metrics.area_3d if not piece.error else 0 for piece in uncut.pieces]
    worst = int(np.argmax(totals))
    before = uncut.pieces[worst].metrics.arap_energy
    begin, used = time.perf_counter(), time.process_time()
    proposals = wirewarp.propose_darts(seams=shape.seams, piece=worst, **request)
    seconds, used = time.perf_counter() - begin, time.process_time() - used
    cache, energies = wirewarp.Cache(), []
    seams = np.asarray(shape.seams).reshape(-1, 2)
    darts = every_dart(shape, uncut.pieces[worst])
    for dart in darts:
        end = time.perf_counter() + LONGEST

        def in_time(_stage: str, _fraction: float, end: float = end) -> bool:
            return time.perf_counter() < end

        cut = wirewarp.flatten(seams=np.concatenate([seams, dart]), cache=cache, progress=in_time, **request)
        if not cut.pieces[worst].error:
            energies.append(cut.pieces[worst].metrics.arap_energy)
    best = min(energies)
    # share of the best decrease of energy that the first proposal does not achieve
    regret = (proposals[0].energy - best) / (before - best)
    return (
        f"{shape.name:22} {len(uncut.pieces[worst].faces):6} triangles  E/A {before:.5f}  "
        f"best of {len(darts)} {best:.5f} (median {np.median(energies):.5f})  proposed {proposals[0].energy:.5f}  "
        f"regret {100 * regret:5.1f}%  {seconds:.2f} s, {used:.2f} s of processor time"
    )


def main() -> None:
    for shape in all_shapes():
        if sys.argv[1:] and shape.name not in sys.argv[1:]:
            continue
        try:
            print(measure(shape), flush=True)
        except wirewarp.FlattenError as error:
            print(f"{shape.name:22} {error}", flush=True)


if __name__ == "__main__":
    main()
