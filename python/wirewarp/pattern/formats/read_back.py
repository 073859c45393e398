# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the cutting lines from a written file, as a plotter's program would, and compares them with the pattern.

This module shares no code with the writers.
"""

import math
import re
import xml.etree.ElementTree as ElementTree
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..progress import Steps
from ..units import INCH

NUMBER = r"-?[\d.]+"
WORST = 0.02  # millimeters; HPGL rounds by up to 0.0125 mm in each direction, and all other formats are finer

QUARTER_TURNS = [np.linalg.matrix_power(np.array([[0.0, 1.0], [-1.0, 0.0]]), count) for count in range(4)]


def check(found: Iterator[np.ndarray], outlines: Sequence[np.ndarray]) -> Steps[float]:
    """Return the largest error of a point in the file, in millimeters.

    Places and quarter turns of outlines are not compared, because packing changes them. Raises RuntimeError for an
    error above WORST, and for missing or additional outlines.
    """
    waiting = [_normalized(outline) for outline in outlines]
    worst, count = 0.0, 0
    for each in map(_normalized, found):
        yield "reading again", count / max(len(outlines), count + 1)
        off, place = _nearest(each, waiting)
        if off > WORST:
            raise RuntimeError(f"Verification failed: an outline in the file is off by {off:.3f} mm.")
        del waiting[place]
        worst, count = max(worst, off), count + 1
    if waiting:
        raise RuntimeError(f"Verification failed: the file has {count} of {len(outlines)} outlines.")
    return worst


def _nearest(found: np.ndarray, waiting: Sequence[np.ndarray]) -> tuple[float, int]:
    """Return the distance to the first outline within WORST, and its index. If no outline is so near, return the
    distance and the index of the nearest outline."""
    best, place = math.inf, -1
    for number, outline in enumerate(waiting):
        if len(outline) == len(found):
            off = min(float(np.linalg.norm(found - outline @ turn, axis=1).max()) for turn in QUARTER_TURNS)
            if off < best:
                best, place = off, number
            if off <= WORST:
                break
    return best, place


def _normalized(points: np.ndarray) -> np.ndarray:
    points = points[:-1] if len(points) > 1 and np.array_equal(points[0], points[-1]) else points
    return points - points.mean(axis=0)


def read_svg(path: Path) -> Iterator[np.ndarray]:
    root = ElementTree.parse(path).getroot()
    unit = 1.0 if root.get("viewBox") else INCH / 96
    for element in root.iter():
        if element.get("data-role") in ("cut", "inner_cut"):
            yield _pairs(re.findall(NUMBER, element.get("d", ""))) * (unit, -unit)


def read_pdf(path: Path) -> Iterator[np.ndarray]:
    for stream in re.findall(rb"/Subtype /Form.*?stream\n(.*?)\nendstream", path.read_bytes(), re.DOTALL):
        content = zlib.decompress(stream).decode("latin-1")
        for layer in re.findall(r"/LCut BDC(.*?)EMC", content, re.DOTALL):
            for line in re.findall(rf"({NUMBER} {NUMBER} m\n(?:{NUMBER} {NUMBER} l\n)*)", layer):
                yield _pairs(re.findall(NUMBER, line))


def read_dxf(path: Path) -> Iterator[np.ndarray]:
    lines = path.read_text(encoding="ascii").split("\n")
    tags = [(int(code), value.strip()) for code, value in zip(lines[::2], lines[1::2], strict=False) if code.strip()]
    unit = INCH if any(value.upper() == "UNITS: ENGLISH" for _, value in tags) else 1.0
    block, entity, layer = "", "", ""
    points: list[str] = []
    for code, value in [*tags, (0, "EOF")]:
        if code == 0:
            if value == "SEQEND" and layer in ("1", "11", "CUT") and not block.startswith("CONTROL_"):
                yield _pairs(points) * unit
            points = [] if value == "POLYLINE" else points
            entity = value
        elif code == 2 and entity == "BLOCK":
            block = value
        elif code == 8:
            layer = value
        elif code in (10, 20) and entity == "VERTEX":
            points.append(value)


def read_plt(path: Path) -> Iterator[np.ndarray]:
    pen = ""
    points: list[str] = []
    for command in [*path.read_text(encoding="ascii").split(";"), "PU"]:
        word, numbers = command.strip()[:2], re.findall(r"-?\d+", command)
        if word in ("PU", "SP") and len(points) > 2 and pen == "1":
            yield _pairs(points) / 40
        if word == "SP":
            pen = numbers[0]
        points = numbers if word == "PU" else points + numbers if word == "PD" else []


def _pairs(numbers: Sequence[str]) -> np.ndarray:
    return np.array([float(number) for number in numbers]).reshape(-1, 2)
