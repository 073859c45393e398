# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the arguments of the command line."""

import argparse
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import NoReturn, TypeVar, get_args

import psutil

from .. import Cloth
from .._errors import FlattenError
from ..pattern import FORMATS
from ..pattern.nest.items import Grain
from ..pattern.sheet.papers import roll_width
from .apart import Limits
from .inputs import Found, found_models
from .request import (
    MILLIMETERS,
    AnyRequest,
    CutRequest,
    InputError,
    MarkerRequest,
    MaterialRequest,
    Orientation,
    Request,
)

LENGTH = re.compile(r"(\d+(?:\.\d*)?)(?:/(\d+))?\s*(mm|cm|m|in)")
SHEET = re.compile(r"(\d+(?:\.\d*)?)x(\d+(?:\.\d*)?)\s*(mm|cm|m|in)")
STRETCH = re.compile(r"(-?\d+(?:\.\d*)?)%(?:,\s*(-?\d+(?:\.\d*)?)%)?")
MEMORY = re.compile(r"(\d+(?:\.\d*)?)\s*(MB|GB)")
T = TypeVar("T")
BYTES = {"MB": 10**6, "GB": 10**9}
GRAINS: dict[str, Grain] = {"one-way": "one way", "both-ways": "both ways", "free": "free"}  # for Pattern.nested()
ORIENTATIONS = get_args(Orientation)
VERDICTS = (
    "Prints one line of JSON for each model. The exit code is that of the worst model. 0: ready to cut, or needs "
    "stretch fabric. 1: not ready to cut, because a piece failed or the fabric does not stretch far enough. 2: the "
    "model is refused. 3: the model crashed, or exceeded its limit of time or memory."
)


@dataclass(frozen=True)
class Arguments:
    requests: Sequence[AnyRequest]
    jobs: int
    limits: Limits


def parsed(words: Sequence[str]) -> Arguments:
    """Return the arguments. If they are invalid, print a sentence and end the program with code 2."""
    given = _parser().parse_args(words)
    return Arguments(given.requests_of(given), given.jobs, _limits(given))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m wirewarp", description="Flat patterns with exact lengths.")
    commands = parser.add_subparsers(required=True, metavar="flatten|batch|propose")
    flatten = commands.add_parser(
        "flatten",
        # Each command gets new options, because set_defaults() changes the options of its parents.
        parents=[_model_options(), _writing_options(), _running_options()],
        help="flatten models, and write reports and patterns",
        description="Flattens models (OBJ, PLY, STL, glTF, Blender) and writes a report and a pattern for each. "
        + VERDICTS,
    )
    flatten.add_argument("models", nargs="+", metavar="MODEL", type=Path)
    flatten.add_argument("--resume", action="store_true", help="skip finished models that have not changed")
    flatten.set_defaults(command=flatten, is_batch=False, jobs=1, part=(1, 1), requests_of=_requests)
    batch = commands.add_parser(
        "batch",
        parents=[_model_options(), _writing_options(), _running_options()],
        help="flatten folders and lists of models, and skip finished ones",
        description="Runs flatten --resume on all models of folders and lists. If you run it again, it skips finished "
        "models that have not changed. " + VERDICTS,
    )
    batch.add_argument(
        "models",
        nargs="+",
        metavar="IN",
        type=Path,
        help="a model, a folder with models, or a list (.jsonl with one object per line: a model and its options)",
    )
    batch.add_argument(
        "--part", type=_part, default=(1, 1), metavar="K/N", help="only the K-th of every N models, to share the work"
    )
    jobs = os.cpu_count() or 1
    batch.set_defaults(command=batch, is_batch=True, resume=True, jobs=jobs, requests_of=_requests)
    propose = commands.add_parser(
        "propose",
        parents=[_shape_options(), _cut_options(), _running_options()],
        help="find the darts or seams that reduce the distortion of a piece most, or seams to leave out",
        description="Evaluates cuts of models (OBJ, PLY, STL, glTF) by flattening, and prints one line of JSON with "
        "the best cuts of each model. With --cut fewer, the line lists the seams to keep. The exit code is "
        "that of the worst model. 0: cuts or seams are proposed. 1: nothing is proposed. 2: the model is refused. "
        "3: the model crashed, or exceeded its limit of time or memory.",
    )
    propose.add_argument("models", nargs="+", metavar="MODEL", type=Path)
    propose.set_defaults(command=propose, jobs=1, requests_of=_cut_requests)
    return parser


