# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens every sample with the add-on and shows what came out:

blender --background --factory-startup --python-exit-code 1 --addons wirewarp_addon \\
    --python blend_samples/demo.py -- OUTPUT_FOLDER [SAMPLE ...]

Prints all lengths, and writes for each sample a .blend file with the flat pieces, a JSON report and a picture.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import bpy

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

os.environ["EGL_LOG_LEVEL"] = "fatal"  # Mesa warns before it falls back to drawing without a screen

from pictures.sheet import draw_sample  # noqa: E402 (the folder must be on the path first)
from tables import object_tables  # noqa: E402

# From where each sample is drawn: degrees it is turned to the left and tipped toward the viewer.
VIEWS = {
    "fitted_top": (-28, 8),
    "quarter_sphere": (-62, 10),
    "ball_of_six_gores": (-20, 22),
    "half_cylinder": (-62, 20),
    "lampshade": (-52, 14),
    "cushion": (-30, 28),
    "hat": (-40, 20),
    "carnival_mask": (-18, 6),
}


def flatten_sample(name: str, output: Path) -> bool:
    """Writes the files of one sample; False if a promise was broken."""
    bpy.ops.wm.open_mainfile(filepath=str(FOLDER / f"{name}.blend"))
    model = bpy.context.view_layer.objects.active
    report_path = output / f"{name}.json"
    begin = time.monotonic()
    problem = ""
    try:
        bpy.ops.object.wirewarp_flatten(report_path=str(report_path))
    except RuntimeError as error:  # the add-on has written what there is; the demo goes on with the next sample
        problem = str(error)
    seconds = time.monotonic() - begin
    report = json.loads(report_path.read_text())["objects"][0]
    print(f"\n{model.name}: {len(report['pieces'])} pieces by {report['method_name']}, {seconds:.2f} s in all")
    print(object_tables(report))

    bpy.ops.wm.save_as_mainfile(filepath=str(output / f"{name}.blend"), compress=True, check_existing=False)
    flat = bpy.data.objects[f"{model.name} Flat"]
    draw_sample(model, flat, VIEWS[name], report, output / f"{name}.png")
    return not problem


def main() -> int:
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    output = Path(arguments[0]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    bpy.context.preferences.filepaths.save_version = 0  # no .blend1 beside a file that is written again
    failed = [name for name in arguments[1:] or VIEWS if not flatten_sample(name, output)]
    print(f"\nPictures, .blend files and reports: {output}")
    if failed:
        print(f"Not every promise was kept: {', '.join(failed)}")
    return 1 if failed else 0


sys.exit(main())
