# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be asked for on the command line."""

import argparse
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from .._errors import FlattenError
from ..pattern.nest_items import Grain
from ..pattern.papers import roll_width
from ..pattern.write import WRITERS

MILLIMETERS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
LENGTH = re.compile(r"(\d+(?:\.\d*)?)(?:/(\d+))?\s*(mm|cm|m|in)")
SHEET = re.compile(r"(\d+(?:\.\d*)?)x(\d+(?:\.\d*)?)\s*(mm|cm|m|in)")
GRAINS: dict[str, Grain] = {
    "one-way": "one way",
    "both-ways": "both ways",
    "free": "free",
}  # as Pattern.nested knows them
FROM_MODEL = ("uv", "sharp")


@dataclass(frozen=True)
class MarkerRequest:
    """What the pieces are cut from, in millimeters, and how; see Pattern.nested."""

    width: float
    length: float | None
    gap: float
    grain: Grain
    times: int
    seconds: float


@dataclass(frozen=True)
class Request:
    """What is done with one model. Lengths are in millimeters."""

    model: Path
    folder: Path
    seams: str  # "uv", "sharp", a path, or "" for none
    wires: str  # a path, or "" for none
    formats: tuple[str, ...]
    page: str | float
    allowance: float
    hem: float | None
    unit: str
    imperial: bool
    marker: MarkerRequest | None
    picture: bool
    resume: bool

    @property
    def report_path(self) -> Path:
        return self.folder / f"{self.model.stem}.json"

    def pattern_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}.{kind}"

    @property
    def picture_path(self) -> Path:
        """Not NAME.png, which many models have as their texture."""
        return self.folder / f"{self.model.stem}-strain.png"

    def marker_path(self, kind: str) -> Path:
        return self.folder / f"{self.model.stem}-marker.{kind}"

    @property
    def line_files(self) -> list[Path]:
        """The files that seams and wires are read from."""
        return [Path(name) for name in (self.seams, self.wires) if name not in ("", *FROM_MODEL)]


@dataclass(frozen=True)
class Arguments:
    requests: list[Request]
    jobs: int


def parsed(words: Sequence[str]) -> Arguments:
    """Ends the program with code 2 and a sentence where they cannot be meant."""
    parser = argparse.ArgumentParser(prog="python -m wirewarp", description="Flat patterns with exact lengths.")
    command = parser.add_subparsers(required=True, metavar="flatten").add_parser(
        "flatten",
        help="flatten models, and write reports and patterns",
        description="Flattens models (OBJ, PLY, STL, glTF) and writes for each a report and a pattern. Prints one line "
        "of JSON for each. The exit code is 0 if all are ready to cut, 1 if a piece is not, 2 if a model is refused.",
    )
    command.add_argument("models", nargs="+", metavar="MODEL", type=Path)
    command.add_argument("--out", required=True, metavar="DIR", type=Path, help="folder for what is written")
    command.add_argument(
        "--seams",
        default="",
        metavar="uv|sharp|FILE",
        help="around UV islands, sharp edges, or of a JSON file",
    )
    command.add_argument("--wires", default="", metavar="FILE", help="JSON file with wires")
    command.add_argument(
        "--format", default="pdf,svg", metavar="F,F", type=_formats, help="of pdf, svg, dxf, plt (pdf,svg)"
    )
    command.add_argument("--page", default="a4", type=_page, help="paper of PDF: a4, letter, a0, 36in, 900mm, ... (a4)")
    command.add_argument("--allowance", default="10mm", type=_length, help="outside of seams: 10mm, 1cm, 3/8in (10mm)")
    command.add_argument("--hem", type=_length, help="outside of edges that are not sewn (as --allowance)")
    command.add_argument("--unit", choices=MILLIMETERS, default="m", help="what a model has its coordinates in (m)")
    command.add_argument("--imperial", action="store_true", help="inches in texts and squares to measure")
    command.add_argument(
        "--marker", type=_cloth, metavar="WIDTH|WxL", help="pieces nested on a roll, 1400mm, or on sheets, 60x90cm"
    )
    command.add_argument("--gap", type=_length, default="5mm", help="between the pieces of a marker (5mm)")
    command.add_argument("--grain", choices=GRAINS, default="one-way", help="how pieces of a marker may lie (one-way)")
    command.add_argument("--times", type=_count, default=1, metavar="N", help="how often a marker has the pattern (1)")
    command.add_argument("--seconds", type=_seconds, default=10.0, metavar="S", help="of search for a marker (10)")
    command.add_argument("--picture", action="store_true", help="also a PNG of the flat pieces, colored by strain")
    command.add_argument("--jobs", type=_count, default=1, metavar="N", help="models at a time (1)")
    command.add_argument("--resume", action="store_true", help="leave out what was done before and has not changed")
    given = parser.parse_args(words)
    for name, count in Counter(model.stem for model in given.models).items():
        if count > 1:
            command.error(f'{count} models are called "{name}", and would write the same files: give them one by one')
    marker = None
    if given.marker:
        width, length = given.marker
        marker = MarkerRequest(width, length, given.gap, GRAINS[given.grain], given.times, given.seconds)
    requests = [
        Request(
            model=model,
            folder=given.out,
            seams=given.seams,
            wires=given.wires,
            formats=given.format,
            page=given.page,
            allowance=given.allowance,
            hem=given.hem,
            unit=given.unit,
            imperial=given.imperial,
            marker=marker,
            picture=given.picture,
            resume=given.resume,
        )
        for model in given.models
    ]
    for request in requests:
        for file in request.line_files:
            if file.resolve() == request.report_path.resolve():
                command.error(f'the report of "{request.model}" would overwrite "{file}": give another --out')
    return Arguments(requests, given.jobs)


def _length(text: str) -> float:
    match = LENGTH.fullmatch(text.strip())
    if not match or (match[2] and not int(match[2])):
        raise argparse.ArgumentTypeError(f"{text!r} is no length: give 10mm, 1cm or 3/8in")
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
    known = [suffix[1:] for suffix in WRITERS]
    for each in formats:
        if each not in known:
            raise argparse.ArgumentTypeError(f"{each!r} is no format: give some of {','.join(known)}")
    return formats


def _cloth(text: str) -> tuple[float, float | None]:
    """Width, and length of sheets."""
    match = SHEET.fullmatch(text.strip())
    if match:
        return _length(f"{match[1]}{match[3]}"), _length(f"{match[2]}{match[3]}")
    return _length(text), None


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of them: give 1 or more")
    return int(text)


def _seconds(text: str) -> float:
    if not re.fullmatch(r"\d+(\.\d*)?", text):
        raise argparse.ArgumentTypeError(f"{text!r} is no number of seconds: give 0 or more")
    return float(text)