def _cut_requests(given: argparse.Namespace) -> list[CutRequest]:
    if given.together and (given.piece or given.count):
        given.command.error("--together chooses pieces and cuts itself: use it without --piece and --count")
    if given.kind == "fewer":
        _check_fewer(given.command, given)
    elif given.narrowest is not None and (given.kind == "dart" or given.together):
        given.command.error("--narrowest is for sets of seams: use it with --cut seam and without --together")
    material = _made(MaterialRequest, given)
    return [_made(CutRequest, given, model=model, material=material) for model in given.models]


def _requests(given: argparse.Namespace) -> list[Request]:
    try:
        models = found_models(given.models) if given.is_batch else [Found(model, Path()) for model in given.models]
        requests = [_request(found, _with_own_options(found, given)) for found in models]
        clashes = _clashes(requests)
        if clashes and not given.is_batch:
            raise InputError(next(iter(clashes.values())))
    except InputError as error:
        given.command.error(str(error))
    part, parts = given.part
    return [replace(request, refusal=clashes.get(n, "")) for n, request in enumerate(requests)][part - 1 :: parts]


def _shape_options() -> argparse.ArgumentParser:
    """Return the options that affect the flat pieces of a model."""
    options = _Options(add_help=False, allow_abbrev=False)
    add = options.add_argument
    add(
        "--seams",
        default="",
        metavar="uv|sharp|FILE",
        help="seams: around UV islands, at sharp edges, or from a JSON file",
    )
    add("--wires", default="", metavar="FILE", help="JSON file with wires and eases")
    add("--cloth", default="", choices=Cloth.presets(), help="fabric of the pieces (none: the least distortion)")
    add("--orientation", default="wire", choices=ORIENTATIONS, help="direction that points up, along the grain (wire)")
    add("--unit", choices=MILLIMETERS, default="m", help="unit of the coordinates (m)")
    add(
        "--stretch",
        type=_stretch,
        default=(0.0, 0.0),
        metavar="WEFT,WARP",
        help="negative ease across and along the grain: 10%%,5%%, or 10%% for both. "
        "Positive ease: --stretch=-5%% (0%%)",
    )
    add("--thickness", type=_length, default=0.0, help="thickness of foam, neoprene or leather: 3mm (0)")
    add(
        "--surface",
        choices=("inside", "middle", "outside"),
        default="inside",
        help="which surface of the thick material was modeled (inside)",
    )
    return options


def _cut_options() -> argparse.ArgumentParser:
    options = argparse.ArgumentParser(add_help=False)
    add = options.add_argument
    add(
        "--cut",
        dest="kind",
        choices=("dart", "seam", "fewer"),
        default="dart",
        help='kind of cut, or "fewer" to leave out some seams of --seams (dart)',
    )
    add("--piece", type=_count, metavar="N", help="cut only the N-th piece (piece that gains most)")
    add("--count", type=_count, metavar="N", help="number of proposals, with mirror images counted once (5)")
    add("--longest", type=_length, help="maximum length of a cut on the model: 150mm (any)")
    add("--narrowest", type=_length, help="smallest width of the pieces of a set of seams: 12mm (any)")
    add(
        "--strain",
        type=_share,
        metavar="5%",
        help="do not cut pieces with less strain in 99%% of their area (0.5%%). For sets of seams and --together: the "
        "target (5%%). For --cut fewer: maximum strain of each remaining piece (5%%)",
    )
    add("--together", type=_count, metavar="N", help="choose up to N cuts in sequence, until --strain is reached")
    add("--no-seam", default="", metavar="FILE", help="JSON file with lines where cuts are forbidden")
    return options


