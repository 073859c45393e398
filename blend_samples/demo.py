# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens every sample with the add-on, and shows the results:

blender --background --factory-startup --python-exit-code 1 --addons wirewarp_addon \\
    --python blend_samples/demo.py -- OUTPUT_FOLDER [SAMPLE ...]

It prints all lengths. For each sample, it writes a .blend file with the flat pieces, a JSON report and a picture.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

import bpy

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from pictures.sheet import draw_sample  # noqa: E402 (the folder must be on the path first)
from pictures.views import VIEWS  # noqa: E402
from tables import object_tables  # noqa: E402


def settings_of_the_file() -> dict[str, str | float]:
    """Return the settings that samples change. An operator that a script calls does not read them from the scene."""
    names = ("cloth", "worn_across", "worn_along", "fairness")
    return {name: getattr(bpy.context.scene.wirewarp, name) for name in names}


def flatten_sample(name: str, output: Path, terminal: TextIO) -> bool:
    """Write the files of a sample and print its lengths. Return whether all guarantees hold."""
    bpy.ops.wm.open_mainfile(filepath=str(FOLDER / f"{name}.blend"))
    model = bpy.context.view_layer.objects.active
    report_path = output / f"{name}.json"
    begin = time.monotonic()
    problem = ""
    try:
        bpy.ops.object.wirewarp_flatten(report_path=str(report_path), **settings_of_the_file())
    except RuntimeError as error:  # the add-on has written its results; the demo continues with the next sample
        problem = str(error)
    seconds = time.monotonic() - begin
    report = json.loads(report_path.read_text())["objects"][0]
    count = len(report["pieces"])
    pieces = "1 piece" if count == 1 else f"{count} pieces"
    print(f"\n{model.name}: {pieces}, {report['method_name']}, {seconds:.2f} s", file=terminal)
    print(object_tables(report), file=terminal)

    bpy.ops.wm.save_as_mainfile(filepath=str(output / f"{name}.blend"), compress=True, check_existing=False)
    flat = bpy.data.objects[f"{model.name} Flat"]
    draw_sample(model, flat, VIEWS[name], report, output / f"{name}.png")
    return not problem


@contextmanager
def log_of_blender(path: Path) -> Iterator[TextIO]:
    """Redirect all messages of Blender to a file, and yield the terminal for our own output.

    After an error, messages go to the terminal again, so that Blender can show the error. Without an error, later
    messages go to the file, too.
    """
    terminal = os.fdopen(os.dup(1), "w", buffering=1)
    errors = os.dup(2)
    with path.open("w") as file:
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
        try:
            yield terminal
        except BaseException:
            os.dup2(terminal.fileno(), 1)
            os.dup2(errors, 2)
            raise


def main() -> int:
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    output = Path(arguments[0]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    bpy.context.preferences.filepaths.save_version = 0  # no .blend1 backup of a file that is written again
    with log_of_blender(output / "blender.log") as terminal:
        failed = [name for name in arguments[1:] or VIEWS if not flatten_sample(name, output, terminal)]
        print(f"\nPictures, .blend files with the pieces and reports: {output}", file=terminal)
        if failed:
            print(f"A guarantee is broken: {', '.join(failed)}", file=terminal)
    return 1 if failed else 0


sys.exit(main())
