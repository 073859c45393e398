# SPDX-License-Identifier: GPL-3.0-or-later
"""Wires as runs of drawn edges, to be named and cut into dashes. No Blender in here."""

from dataclasses import dataclass

import numpy as np

from ..wire_chains import chains_of_marks


@dataclass(frozen=True)
class WireRun:
    """One wire, wherever it is drawn: an edge on a seam of flat pieces has a row on either side."""

    wire_id: int
    tolerance: float
    rows: np.ndarray  # (k,) of the marked edges
    ends: np.ndarray  # (k,2,3) of these rows, turned to go along the wire
    offsets: np.ndarray  # (k,) length of wire before each row


def wire_runs(vertices: np.ndarray, ends: np.ndarray, wire_ids: np.ndarray, tolerances: np.ndarray) -> list[WireRun]:
    """vertices (k,2) and ends (k,2,3) of marked edges, those with id 0 left out."""
    marked = np.flatnonzero(wire_ids)
    if not len(marked):
        return []
    pairs = np.sort(vertices[marked], axis=1)
    edges, first, edge_of_row = np.unique(pairs, axis=0, return_index=True, return_inverse=True)
    in_order = np.argsort(first)  # of the mesh, as the list of wires has them
    edges, first, edge_of_row = edges[in_order], marked[first[in_order]], np.argsort(in_order)[edge_of_row.ravel()]
    turned = np.where((vertices[:, 0] > vertices[:, 1])[:, None, None], ends[:, ::-1], ends)
    numbers, edges = np.unique(edges, return_inverse=True)
    edges, positions = edges.reshape(-1, 2), np.empty((len(numbers), 3))
    positions[edges] = turned[first]
    order = np.argsort(edge_of_row, kind="stable")
    starts = np.searchsorted(edge_of_row[order], np.arange(len(edges) + 1))
    lengths = np.linalg.norm(turned[:, 1] - turned[:, 0], axis=1)
    runs = []
    for chain in chains_of_marks(edges, wire_ids[first], tolerances[first], positions):
        along = np.cumsum(lengths[first[chain.edges]])
        sizes = [starts[edge + 1] - starts[edge] for edge in chain.edges]
        rows = np.concatenate([marked[order[starts[edge] : starts[edge + 1]]] for edge in chain.edges])
        backward = np.repeat(edges[chain.edges, 0] != chain.vertices[:-1], sizes)
        run_ends = np.where(backward[:, None, None], turned[rows][:, ::-1], turned[rows])
        offsets = np.repeat(along - lengths[first[chain.edges]], sizes)
        runs.append(WireRun(chain.wire_id, chain.tolerance, rows, run_ends, offsets))
    return runs


def cut_into_dashes(ends: np.ndarray, offsets: np.ndarray, dash: float, gap: float) -> np.ndarray:
    """The ends (2m,3) of the dashes on lines (k,2,3) that begin at these offsets (k,) from the first dash."""
    period = dash + gap
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    first = np.floor(offsets / period).astype(np.int64)
    counts = np.floor((offsets + lengths) / period).astype(np.int64) - first + 1
    line = np.repeat(np.arange(len(ends)), counts)
    number = first[line] + np.arange(len(line)) - np.repeat(np.cumsum(counts) - counts, counts)
    begin = np.maximum(number * period - offsets[line], 0)
    end = np.minimum(number * period + dash - offsets[line], lengths[line])
    seen = end > begin
    shares = np.column_stack([begin, end])[seen] / lengths[line[seen], None]
    start, way = ends[line[seen], 0], ends[line[seen], 1] - ends[line[seen], 0]
    return (start[:, None] + shares[:, :, None] * way[:, None]).reshape(-1, 3).astype(np.float32)