def _model_options() -> argparse.ArgumentParser:
    """Return the options that may differ from model to model."""
    options = _Options(add_help=False, allow_abbrev=False, parents=[_shape_options()])
    add = options.add_argument
    add(
        "--format",
        dest="formats",
        default="pdf,svg",
        metavar="F,F",
        type=_formats,
        help="kinds of files: pdf, svg, dxf, plt (pdf,svg)",
    )
    add("--page", default="a4", type=_page, help="paper for PDF: a4, letter, a0, 36in, 900mm, ... (a4)")
    add("--allowance", default="10mm", type=_length, help="width of seam allowances: 10mm, 1cm, 3/8in (10mm)")
    add("--hem", type=_length, help="allowance of edges that are not sewn (as --allowance)")
    add("--pairs", action="store_true", help="draw pieces of equal shape once, even if mirrored")
    add("--on-fold", action="store_true", help="draw half of each symmetric piece, to cut on the fold")
    add("--imperial", action="store_true", help="use inches in texts and test squares")
    add("--marker", type=_cloth, metavar="WIDTH|WxL", help="nest the pieces on a roll (1400mm) or on sheets (60x90cm)")
    add("--gap", type=_length, default="5mm", help="space between the pieces of a marker (5mm)")
    add("--grain", choices=GRAINS, default="one-way", help="directions of pieces in a marker (one-way)")
    add("--times", type=_count, default=1, metavar="N", help="number of copies of the pattern in a marker (1)")
    add("--seconds", type=_seconds, default=10.0, metavar="S", help="duration of the search for a marker (10)")
    add("--repair", action="store_true", help="repair the mesh first, and report the repairs")
    add("--take-proposals", action="store_true", help="mark the seams suggested for failed pieces, and flatten again")
    add("--picture", action="store_true", help="write a PNG of the flat pieces, colored by strain")
    return options


def _writing_options() -> argparse.ArgumentParser:
    options = argparse.ArgumentParser(add_help=False)
    add = options.add_argument
    add("--out", required=True, metavar="DIR", type=Path, help="output folder")
    add("--blender", default="blender", metavar="PATH", help="program for .blend files (blender)")
    return options


def _running_options() -> argparse.ArgumentParser:
    options = argparse.ArgumentParser(add_help=False)
    add = options.add_argument
    add("--jobs", type=_count, metavar="N", help="models in parallel (1; batch: all cores)")
    # One hour is enough for any model: a million triangles take about ten seconds.
    add("--time-limit", type=_seconds, default=3600.0, metavar="S", help="maximum seconds per model (3600)")
    add(
        "--memory-limit",
        type=_memory,
        metavar="4GB",
        help="maximum memory per model (memory of the machine divided by the jobs)",
    )
    return options


class _Options(argparse.ArgumentParser):
    """Parses options that may come from a list of models. Raises InputError instead of printing the usage."""

    def error(self, message: str) -> NoReturn:
        raise InputError(message)


def _with_own_options(found: Found, given: argparse.Namespace) -> argparse.Namespace:
    if not found.options:
        return given
    words = [f"--{name}" if value is True else f"--{name}={value}" for name, value in found.options.items()]
    try:
        return _model_options().parse_args(words, argparse.Namespace(**vars(given)))
    except InputError as error:
        raise InputError(f"{found.source}: {error}") from error


