# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the seams, wires and eases of a model in its UV map, at its sharp edges, or in JSON files."""

import json
import math
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from .. import Ease, FlattenError, Wire
from .model import Model
from .request import InputError

SHARP = math.radians(30)  # radians; the default angle of Select Sharp Edges in Blender
KEYS = {"vertices": {"vertices", "tolerance", "name", "ease"}, "side": {"side", "ease"}}
LARGEST = np.iinfo(np.int64).max
SAME_UV = 1e-6  # UV coordinates count as equal up to this difference, because files have about six decimals


def seams_of(model: Model, wanted: str) -> np.ndarray:
    """Return the seams (k,2) as pairs of vertices. wanted: "uv", "sharp", a path, or "" for none. Raises InputError."""
    if not wanted:
        return np.empty((0, 2), dtype=np.int64)
    if wanted == "uv":
        if model.corner_uv is None:
            raise InputError("The model has no UV map, so there are no islands to cut along.")
        return _island_borders(model, model.corner_uv)
    if wanted == "sharp":
        return _sharp_edges(model)
    return edges_of(wanted)


def edges_of(path: str) -> np.ndarray:
    """Return the edges (k,2) of the lines in a file, or no edges for "". Raises InputError."""
    chains = _read(Path(path)) if path else []
    if not isinstance(chains, list) or not all(_is_chain(chain) for chain in chains):
        raise InputError(f'"{path}" must be a JSON list of lines of vertices, such as [[0, 1, 2], [5, 6]].')
    pairs = [pair for chain in chains for pair in pairwise(chain)]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


@dataclass(frozen=True)
class Lines:
    wires: list[Wire] = field(default_factory=list)
    eases: list[Ease] = field(default_factory=list)


def lines_of(path: str) -> Lines:
    """Return the wires in a file, and the eases along outlines or along one side of a seam. Raises InputError."""
    if not path:
        return Lines()
    entries = _read(Path(path))
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise InputError(f'"{path}" must be a JSON list of wires, such as [{{"vertices": [0, 1], "tolerance": 0.03}}].')
    lines = Lines()
    for number, entry in enumerate(entries, start=1):
        kind, add, noun = ("side", _add_ease, "Ease") if "side" in entry else ("vertices", _add_wire, "Wire")
        unknown = set(entry) - KEYS[kind]
        if unknown or not _is_chain(entry.get(kind)):
            what = f"has the unknown key {min(unknown)!r}" if unknown else f"has no list of {kind}"
            raise InputError(f'{noun} {number} of "{path}" {what}: give {", ".join(sorted(KEYS[kind]))}.')
        try:
            add(lines, entry)
        except (FlattenError, TypeError) as error:
            raise InputError(f'{noun} {number} of "{path}": {error}') from error
    return lines


def _add_wire(lines: Lines, entry: dict[str, Any]) -> None:
    tolerance = entry.get("tolerance", 0.0)
    number = math.inf if tolerance == "inf" else tolerance
    lines.wires.append(Wire(entry["vertices"], number, entry.get("name", ""), entry.get("ease", 0.0)))


def _add_ease(lines: Lines, entry: dict[str, Any]) -> None:
    """Add the ease. Each pair of successive vertices is an edge, in the direction of the triangle on the eased side."""
    lines.eases.append(Ease(list(pairwise(entry["side"])), entry.get("ease", 0.0)))


def _read(path: Path) -> Any:  # noqa: ANN401
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise InputError(f'"{path}" is not valid JSON: {error}') from error


def _is_chain(value: object) -> bool:
    return isinstance(value, list) and len(value) > 1 and all(_is_vertex(vertex) for vertex in value)


def _is_vertex(value: object) -> bool:
    """Return whether the value may be a vertex. The size is checked, because numbers in JSON have no limit."""
    return type(value) is int and abs(value) <= LARGEST


def _sides_at_edges(faces: np.ndarray) -> np.ndarray:
    """Return the corners (k,2,2) at the ends of each edge between two faces, as indices into faces.ravel().

    Axis 1: the face. Axis 2: the end of the edge, in the same order for both faces.
    """
    starts = np.arange(faces.size)
    ends = starts - starts % 3 + (starts + 1) % 3
    corners, vertices = np.column_stack([starts, ends]), faces.ravel()
    ascending = np.where((vertices[starts] < vertices[ends])[:, None], corners, corners[:, ::-1])
    keys = vertices[ascending] @ np.array([vertices.max() + 1, 1])
    order = np.argsort(keys, kind="stable")
    same = keys[order][1:] == keys[order][:-1]
    return np.stack([ascending[order[:-1][same]], ascending[order[1:][same]]], axis=1)


def _island_borders(model: Model, corner_uv: np.ndarray) -> np.ndarray:
    sides = _sides_at_edges(model.faces)
    places = corner_uv.reshape(-1, 2)[sides]
    apart = np.abs(places[:, 0] - places[:, 1]).max(axis=(1, 2)) > SAME_UV
    return np.unique(model.faces.ravel()[sides[apart, 0]], axis=0)


def _sharp_edges(model: Model) -> np.ndarray:
    sides = _sides_at_edges(model.faces)
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    first, second = (normals[sides[:, side, 0] // 3] for side in (0, 1))
    turns = np.arctan2(np.linalg.norm(np.cross(first, second), axis=1), (first * second).sum(axis=1))
    return np.unique(model.faces.ravel()[sides[turns > SHARP, 0]], axis=0)
