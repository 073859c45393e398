# SPDX-License-Identifier: GPL-3.0-or-later
"""Models from files, read by trimesh."""

import logging
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .input_error import InputError
from .suffixes import READ_BY_TRIMESH, SUFFIXES


@dataclass(frozen=True)
class Model:
    vertices: np.ndarray  # (n,3), as they come in the file; those at one place are one
    faces: np.ndarray  # (m,3)
    corner_uv: np.ndarray | None  # (m,3,2)


def read_model(path: Path) -> Model:
    """Raises InputError."""
    if path.suffix.lower() not in READ_BY_TRIMESH:
        raise InputError(f'"{path.name}" ends in none of {", ".join(SUFFIXES)}: no other kind of model can be read.')
    if not path.is_file():
        raise InputError(f'There is no file "{path}".')
    try:
        import trimesh
    except ModuleNotFoundError as error:
        raise InputError("Models are read by trimesh, which is missing: pip install wirewarp[command]") from error
    logging.getLogger("trimesh").setLevel(logging.CRITICAL)  # what is wrong is told in a sentence
    try:
        mesh = trimesh.load_mesh(path, process=False)
    except Exception as error:  # whatever it raises for files that are damaged, is not ours to know
        raise InputError(f'"{path.name}" cannot be read: {error}') from error
    if len(mesh.faces) == 0:
        raise InputError(f'"{path.name}" has no faces.')
    corners = np.asarray(mesh.vertices, dtype=np.float64)[mesh.faces]
    if not np.isfinite(corners).all():
        raise InputError(f'"{path.name}" has points that are nowhere (NaN or infinite).')
    vertices, faces = _joined(np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int64))
    uv = getattr(mesh.visual, "uv", None)
    return Model(vertices, faces, None if uv is None else np.asarray(uv, dtype=np.float64)[mesh.faces])


def _joined(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices at one place become one, the first: files repeat them for each UV or normal, STL for each face."""
    _, first, inverse = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return vertices[first[order]], rank[inverse.ravel()][faces]
