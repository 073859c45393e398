# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the sample .blend files beside this script. Needs no add-on:

blender --background --factory-startup --python-exit-code 1 --python blend_samples/make_samples.py -- [SAMPLE ...]

Use Blender 3.4, so that every later version opens the files. Every run writes the same geometry and marks.
"""

from __future__ import annotations

import sys
import zlib
from pathlib import Path

import bpy
import numpy as np

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent / "addon" / "wirewarp" / "blender")]

from shapes import ALLOWANCE, FAIRNESS, Shape, all_shapes  # noqa: E402 (the folder must be on the path first)
from views import Projection, fit  # noqa: E402 (the folder must be on the path first)

CLOTHS = (  # names of fabrics in the order of the add-on's setting, "" for no fabric
    "", "woven", "denim", "jersey", "swim", "leather", "neoprene", "felt", "fleece", "minky", "vinyl", "foam",
)  # fmt: skip
# cotangents of half the horizontal and half the vertical angle of Blender's usual view, without sidebar and toolbar
COTANGENTS = (1.7, 2.6)


def wire_id(name: str) -> int:
    """Return a 31-bit id, which is the same in every run. The ids of the add-on are random."""
    return zlib.crc32(name.encode()) & 0x7FFFFFFF


def add_mesh(shape: Shape) -> bpy.types.Mesh:
    """Add the shape as a smooth mesh with Blender's seams and the add-on's wire attributes."""
    corners = np.concatenate(shape.faces).astype(np.int32)
    sizes = np.array([len(face) for face in shape.faces], dtype=np.int32)
    following = np.concatenate([np.roll(face, -1) for face in shape.faces])
    # Edges of wires come first, in the order of the wires, because the add-on lists wires in the order of their edges.
    edge_of: dict[frozenset[int], int] = {}
    for chain in [wire.vertices for wire in shape.wires]:
        for pair in zip(chain[:-1], chain[1:], strict=True):
            edge_of.setdefault(frozenset(pair), len(edge_of))
    for pair in zip(corners.tolist(), following.tolist(), strict=True):
        edge_of.setdefault(frozenset(pair), len(edge_of))
    edge_of_corner = [edge_of[frozenset(pair)] for pair in zip(corners.tolist(), following.tolist(), strict=True)]

    mesh = bpy.data.meshes.new(shape.name)
    mesh.vertices.add(len(shape.vertices))
    mesh.vertices.foreach_set("co", shape.vertices.astype(np.float32).ravel())
    mesh.edges.add(len(edge_of))
    mesh.edges.foreach_set("vertices", np.array([sorted(pair) for pair in edge_of], dtype=np.int32).ravel())
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.loops.foreach_set("edge_index", np.array(edge_of_corner, dtype=np.int32))
    mesh.polygons.add(len(sizes))
    mesh.polygons.foreach_set("loop_start", (np.cumsum(sizes) - sizes).astype(np.int32))
    mesh.polygons.foreach_set("loop_total", sizes)
    mesh.polygons.foreach_set("use_smooth", np.ones(len(sizes), dtype=bool))
    if mesh.validate(verbose=True):
        raise ValueError(f"{shape.name}: Blender had to repair the mesh")
    mesh.update()

    seam = np.zeros(len(mesh.edges), dtype=bool)
    seam[[edge_of[frozenset(pair)] for pair in shape.seams.tolist()]] = True
    mesh.edges.foreach_set("use_seam", seam)

    wires = np.zeros(len(mesh.edges), dtype=np.int32)
    tolerances = np.zeros(len(mesh.edges), dtype=np.float32)
    for wire in shape.wires:
        edges = [edge_of[frozenset(pair)] for pair in zip(wire.vertices[:-1], wire.vertices[1:], strict=True)]
        wires[edges] = wire_id(wire.name)
        tolerances[edges] = wire.tolerance
    mesh.attributes.new("wirewarp_wire", "INT", "EDGE").data.foreach_set("value", wires)
    mesh.attributes.new("wirewarp_tolerance", "FLOAT", "EDGE").data.foreach_set("value", tolerances)
    if shape.eases:
        corner_of = {pair: corner for corner, pair in enumerate(zip(corners.tolist(), following.tolist(), strict=True))}
        eases = np.zeros(len(corners), dtype=np.float32)
        for ease in shape.eases:
            eases[[corner_of[tuple(pair)] for pair in ease.half_edges.tolist()]] = ease.ratio
        mesh.attributes.new("wirewarp_side_ease", "FLOAT", "CORNER").data.foreach_set("value", eases)
    # The add-on stores the names of wires in a collection property with this name.
    mesh["wirewarp_names"] = [{"name": wire.name, "wire_id": wire_id(wire.name)} for wire in shape.wires]
    return mesh


def settings(shape: Shape) -> dict[str, int | float]:
    """Return the sample's settings that are not defaults, as the add-on's scene property stores them."""
    found: dict[str, int | float] = {}
    if shape.cloth:
        found["cloth"] = CLOTHS.index(shape.cloth)
        found["worn_across"], found["worn_along"] = (100 * share for share in shape.stretch)
    if shape.fairness != FAIRNESS:
        found["fairness"] = shape.fairness
    if shape.allowance != ALLOWANCE:
        found["allowance"] = shape.allowance
    return found


def file_name(shape: Shape) -> str:
    return f"{shape.name.lower().replace(' ', '_')}.blend"


def show_all(points: np.ndarray) -> None:
    """Make every 3D view of the file show all points, with the sidebar open."""
    for screen in bpy.data.screens:
        for space in (space for area in screen.areas if area.type == "VIEW_3D" for space in area.spaces):
            if space.type != "VIEW_3D":
                continue
            view = space.region_3d
            axes = np.array(view.view_rotation.to_matrix())
            view.view_location, view.view_distance = fit(points, Projection(axes, *COTANGENTS, is_perspective=True))
            space.show_region_ui = True


def write_sample(shape: Shape) -> Path:
    """Write a file with one object, in which Blender displays lengths in millimeters."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    units = bpy.context.scene.unit_settings
    units.system, units.length_unit = "METRIC", "MILLIMETERS"
    model = bpy.data.objects.new(shape.name, add_mesh(shape))
    bpy.context.scene.collection.objects.link(model)
    for name, vertices in shape.groups.items():
        model.vertex_groups.new(name=name).add(vertices, 1.0, "REPLACE")
    if settings(shape):
        bpy.context.scene["wirewarp"] = settings(shape)
    bpy.context.view_layer.objects.active = model
    model.select_set(True)
    show_all(shape.vertices)  # only the model, because the first Flatten brings the pieces into view
    path = FOLDER / file_name(shape)
    bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=True, check_existing=False)
    return path


bpy.context.preferences.filepaths.save_version = 0  # no .blend1 backup of a file that is written again
wanted = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
for sample in all_shapes():
    if wanted and file_name(sample).removesuffix(".blend") not in wanted:
        continue
    written = write_sample(sample)
    print(f"{written.name}: {len(sample.triangles())} triangles, {written.stat().st_size / 1000:.0f} kB")