def _limits(given: argparse.Namespace) -> Limits:
    return Limits(given.time_limit, given.memory_limit or psutil.virtual_memory().total // given.jobs)


def _request(found: Found, given: argparse.Namespace) -> Request:
    marker = None
    if given.marker:
        width, length = given.marker
        marker = MarkerRequest(width, length, given.gap, GRAINS[given.grain], given.times, given.seconds)
    own = {"model": found.model, "folder": given.out / found.folder, "marker": marker, "refusal": ""}
    return _made(Request, given, material=_made(MaterialRequest, given), **own)


def _made(kind: type[T], given: argparse.Namespace, **others: object) -> T:
    """Return a request of this kind. Each field has the value of its name in `others`, or else in the arguments."""
    names = [each.name for each in fields(kind)]  # type: ignore[arg-type]
    return kind(**{name: others[name] if name in others else getattr(given, name) for name in names})


def _check_fewer(parser: argparse.ArgumentParser, given: argparse.Namespace) -> None:
    if not given.seams:
        parser.error("--cut fewer leaves out some seams of --seams: give --seams")
    for option in ("together", "piece", "count", "longest", "narrowest", "no_seam"):
        if getattr(given, option) not in (None, ""):
            parser.error(f"--cut fewer makes no cuts: use it without --{option.replace('_', '-')}")


def _clashes(requests: Sequence[Request]) -> dict[int, str]:
    """Return a sentence for each request that conflicts with another request, by its index.

    Two requests conflict if one would write a file that the other writes or reads.
    """
    clashes: dict[int, str] = {}
    writers: dict[Path, int] = {}
    for number, request in enumerate(requests):
        folder = request.folder.resolve()
        for path in request.all_paths:
            other = writers.setdefault(folder / path.name, number)
            if other != number:
                sentence = (
                    f'"{requests[other].model}" and "{request.model}" would both write "{path}": rename one, or give '
                    "each an --out of its own."
                )
                clashes.setdefault(other, sentence)
                clashes.setdefault(number, sentence)
    for request in requests:
        for file in request.line_files:
            writer = writers.get(file.resolve())
            if writer is not None:
                sentence = f'The report of "{requests[writer].model}" would overwrite "{file}": give another --out.'
                clashes.setdefault(writer, sentence)
    return clashes


def _length(text: str) -> float:
    match = LENGTH.fullmatch(text.strip())
    if not match or (match[2] and not int(match[2])):
        raise argparse.ArgumentTypeError(f"{text!r} is not a length: give 10mm, 1cm or 3/8in")
    return float(match[1]) / float(match[2] or 1) * MILLIMETERS[match[3]]


def _page(text: str) -> str | float:
    page = _length(text) if LENGTH.fullmatch(text) and text not in ("36in", "24in") else text
    try:
        roll_width(page)
    except FlattenError as error:
        raise argparse.ArgumentTypeError(error.message) from error
    return page


def _formats(text: str) -> tuple[str, ...]:
    formats = tuple(dict.fromkeys(text.lower().split(",")))
    known = [suffix[1:] for suffix in FORMATS]
    for each in formats:
        if each not in known:
            raise argparse.ArgumentTypeError(f"{each!r} is not a format: give some of {','.join(known)}")
    return formats


def _cloth(text: str) -> tuple[float, float | None]:
    """Return width and length of the fabric in millimeters. The length of a roll is None."""
    match = SHEET.fullmatch(text.strip())
    if match:
        return _length(f"{match[1]}{match[3]}"), _length(f"{match[2]}{match[3]}")
    return _length(text), None


def _stretch(text: str) -> tuple[float, float]:
    """Return the stretch across and along the grain, as fractions."""
    match = STRETCH.fullmatch(text.strip())
    if not match:
        raise argparse.ArgumentTypeError(f"{text!r} is not a stretch: give 10% or, across and along the grain, 10%,5%")
    return float(match[1]) / 100, float(match[2] or match[1]) / 100


def _share(text: str) -> float:
    match = re.fullmatch(r"(\d+(?:\.\d*)?)%", text.strip())
    if not match:
        raise argparse.ArgumentTypeError(f"{text!r} is not a percentage: give 5%")
    return float(match[1]) / 100


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number above 0: give 1 or more")
    return int(text)


def _seconds(text: str) -> float:
    if not re.fullmatch(r"\d+(\.\d*)?", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds: give 0 or more")
    return float(text)


def _memory(text: str) -> int:
    match = MEMORY.fullmatch(text.strip())
    if not match or not float(match[1]):
        raise argparse.ArgumentTypeError(f"{text!r} is not an amount of memory: give 500MB or 4GB")
    return round(float(match[1]) * BYTES[match[2]])


def _part(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"(\d+)/(\d+)", text)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError(f"{text!r} is not a part: give 1/20 to 20/20")
    return int(match[1]), int(match[2])
