# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares Flatten in Blender with Blender's own angle-based unwrap. Both run in turn in one process:

blender --background --factory-startup --python-exit-code 1 --addons wirewarp_addon \\
    --python bench/flatten_in_blender.py -- OUTPUT.json [TRIANGLES ...]
"""

import json
import os
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import bmesh
import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

from surfaces import bumpy_sheet  # noqa: E402 (the folder must be on the path first)

# The add-on has the first name in Debian 12's Blender, and the second in Debian 13's, which has extensions.
addon = sys.modules.get("wirewarp_addon") or sys.modules["bl_ext.user_default.wirewarp"]
choices_of = addon.state.settings.choices_of
solve_models, read_models = addon.flatten.models.solve_models, addon.flatten.read.read_models
write_results = addon.flatten.write.write_results
in_one_go = addon.solve.steps.in_one_go

TURNS = 3


def add_sheet(triangles: int) -> bpy.types.Object:
    """Add the sheet with two rigid wires across its middle, as the active and selected object."""
    surface = bumpy_sheet(triangles)
    mesh = bpy.data.meshes.new("Sheet")
    mesh.from_pydata(surface.vertices.tolist(), [], surface.faces.tolist())
    ends = np.empty(2 * len(mesh.edges), dtype=np.int32)
    mesh.edges.foreach_get("vertices", ends)
    wires = np.zeros(len(mesh.edges), dtype=np.int32)
    for number, chain in enumerate(surface.few_wires, start=1):
        wires[np.isin(ends, chain).reshape(-1, 2).all(axis=1)] = number
    mesh.attributes.new("wirewarp_wire", "INT", "EDGE").data.foreach_set("value", wires)
    sheet = bpy.data.objects.new("Sheet", mesh)
    bpy.context.scene.collection.objects.link(sheet)
    bpy.context.view_layer.update()
    sheet.select_set(True)
    bpy.context.view_layer.objects.active = sheet
    return sheet


def seconds_of(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def new_sheet(triangles: int) -> bpy.types.Object:
    """Add the sheet in a new file, so that no data of an earlier run is used again."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    return add_sheet(triangles)


def seconds_of_steps(sheet: bpy.types.Object) -> dict[str, float]:
    """Return the seconds of each step of the operator."""
    context, settings = bpy.context, bpy.context.scene.wirewarp
    marks = [time.perf_counter()]
    models = read_models(context, [sheet], settings)
    marks.append(time.perf_counter())
    outcomes = in_one_go(solve_models(models, choices_of(settings, 1.0), 1.0))
    marks.append(time.perf_counter())
    write_results(context, outcomes, settings)
    marks.append(time.perf_counter())
    return dict(zip(("read", "solve", "write"), np.diff(marks).tolist(), strict=True))


def take_turn(triangles: int) -> dict[str, float]:
    steps = seconds_of_steps(new_sheet(triangles))
    sheet = new_sheet(triangles)
    flatten = seconds_of(bpy.ops.object.wirewarp_flatten)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    unwrap = seconds_of(lambda: bpy.ops.uv.unwrap(method="ANGLE_BASED", margin=0.001))
    return {"triangles": len(bmesh.from_edit_mesh(sheet.data).faces), "flatten": flatten, "unwrap": unwrap} | steps


def compare(triangles: int) -> dict:
    """Return the medians of all turns, in seconds."""
    turns = [take_turn(triangles) for _ in range(TURNS)]
    return {name: statistics.median(turn[name] for turn in turns) for name in turns[0]}


def main() -> None:
    output, *sizes = sys.argv[sys.argv.index("--") + 1 :]
    # Flatten gets one core, too, because the unwrap uses one thread.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    rows = [compare(int(size)) for size in sizes or ("10000", "100000")]
    Path(output).write_text(json.dumps({"blender": bpy.app.version_string, "runs": rows}, indent=1), encoding="utf-8")


main()
