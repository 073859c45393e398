# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens models one by one or several at a time, and prints what became of each."""

import datetime
import hashlib
import json
import multiprocessing
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from typing import Any

from .. import FlattenError, FlattenResult, __version__, flatten
from ..pattern import Marker, Pattern, Written
from ..pattern.replace_file import replaced_file
from .arguments import FROM_MODEL, MILLIMETERS, Arguments, MarkerRequest, Request
from .input_error import InputError
from .lines import seams_of, wires_of
from .model import Model, read_model

READY, FAILED, REFUSED = "ready to cut", "not ready to cut", "refused"
EXIT_CODES = {READY: 0, FAILED: 1, REFUSED: 2}
Line = dict[str, Any]


def flatten_models(arguments: Arguments) -> int:
    """Prints one line of JSON for each model; returns the exit code, that of the worst."""
    worst = 0
    for line in _all(arguments):
        print(json.dumps(line), flush=True)  # ASCII: every console can show it
        worst = max(worst, EXIT_CODES[line["verdict"]])
    return worst


def _all(arguments: Arguments) -> Iterator[Line]:
    if arguments.jobs == 1:
        yield from map(flatten_model, arguments.requests)
        return
    fresh = multiprocessing.get_context("spawn")  # the threads of the library are not for children of a fork
    with ProcessPoolExecutor(arguments.jobs, mp_context=fresh) as pool:
        yield from pool.map(flatten_model, arguments.requests)


def flatten_model(request: Request) -> Line:
    """Never raises for what is wrong with the model, the folder or a file that was read again: the line says it."""
    begin = time.monotonic()
    try:
        line = _line(request)
    except (InputError, FlattenError, RuntimeError) as error:
        line = {"verdict": REFUSED, "problems": [str(error)]}
    except OSError as error:
        line = {"verdict": REFUSED, "problems": [f"{error.filename or request.folder}: {error.strerror or error}"]}
    return {"model": str(request.model), **line, "seconds": round(time.monotonic() - begin, 3)}


def _line(request: Request) -> Line:
    model = read_model(request.model)
    made_of = _made_of(request, model)
    return _done_before(request, made_of) or _flattened(request, model, made_of)


def _done_before(request: Request, made_of: str) -> Line | None:
    """The line of the last time, if nothing has changed since and all that was written is there."""
    path = request.report_path
    if not request.resume or not path.is_file():
        return None
    try:
        line: Line = json.loads(path.read_text(encoding="utf-8"))["line"]
        is_same = line["made_of"] == made_of and all((request.folder / name).is_file() for name in line["files"])
    except (ValueError, KeyError, TypeError):
        return None  # no report of ours: it is written anew
    return {**line, "skipped": True} if is_same else None


def _made_of(request: Request, model: Model) -> str:
    """A digest of the version, the settings, what was read of the model (it may have several files), and the lines."""
    settings = {key: str(value) for key, value in asdict(request).items() if key not in ("folder", "resume")}
    digest = hashlib.blake2b(json.dumps([__version__, settings], sort_keys=True).encode(), digest_size=16)
    for array in (model.vertices, model.faces, model.corner_uv):
        digest.update(hashlib.blake2b(b"" if array is None else array.tobytes()).digest())
    for file in request.line_files:
        if not file.is_file():
            raise InputError(f'There is no file "{file}" ("{FROM_MODEL[0]}" and "{FROM_MODEL[1]}" are no files).')
        digest.update(hashlib.blake2b(file.read_bytes()).digest())
    return digest.hexdigest()


def _flattened(request: Request, model: Model, made_of: str) -> Line:
    seams, wires = seams_of(model, request.seams), wires_of(request.wires)
    request.folder.mkdir(parents=True, exist_ok=True)
    request.report_path.unlink(missing_ok=True)  # there is none of patterns of which some are new and some are old
    result = flatten(model.vertices, model.faces, seams=seams, wires=wires)
    problems = [f"Piece {n}: {piece.error.message}" for n, piece in enumerate(result.pieces, start=1) if piece.error]
    pattern = None if problems else _pattern(request, result)
    marker = _nested(pattern, request.marker) if pattern and request.marker else None
    laid = pattern.laid_on(marker) if pattern and marker else None
    for drawn, paper in ((pattern, request.page), (laid, None)) if "pdf" in request.formats else ():
        if drawn:
            drawn.page_sizes(paper)  # what does not fit is refused before anything is written
    line: Line = {
        "verdict": FAILED if problems else READY,
        "pieces": len(result.pieces),
        "problems": problems,
        "warnings": [],
        "files": [request.report_path.name],
        "made_of": made_of,
    }
    if request.picture:
        try:
            from .picture import write_picture
        except ModuleNotFoundError as error:
            raise InputError("Pictures are drawn by pillow, which is missing: pip install wirewarp[command]") from error
    request.picture_path.unlink(missing_ok=True)  # of an earlier run: now there may be nothing to draw
    if request.picture and write_picture(request.picture_path, result, model.vertices, MILLIMETERS[request.unit]):
        line["files"].append(request.picture_path.name)
    for kind in request.formats:
        request.marker_path(kind).unlink(missing_ok=True)  # of an earlier run: it may be of other pieces
        if pattern:
            options: dict[str, Any] = {"paper": request.page} if kind == "pdf" else {}
            _note(pattern.write(request.pattern_path(kind), **options), line)
        else:
            request.pattern_path(kind).unlink(missing_ok=True)  # of an earlier run: nobody is to cut it
    placed: dict[str, Any] = {}
    if laid and marker:
        for kind in request.formats:
            _note(laid.write(request.marker_path(kind)), line)  # PDF on a roll as wide as it needs
        line["marker"], placed = marker.sentence(laid.units), {"marker": marker.to_dict()}
    report = {"line": line, "unit": request.unit, **placed, **result.to_dict()}
    with replaced_file(request.report_path) as unfinished:
        unfinished.write_text(json.dumps(report, ensure_ascii=False), encoding="utf-8")
    return line


def _pattern(request: Request, result: FlattenResult) -> Pattern:
    return Pattern.from_result(
        result,
        title=request.model.stem,
        date=datetime.date.today().isoformat(),
        millimeters_per_unit=MILLIMETERS[request.unit],
        allowance=request.allowance,
        hem=request.hem,
        units="imperial" if request.imperial else "metric",
    )


def _nested(pattern: Pattern, wanted: MarkerRequest) -> Marker:
    return pattern.nested(
        wanted.width, wanted.length, gap=wanted.gap, grain=wanted.grain, times=wanted.times, seconds=wanted.seconds
    )


def _note(written: Written, line: Line) -> None:
    line["files"].append(written.path.name)
    line["warnings"] += [warning for warning in written.warnings if warning not in line["warnings"]]
