# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads mesh files without merging vertices, and without removing or flipping faces. Polygons are divided into
triangles at their first corner.
"""

from pathlib import Path

import numpy as np

Mesh = tuple[np.ndarray, np.ndarray]  # vertices (n, 3), triangles (m, 3)


def read_mesh(path: Path) -> Mesh:
    return READERS[path.suffix.lower()](path)


def read_obj(path: Path) -> Mesh:
    vertices, faces = [], []
    for line in path.read_text(errors="replace").splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append([float(word) for word in words[:3]])
        elif kind == "f":
            corners = [int(word.partition("/")[0]) for word in words]
            corners = [corner - 1 if corner > 0 else len(vertices) + corner for corner in corners]
            faces += [(corners[0], *pair) for pair in zip(corners[1:-1], corners[2:], strict=True)]
    return np.array(vertices).reshape(-1, 3), np.array(faces, dtype=int).reshape(-1, 3)


def read_ply(path: Path) -> Mesh:
    """Return the mesh of a binary file of triangles, whose vertices have positions and no other properties."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    lines = header.decode().splitlines()
    count = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element")}
    properties = [line for line in lines if line.startswith("property")]
    expected = [*(f"property float {axis}" for axis in "xyz"), "property list uchar int vertex_indices"]
    if "format binary_little_endian 1.0" not in lines or properties != expected:
        raise ValueError(f"{path.name} is a PLY file of a kind that the benchmark does not read")
    vertices = np.frombuffer(data, "<f4", 3 * count["vertex"]).reshape(-1, 3)
    faces = np.frombuffer(data, [("corners", "u1"), ("face", "<i4", 3)], count["face"], vertices.nbytes)
    if (faces["corners"] != 3).any():
        raise ValueError(f"{path.name} has faces that are not triangles")
    return vertices.astype(float), faces["face"].astype(int)


READERS = {".obj": read_obj, ".ply": read_ply}
