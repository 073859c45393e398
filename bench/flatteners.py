# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines the methods that docs/benchmarks.md compares. Each returns a flattening of a surface, and its cost."""

import os
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

os.environ["IGL_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = "1"  # set before the imports, which read them

import libigl_maps
import numpy as np
import wirewarp
from peak_memory import cost_of
from surfaces import Surface
from true_size import at_true_size

FOLDER = Path(__file__).resolve().parent
TOLERANCE = 0.03


@dataclass(frozen=True)
class Answer:
    flattening: wirewarp.FlattenResult
    seconds: float  # CPU seconds on one core
    megabytes: float  # peak memory, without the memory of the surface
    iterations: int | None = None  # number of iterations of libigl; None for other methods


Method = Callable[[Surface], Answer]


def flatten_by_wirewarp(method: str, wires: str, tolerance: float, surface: Surface) -> Answer:
    """Flatten by WireWarp. wires: name of the field of Surface with the wires."""
    options = wirewarp.Options(method=method)
    chains = [wirewarp.Wire(chain, tolerance) for chain in getattr(surface, wires)]
    return Answer(
        *cost_of(
            lambda: wirewarp.flatten(
                surface.vertices, surface.faces, seams=surface.seams, wires=chains, options=options
            )
        )
    )


def judge(surface: Surface, corner_uv: np.ndarray) -> wirewarp.FlattenResult:
    """Return the measures of a layout (m, 3, 2). Length errors are for the outline and many_wires."""
    wires = [wirewarp.Wire(chain) for chain in surface.many_wires]
    return wirewarp.measure(surface.vertices, surface.faces, corner_uv, seams=surface.seams, wires=wires)


def flatten_by_libigl(piece_map: Callable[..., libigl_maps.Map], most_iterations: int, surface: Surface) -> Answer:
    def flatten_pieces() -> tuple[np.ndarray, int]:
        corner_uv, iterations = np.empty((len(surface.faces), 3, 2)), 0
        for piece in surface.pieces:
            source, faces = np.unique(surface.faces[piece], return_inverse=True)
            faces = faces.reshape(-1, 3)
            uv, count = piece_map(surface.vertices[source], faces, most_iterations)
            corner_uv[piece] = uv[faces]
            iterations = max(iterations, count)
        return corner_uv, iterations

    (corner_uv, iterations), seconds, megabytes = cost_of(flatten_pieces)
    return Answer(judge(surface, corner_uv), seconds, megabytes, iterations)


def unwrap_in_blender(method: str, surface: Surface) -> Answer:
    """Unwrap in another process. Every piece is scaled to its area on the surface."""
    with tempfile.TemporaryDirectory() as folder:
        model, unwrap = Path(folder) / "model.npz", Path(folder) / "unwrap.npz"
        np.savez(model, vertices=surface.vertices, faces=surface.faces, seams=surface.seams)
        script = FOLDER / "unwrap_in_blender.py"
        command = [os.environ["WIREWARP_BPY_PYTHON"], script, model, method, unwrap]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        found = np.load(unwrap)
        corner_uv, seconds, megabytes = found["corner_uv"], float(found["seconds"]), float(found["megabytes"])
    scaled = at_true_size(corner_uv, judge(surface, corner_uv))
    return Answer(judge(surface, scaled), seconds, megabytes)


WARPING = "wirewarping, 2 rigid wires"
WARPED_ELASTIC = "wirewarp++, 8 wires ±3%"
REFINED = "refined, 2 rigid wires"
REFINED_ELASTIC = "refined, 8 wires ±3%"
ARAP, SLIM = "libigl ARAP", "libigl SLIM"
ARAP_CONVERGED, SLIM_CONVERGED = f"{ARAP}, converged", f"{SLIM}, converged"
ANGLE_BASED, CONFORMAL, MINIMUM_STRETCH = (
    f"Blender {name}" for name in ("angle-based", "conformal", "minimum stretch")
)

METHODS: dict[str, Method] = {
    WARPING: partial(flatten_by_wirewarp, "wirewarping", "few_wires", 0.0),
    WARPED_ELASTIC: partial(flatten_by_wirewarp, "wirewarp++", "many_wires", TOLERANCE),
    REFINED: partial(flatten_by_wirewarp, "refined", "few_wires", 0.0),
    "refined, 8 rigid wires": partial(flatten_by_wirewarp, "refined", "many_wires", 0.0),
    REFINED_ELASTIC: partial(flatten_by_wirewarp, "refined", "many_wires", TOLERANCE),
    ARAP: partial(flatten_by_libigl, libigl_maps.arap, libigl_maps.ITERATIONS),
    ARAP_CONVERGED: partial(flatten_by_libigl, libigl_maps.arap, libigl_maps.MOST_ITERATIONS),
    SLIM: partial(flatten_by_libigl, libigl_maps.slim, libigl_maps.ITERATIONS),
    SLIM_CONVERGED: partial(flatten_by_libigl, libigl_maps.slim, libigl_maps.MOST_ITERATIONS),
    ANGLE_BASED: partial(unwrap_in_blender, "ANGLE_BASED"),
    CONFORMAL: partial(unwrap_in_blender, "CONFORMAL"),
    MINIMUM_STRETCH: partial(unwrap_in_blender, "MINIMUM_STRETCH"),
}
