# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens one model, writes its files, and returns the line to print for it."""

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from .. import Cloth, Ease, FlattenResult, Options, Wire, __version__, flatten
from ..pattern import Pattern, Written
from ..pattern.files import today
from ..report import make_report
from .blend import BlenderError, flatten_blend
from .lines import Lines, lines_of, seams_of
from .model import Model, read_model
from .proposals import with_proposals
from .repair import Repaired, repaired
from .request import BLEND, FROM_MODEL, MILLIMETERS, InputError, MaterialRequest, Request
from .staged import staged_folder, take_places
from .verdicts import REFUSED, STOPPED, Line, finished, unfinished, with_faults_answered

# These fields of a request are not in the digest. The digest has names and contents of files instead of their paths.
WHEREABOUTS = ("blender", "folder", "model", "refusal", "resume", "seams", "wires")


@with_faults_answered
def flatten_model(request: Request) -> Line:
    """Return the line to print. Faults of the model, the folder or a written file are in the line, not raised."""
    try:
        return _line(request)
    except RuntimeError as error:  # raised if the written file differs from the pattern
        return unfinished(REFUSED, "read_back", str(error))
    except BlenderError as error:
        return unfinished(STOPPED, "crashed", str(error))


def _line(request: Request) -> Line:
    if request.refusal:
        raise InputError(request.refusal)
    is_blend = request.model.suffix.lower() == BLEND
    if is_blend and (request.repair or request.take_proposals):
        raise InputError("--repair and --take-proposals are not for .blend files: use Check and Repair in Blender.")
    model = None if is_blend else read_model(request.model)
    made_of = _made_of(request, model)
    before = _done_before(request, made_of)
    if before:
        return before
    with staged_folder(request) as folder:
        line, report = _flattened(request, model, folder) if model else flatten_blend(request, folder)
        line["made_of"] = made_of
        text = json.dumps({"line": line, **report}, ensure_ascii=False)
        (folder / request.report_path.name).write_text(text, encoding="utf-8")
        take_places(folder, request)
    return line


def _done_before(request: Request, made_of: str) -> Line | None:
    """Return the line of the previous run. Return None if the model or the request has changed, or if a file is
    missing."""
    path = request.report_path
    if not request.resume or not path.is_file():
        return None
    try:
        line: Line = json.loads(path.read_text(encoding="utf-8"))["line"]
        is_same = line["made_of"] == made_of and all((request.folder / name).is_file() for name in line["files"])
    except (ValueError, KeyError, TypeError):
        return None  # the file is not one of our reports
    return {**line, "skipped": True} if is_same else None


def _made_of(request: Request, model: Model | None) -> str:
    """Return a digest of the version, the settings, the model, and the files with seams and wires. For a Blender file,
    the digest covers the whole file."""
    settings = {key: str(value) for key, value in asdict(request).items() if key not in WHEREABOUTS}
    names = [request.model.name, *(name if name in FROM_MODEL else Path(name).name for name in request.lines)]
    digest = hashlib.blake2b(json.dumps([__version__, names, settings], sort_keys=True).encode(), digest_size=16)
    if model is None:
        if not request.model.is_file():
            raise InputError(f'There is no file "{request.model}".')
        with request.model.open("rb") as file:
            digest.update(hashlib.file_digest(file, "blake2b").digest())
        return digest.hexdigest()
    for array in (model.vertices, model.faces, model.corner_uv):
        digest.update(hashlib.blake2b(b"" if array is None else array.tobytes()).digest())
    for path in request.line_files:
        if not path.is_file():
            raise InputError(f'There is no file "{path}" ("{FROM_MODEL[0]}" and "{FROM_MODEL[1]}" are not files).')
        digest.update(hashlib.blake2b(path.read_bytes()).digest())
    return digest.hexdigest()


