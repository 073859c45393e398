# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in Blender on the open file: flattens the marked objects, and exports them with the file's settings.

blend.py starts this script with a job (JSON) as the last argument, and reads the answer.
"""

import json
import os
import sys
import threading
from pathlib import Path
from typing import Any

import bpy
import numpy as np

NO_ADD_ON = "Blender has no WireWarp add-on: install its zip there and enable it."
NOTHING_MARKED = "No visible mesh of the file has a seam or a wire: mark where to cut."


def end_with_caller() -> None:
    """End Blender when its caller ends. The standard input then closes, and nobody writes to it before."""
    sys.stdin.read()
    os._exit(1)


def is_marked(target: bpy.types.Object) -> bool:
    """Return whether an object is a visible mesh with a seam or a wire. Flat pieces of an earlier run do not count."""
    if target.type != "MESH" or not target.visible_get() or "source_vertex" in target.data.attributes:
        return False
    edges = target.data.edges
    seams = np.zeros(len(edges), dtype=bool)
    edges.foreach_get("use_seam", seams)
    wires = np.zeros(len(edges), dtype=np.int32)
    marks = target.data.attributes.get("wirewarp_wire")
    if marks is not None and marks.domain == "EDGE" and marks.data_type == "INT":
        marks.data.foreach_get("value", wires)
    return bool(seams.any() or wires.any())


def settings_of(operator: Any) -> dict[str, Any]:  # noqa: ANN401 (bpy.ops has no types)
    """Return the scene's settings that are also properties of the operator, by name. Empty texts are left out."""
    scene = bpy.context.scene.wirewarp
    names = set(operator.get_rna_type().properties.keys()) & set(scene.bl_rna.properties.keys()) - {"rna_type", "name"}
    return {name: getattr(scene, name) for name in names if getattr(scene, name) != ""}


def file_name(text: str) -> str:
    return "".join("_" if letter in '<>:"/\\|?*' or ord(letter) < 32 else letter for letter in text)


def clash_sentence(models: list[bpy.types.Object]) -> str:
    """Return a sentence if two models would write the same file, otherwise "". Case in names is ignored."""
    owners: dict[str, bpy.types.Object] = {}
    for model in models:
        other = owners.setdefault(file_name(model.name).casefold(), model)
        if other != model:  # an object of a linked library may have the same name
            return f'The patterns of "{other.name_full}" and "{model.name_full}" would be one file: rename one of them.'
    return ""


def flatten(job: dict[str, Any]) -> dict[str, Any]:
    if not hasattr(bpy.types, "OBJECT_OT_wirewarp_flatten"):
        return {"refusal": NO_ADD_ON}
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    models = [each for each in bpy.context.view_layer.objects if is_marked(each)]
    if not models:
        return {"refusal": NOTHING_MARKED}
    clash = clash_sentence(models)
    if clash:
        return {"refusal": clash}
    for each in bpy.context.view_layer.objects:
        each.select_set(each in models)
    bpy.context.view_layer.objects.active = models[0]
    folder = Path(job["folder"])
    report_path = folder / "report.part"
    try:
        bpy.ops.object.wirewarp_flatten(report_path=str(report_path), **settings_of(bpy.ops.object.wirewarp_flatten))
    except RuntimeError as error:  # raised if a piece failed, even if there is a report
        if not report_path.is_file():
            return {"refusal": str(error).strip().removeprefix("Error: ")}
    report = json.loads(report_path.read_text(encoding="utf-8"))
    report_path.unlink()
    if not any(each["pieces"] for each in report["objects"]):
        return {"refusal": " ".join(issue["sentence"] for each in report["objects"] for issue in each["issues"])}
    files, warnings = export(job, models, folder) if report["ok"] else ([], [])
    return {"refusal": "", "report": report, "files": files, "warnings": warnings}


def export(job: dict[str, Any], models: list[bpy.types.Object], folder: Path) -> tuple[list[str], list[str]]:
    """Write the patterns. Return the names of the files, and warnings.

    A file is named STEM.pdf if there is one model, and STEM-OBJECT.pdf if there are several.
    """
    files: list[str] = []
    warnings: list[str] = []
    report_path = folder / "export.part"
    for model in models:
        bpy.context.view_layer.objects.active = model
        stem = job["stem"] if len(models) == 1 else f"{job['stem']}-{file_name(model.name)}"
        for kind in job["formats"]:
            files.append(f"{stem}.{kind}")
            paths = {"filepath": str(folder / files[-1]), "report_path": str(report_path)}
            bpy.ops.object.wirewarp_export(**paths, **settings_of(bpy.ops.object.wirewarp_export))
            warnings += json.loads(report_path.read_text(encoding="utf-8"))["warnings"]
            report_path.unlink()
    return files, list(dict.fromkeys(warnings))  # each once, because most warnings are repeated for every format


threading.Thread(target=end_with_caller, daemon=True).start()
job = json.loads(sys.argv[-1])
try:
    answer = flatten(job)
except RuntimeError as error:  # raised with a sentence if the export failed
    answer = {"refusal": str(error).strip().removeprefix("Error: ")}
(Path(job["folder"]) / job["answer"]).write_text(json.dumps(answer), encoding="utf-8")
sys.stdout.flush()
os._exit(0)  # ends Blender without saving the file and without waiting for the thread
