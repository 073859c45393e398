# SPDX-License-Identifier: GPL-3.0-or-later
"""Fuzzes the add-on's reader of wires with atheris (on libFuzzer). Any edge attributes must become chains of edges.

Usage: python tests/fuzz/fuzz_wire_reader.py LIBFUZZER_ARGUMENTS
"""

import collections
import struct
import sys
from pathlib import Path

import atheris
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "addon" / "wirewarp" / "solve"))
with atheris.instrument_imports():
    import chains  # this module does not use Blender


def any_marks(raw: bytes) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the edges of a mesh with their wire ids and tolerances, and the positions of the mesh's vertices.

    As in Blender, there is at most one edge between two vertices.
    """
    bytes_ = atheris.FuzzedDataProvider(raw)
    count = bytes_.ConsumeIntInRange(2, 30)
    pairs: dict[tuple[int, int], tuple[int, float]] = {}
    for _ in range(bytes_.ConsumeIntInRange(0, 60)):
        a, b = bytes_.ConsumeIntInRange(0, count - 1), bytes_.ConsumeIntInRange(0, count - 1)
        if a == b or (b, a) in pairs:
            continue
        low, high = (-(2**31), 2**31 - 1) if bytes_.ConsumeBool() else (0, 3)
        wire_id = bytes_.ConsumeIntInRange(low, high)
        (tolerance,) = struct.unpack("f", bytes_.ConsumeBytes(4).ljust(4, b"\0"))
        pairs[a, b] = wire_id, tolerance
    edges = np.array(list(pairs), dtype=np.int32).reshape(-1, 2)
    ids = np.array([wire_id for wire_id, _ in pairs.values()], dtype=np.int32)
    tolerances = np.array([tolerance for _, tolerance in pairs.values()], dtype=np.float32)
    positions = np.array([bytes_.ConsumeInt(2) / 256 for _ in range(3 * count)]).reshape(-1, 3)
    return edges, ids, tolerances, positions


def check(raw: bytes) -> None:
    """Check that every marked edge is in exactly one chain, and that this chain has the edge's id and tolerance."""
    edges, ids, tolerances, positions = any_marks(raw)
    marks = {
        (min(edge), max(edge)): (wire_id, np.float32(tolerance))
        for edge, wire_id, tolerance in zip(edges.tolist(), ids.tolist(), tolerances, strict=True)
        if wire_id
    }
    seen: collections.Counter[tuple[int, int]] = collections.Counter()
    for chain in chains.chains_of_marks(edges, chains.EdgeMarks(ids, tolerances, np.zeros_like(tolerances)), positions):
        for pair in zip(chain.vertices[:-1], chain.vertices[1:], strict=True):
            edge = min(pair), max(pair)
            wire_id, tolerance = marks[edge]
            assert chain.wire_id == wire_id
            assert np.array_equal(np.float32(chain.tolerance), tolerance, equal_nan=True)
            seen[edge] += 1
    assert seen == collections.Counter(marks.keys())


if __name__ == "__main__":
    atheris.Setup(sys.argv, check)
    atheris.Fuzz()