def _flattened(request: Request, model: Model, folder: Path) -> tuple[Line, dict[str, Any]]:
    """Write the patterns and the picture to the folder. Return the line to print, and the rest of the report."""
    repairs: list[str] = []
    lines = lines_of(request.wires)
    if request.repair:
        found = repaired(model)
        model, repairs, lines = found.model, found.done, _translated(lines, found)
        seams = np.concatenate([found.pairs(seams_of(model, request.seams)), found.seams])
    else:
        seams = seams_of(model, request.seams)
    options = material_options(request.material, request.unit)
    result = flatten(model.vertices, model.faces, seams=seams, wires=lines.wires, eases=lines.eases, options=options)
    if request.take_proposals:
        result, lines, taken = with_proposals(model, result, seams, lines, options)
        repairs += taken
    measured = make_report(
        result,
        model.vertices,
        model.faces,
        wires=lines.wires,
        eases=lines.eases,
        cloth=options.cloth,
        fabric=request.material.cloth or "custom",
        meters=MILLIMETERS[request.unit] / 1000,
        name=request.model.stem,
    )
    failed = [(n, piece.error) for n, piece in enumerate(result.pieces, start=1) if piece.error]
    problems = [(f"Piece {n}: {error.message}", error.code.value) for n, error in failed]
    line = finished([measured], problems, warnings=[], files=[request.report_path.name])
    if request.repair or request.take_proposals:
        line["repairs"] = repairs
    report: dict[str, Any] = {"unit": request.unit}
    if request.repair:
        report["repaired_faces"] = model.faces.tolist()
    if request.picture:
        _draw_picture(folder / request.picture_path.name, request, result, line)
    if not failed:
        report |= _write_patterns(request, _pattern(request, result), folder, line)
    return line, report | _timeless(result.to_dict())


def _write_patterns(request: Request, pattern: Pattern, folder: Path, line: Line) -> dict[str, Any]:
    """Write the pattern and its marker, and note the files in the line. Return entries for the report."""
    for kind in request.formats:
        settings: dict[str, Any] = {"paper": request.page} if kind == "pdf" else {}
        _note(pattern.write(folder / request.pattern_path(kind).name, **settings), line)
    if not request.marker:
        return {}
    marker = pattern.nested(**asdict(request.marker))
    laid = pattern.laid_on(marker)
    for kind in request.formats:
        # Without the setting "paper", a PDF is a roll as wide as the marker.
        _note(laid.write(folder / request.marker_path(kind).name), line)
    line["marker"] = marker.sentence(laid.units)
    return {"marker": marker.to_dict()}


def _translated(lines: Lines, found: Repaired) -> Lines:
    """Return the wires and eases of a file, with the vertices of the repaired mesh."""
    wires = [Wire(found.chain(wire.vertices), wire.tolerance, wire.name, wire.ease) for wire in lines.wires]
    return Lines(wires, [Ease(found.sides(ease.half_edges), ease.ratio) for ease in lines.eases])


def material_options(material: MaterialRequest, unit: str) -> Options:
    thickness = material.thickness / MILLIMETERS[unit]
    cloth = Cloth.preset(material.cloth) if material.cloth else None
    if any(material.stretch):
        of = cloth or Cloth()
        cloth = Cloth(
            of.weft,
            of.warp,
            of.shear,
            squeeze=of.squeeze,
            stretch=material.stretch,
            locking=of.locking,
            limits=of.limits,
        )
    return Options(cloth=cloth, orientation=material.orientation, thickness=thickness, surface=material.surface)


def _timeless(result: dict[str, Any]) -> dict[str, Any]:
    """Return the result without durations, so that the same model always gives the same file."""
    for each in (result, *result["pieces"]):
        del each["report"]["seconds"]
    return result


def _draw_picture(path: Path, request: Request, result: FlattenResult, line: Line) -> None:
    try:
        from .picture import write_picture
    except ModuleNotFoundError as error:
        raise InputError("Pictures are drawn by pillow, which is missing: pip install wirewarp[command]") from error
    if write_picture(path, result, MILLIMETERS[request.unit]):
        line["files"].append(path.name)


def _pattern(request: Request, result: FlattenResult) -> Pattern:
    return Pattern.from_result(
        result,
        title=request.model.stem,
        date=today().isoformat(),
        millimeters_per_unit=MILLIMETERS[request.unit],
        allowance=request.allowance,
        hem=request.hem,
        pairs=request.pairs,
        on_fold=request.on_fold,
        units="imperial" if request.imperial else "metric",
    )


def _note(written: Written, line: Line) -> None:
    line["files"].append(written.path.name)
    line["warnings"] += [warning for warning in written.warnings if warning not in line["warnings"]]
