# SPDX-License-Identifier: GPL-3.0-or-later
"""Sews flat pieces up again and puts them on their model, with a physics engine that shares no code with WireWarp.

python results/wear_in_newton.py OUTPUT

In NVIDIA Newton's SolverStyle3D, the flat triangles are the rest shape of the fabric, and the model's connected
triangles determine how they are sewn. The body is the model, offset inward. The fabric starts on the model, without
gravity and friction, and comes to rest. OUTPUT is JSON: the numbers of Worn by sample and choice of cloths.CHOICES.
"""

from __future__ import annotations

import argparse
import json
from dataclasses import asdict, dataclass
from pathlib import Path

import newton
import numpy as np
import warp
from cloths import CHOICES, WORN
from measures import face_areas, percentile_99
from methods import flatten
from shapes import Shape, all_shapes

CLOTH = (1000.0, 1000.0, 50.0)  # N/m: stiffness of weft, warp and shear, with the ratios of the preset "woven"
BENDING = (2e-5, 2e-5, 1e-5)  # N m: bending stiffness of a shirt, which is too soft to keep a shape by itself
DENSITY = 0.2  # kg/m²; there is no gravity, so the fabric has no weight
CLEARANCE = 0.002  # meters: offset of the body below the model, and of the fabric above the body
CONTACT = 1e4  # N/m: stiffness of contacts; the tension of the fabric presses it into the body by up to 3 mm
# seconds of a step, number of steps, and iterations in a step; 20 more steps would change the rms distance by < 3%
STEP, STEPS, ITERATIONS = 1 / 240, 80, 10


@dataclass(frozen=True)
class Worn:
    """Measures of a sewn and worn garment. Means and percentiles are by area on the model."""

    gap: float  # rms distance from the model along its normals, meters
    slide: float  # rms distance of each vertex from its place on the model, meters
    strain: float  # 99th percentile of the strain of the more strained thread, as a fraction
    wire: float  # largest relative change of a wire's length from the model


def vertex_normals(shape: Shape) -> np.ndarray:
    a, b, c = np.moveaxis(shape.vertices[shape.triangles()], 1, 0)
    normals = np.zeros_like(shape.vertices)
    for corner in range(3):
        np.add.at(normals, shape.triangles()[:, corner], np.cross(b - a, c - a))
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def wear(shape: Shape, corner_uv: np.ndarray) -> np.ndarray:
    """Return the final places (n, 3) of the vertices of the sewn pieces. corner_uv (m, 3, 2): flat pieces in meters."""
    triangles = shape.triangles()
    builder = newton.ModelBuilder(up_axis=newton.Axis.Z)
    newton.solvers.SolverStyle3D.register_custom_attributes(builder)
    newton.solvers.style3d.add_cloth_mesh(
        builder,
        pos=warp.vec3(0.0, 0.0, 0.0),
        rot=warp.quat_identity(),
        vel=warp.vec3(0.0, 0.0, 0.0),
        vertices=shape.vertices.tolist(),
        indices=triangles.ravel().tolist(),
        panel_verts=corner_uv.reshape(-1, 2).tolist(),
        panel_indices=list(range(triangles.size)),
        density=DENSITY,
        particle_radius=CLEARANCE,
        tri_aniso_ke=warp.vec3(*CLOTH),
        edge_aniso_ke=warp.vec3(*BENDING),
        tri_kd=0.0,
    )
    body = shape.vertices - CLEARANCE * vertex_normals(shape)
    builder.add_shape_mesh(body=-1, mesh=newton.Mesh(body.astype(np.float32), triangles.ravel().astype(np.int32)))
    model = builder.finalize(device="cpu")  # on the CPU, because sums there are reproducible
    model.set_gravity((0.0, 0.0, 0.0))
    model.soft_contact_ke, model.soft_contact_kd, model.soft_contact_mu = CONTACT, 0.0, 0.0
    solver = newton.solvers.SolverStyle3D(model, config=newton.solvers.SolverStyle3D.Config(iterations=ITERATIONS))
    # without collisions of the fabric with itself
    solver.collision.stiff_vf = solver.collision.stiff_ee = solver.collision.stiff_ef = 0.0
    state, following = model.state(), model.state()
    control, pipeline = model.control(), newton.CollisionPipeline(model)
    contacts = pipeline.contacts()
    for _ in range(STEPS):
        pipeline.collide(state, contacts)
        state.clear_forces()
        solver.step(state, following, control, contacts, STEP)
        state, following = following, state
        state.particle_qd.zero_()  # without momentum, the fabric comes to rest without oscillation
    return state.particle_q.numpy().astype(float)


def measure(shape: Shape, corner_uv: np.ndarray, worn: np.ndarray) -> Worn:
    triangles = shape.triangles()
    flat = np.stack([corner_uv[:, k] - corner_uv[:, 0] for k in (1, 2)], axis=2)
    sewn = np.stack([worn[triangles[:, k]] - worn[triangles[:, 0]] for k in (1, 2)], axis=2)
    threads = np.linalg.norm(sewn @ np.linalg.inv(flat), axis=1) - 1  # (m, 2): strain of weft and warp
    moved = worn - shape.vertices
    share = np.zeros(len(worn))
    for corner in range(3):
        np.add.at(share, triangles[:, corner], face_areas(shape.vertices, triangles))
    share /= share.sum()

    def length(positions: np.ndarray, chain: list[int]) -> float:
        return float(np.linalg.norm(np.diff(positions[chain], axis=0), axis=1).sum())

    changes = [length(worn, wire.vertices) / length(shape.vertices, wire.vertices) - 1 for wire in shape.wires]
    return Worn(
        gap=float(np.sqrt(share @ (moved * vertex_normals(shape)).sum(axis=1) ** 2)),
        slide=float(np.sqrt(share @ (moved**2).sum(axis=1))),
        strain=percentile_99(np.abs(threads).max(axis=1), face_areas(shape.vertices, triangles)),
        wire=float(max(np.abs(changes), default=0.0)),
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    output = parser.parse_args().output
    found: dict[str, dict[str, dict[str, float]]] = {}
    for shape in all_shapes():
        if shape.name in WORN:
            found[shape.name] = {}
            for choice, options in CHOICES.items():
                corner_uv = flatten(shape, **options).corner_uv
                found[shape.name][choice] = asdict(measure(shape, corner_uv, wear(shape, corner_uv)))
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
