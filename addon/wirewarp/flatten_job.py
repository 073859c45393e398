# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of one object to the core library's result. No Blender in here."""

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np

from .element_names import name_elements
from .issues import Issue, ObjectError
from .mesh_to_arrays import MeshArrays

Progress = Callable[[str, float], bool]


@dataclass(frozen=True)
class FlattenChoices:
    """The operator's settings by the core library's names."""

    method: str
    node_weight: str
    gap: float
    mirror: bool


def flatten_arrays(library: ModuleType, arrays: MeshArrays, choices: FlattenChoices, progress: Progress) -> Any:  # noqa: ANN401
    """The library's FlattenResult. Raises ObjectError if the mesh as a whole is refused."""
    try:
        return library.flatten(
            arrays.vertices,
            arrays.triangles,
            seams=arrays.seams,
            wires=[
                library.Wire(wire.chain.vertices, tolerance=wire.chain.tolerance, name=wire.name)
                for wire in arrays.wires
            ],
            options=library.Options(
                method=choices.method, node_weight=choices.node_weight, gap=choices.gap, mirror=choices.mirror
            ),
            progress=progress,
        )
    except library.FlattenError as error:
        raise ObjectError(issue_of_error(error, arrays)) from error


def issue_of_error(error: Any, arrays: MeshArrays, piece: int | None = None) -> Issue:  # noqa: ANN401
    """The library's error, its triangles named as the polygons they are part of."""
    faces = np.unique(arrays.triangle_polygons[list(error.faces)]).tolist() if error.faces else []
    return Issue(
        code=str(error.code),
        sentence=name_elements(str(error), arrays.triangle_polygons, faces, [wire.name for wire in arrays.wires]),
        piece=piece,
        vertices=[int(vertex) for vertex in error.vertices],
        edges=[(int(a), int(b)) for a, b in error.edges],
        faces=faces,
    )


def has_layout(corner_uv: np.ndarray) -> np.ndarray:
    """(m,) bool: triangles with coordinates."""
    return np.isfinite(corner_uv.reshape(-1, 6) @ np.ones(6))  # a sum is finite where its terms are
