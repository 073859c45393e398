# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads models from files with trimesh."""

import codecs
import io
import logging
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .request import READ_BY_TRIMESH, SUFFIXES, InputError

# Text to remove from text formats: lines about materials, with which trimesh would sort the faces and renumber the
# vertices, and the rest of a line from the first letter that is not ASCII. In Shift-JIS, such a letter may end in a
# backslash, which would join two lines.
UNUSED = re.compile(rb"^[ \t]*(?:mtllib|usemtl)\b[^\r\n]*|[\x80-\xff][^\r\n]*", re.MULTILINE)
STL_HEADER, STL_FACE = 84, 50  # bytes of a binary STL file: before the faces, and for each face
STL_END = 1000  # bytes at the end of a text STL file, enough for "endsolid" and a long name


@dataclass(frozen=True)
class Model:
    vertices: np.ndarray  # (n,3) in the order of the file; vertices at the same place are merged
    faces: np.ndarray  # (m,3)
    corner_uv: np.ndarray | None  # (m,3,2) UV coordinates of the corners of the faces


def read_model(path: Path) -> Model:
    """Return the model of a file. Raises InputError."""
    if path.suffix.lower() not in READ_BY_TRIMESH:
        raise InputError(f'"{path.name}" cannot be read: names of models end in {", ".join(SUFFIXES)}.')
    if not path.is_file():
        raise InputError(f'There is no file "{path}".')
    try:
        import trimesh
    except ModuleNotFoundError as error:
        raise InputError("Models are read by trimesh, which is missing: pip install wirewarp[command]") from error
    logging.getLogger("trimesh").setLevel(logging.CRITICAL)  # errors are reported by InputError instead
    kind = path.suffix.lower()[1:]
    is_gltf = kind in ("gltf", "glb")  # trimesh needs the path, because it also reads the files beside a glTF file
    try:
        mesh = trimesh.load_mesh(path if is_gltf else _contents(path, kind), file_type=kind, process=False)
    except (InputError, MemoryError, OSError):
        raise
    except Exception as error:  # trimesh raises many kinds of errors for damaged files, with sentences for programmers
        raise InputError(f'"{path.name}" is damaged or is not {kind.upper()}. Export the model again.') from error
    if len(mesh.faces) == 0:
        raise InputError(f'"{path.name}" has no faces.')
    positions, corners = np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces, dtype=np.int64)
    if corners.min() < 0 or corners.max() >= len(positions):
        raise InputError(f'"{path.name}" has faces with vertices that are not in the file. Export the model again.')
    if not np.isfinite(positions[corners]).all():
        raise InputError(f'"{path.name}" has NaN or infinite coordinates. Export the model again.')
    vertices, faces = _joined(positions, corners)
    uv = getattr(mesh.visual, "uv", None)
    return Model(vertices, faces, None if uv is None else np.asarray(uv, dtype=np.float64)[corners])


def _contents(path: Path, kind: str) -> io.BytesIO:
    """Return the part of an OBJ, PLY or STL file that trimesh needs. Raises InputError if an STL file is cut off."""
    data = path.read_bytes().removeprefix(codecs.BOM_UTF8)
    if kind == "stl":
        size = STL_HEADER + STL_FACE * int.from_bytes(data[STL_HEADER - 4 : STL_HEADER], "little")
        is_text = data[:STL_HEADER].lstrip().lower().startswith(b"solid") and len(data) != size
        if b"endsolid" not in data[-STL_END:].lower() if is_text else len(data) < size:
            raise InputError(f'"{path.name}" is cut off. Export the model again.')
        if not is_text:
            return io.BytesIO(data)
    header, end, body = data.partition(b"end_header") if kind == "ply" else (data, b"", b"")
    return io.BytesIO(UNUSED.sub(b"", header) + end + body)


def _joined(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices, merged if they are at the same place, and the faces.

    Files repeat a vertex for each UV coordinate or normal, and STL files repeat it for each face.
    """
    _, first, inverse = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return vertices[first[order]], rank[inverse.ravel()][faces]
