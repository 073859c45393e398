# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a table for spreadsheets, in one unit."""

import csv
import io
from collections.abc import Iterator

from ..words import LengthText
from .names import open_edges, piece_name, piece_names, pieces_of_wires, seam_name, side_names
from .rows import asked_ease

DIGITS = 6  # after the point


def report_csv(report: dict, units: LengthText) -> str:
    """A header, and a line for each side of a seam, each wire, each open stretch of outline and each piece."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_header(units))
    for kind, name, piece, *figures in _rows(report, units):
        writer.writerow([kind, _plain(name), _plain(piece), *figures])
    return text.getvalue()


def _header(units: LengthText) -> list[str]:
    lengths, areas = (f" ({unit})" if unit else "" for unit in (units.unit, units.area_unit))
    return [
        "Kind",
        "Name",
        "Piece",
        f"Length on model{lengths}",
        f"Flat length{lengths}",
        f"Difference{lengths}",
        "Difference (%)",
        "Tolerance (%)",
        f"Area on model{areas}",
        f"Flat area{areas}",
        "Area difference (%)",
        "Largest stretch (%)",
        "Largest ease (%)",
        "Kept",
        "Asked ease (%)",
    ]


def _rows(report: dict, units: LengthText) -> Iterator[list[str]]:
    for seam in report["seams"]:
        sides = zip(seam["pieces"], side_names(report, seam), strict=True)
        for side, (piece, label) in enumerate(sides):
            name, place = seam_name(report, seam), piece_name(report, piece)
            kind = "Dart" if seam["is_dart"] else "Seam"
            yield _length_row(kind, name if label == place else f"{name}, {label}", place, seam, side, units)
    pieces = pieces_of_wires(report)
    for wire in report["wires"]:
        yield _length_row("Wire", wire["name"], piece_names(report, pieces[wire["wire"]]), wire, 0, units)
    for name, piece, chain in open_edges(report):
        yield _length_row("Open edge", name, piece_name(report, piece), chain, 0, units)
    for piece in report["pieces"]:
        yield _piece_row(piece_name(report, piece["index"]), piece, units)


def _length_row(kind: str, name: str, piece: str, entry: dict, side: int, units: LengthText) -> list[str]:
    lengths = (entry["length_3d"], entry["length_2d"][side], entry["difference"][side])
    return [
        kind,
        name,
        piece,
        *(_number(length, units.per_blender_unit) for length in lengths),
        _number(entry["percent"][side]),
        _tolerance(entry),
        *[""] * 5,
        _kept(entry),
        _number(asked_ease(entry, side), 100),
    ]


def _piece_row(name: str, piece: dict, units: LengthText) -> list[str]:
    flat = piece["area_2d"] is not None
    return [
        "Piece",
        name,
        name,
        *[""] * 5,
        *(_number(area, units.area_per_blender_unit) for area in (piece["area_3d"], piece["area_2d"])),
        _number(piece["area_2d"] / piece["area_3d"] - 1, 100) if flat else "",
        _number(piece["stretch_max"], 100),
        _number(piece["ease_max"], 100),
        _kept(piece),
        "",
    ]


def _plain(name: str) -> str:
    """As spreadsheets take it for a text, and not for a formula."""
    return f"'{name}" if name.startswith(("=", "+", "-", "@", "\t", "\r")) else name


def _number(value: float | None, factor: float = 1) -> str:
    """Empty where there is none, as without a layout; what rounds to nothing has no sign."""
    if value is None:
        return ""
    text = f"{value * factor:.{DIGITS}f}"
    return text if float(text) else text.removeprefix("-")


def _tolerance(entry: dict) -> str:
    """In percent; seams, outlines and rigid wires have 0."""
    tolerance = entry.get("tolerance", 0)
    return "free" if tolerance == "inf" else f"{100 * tolerance:g}"


def _kept(entry: dict) -> str:
    return "yes" if entry["ok"] else "no"
