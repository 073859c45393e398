# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a report as a table for spreadsheets, with all lengths in one unit."""

import csv
import io
import math
from collections.abc import Iterator

from .model import Lengths, Piece, Report, WirePart
from .names import open_edges, piece_names, pieces_of_wires, seam_name, side_names
from .words import LengthText

DIGITS = 6  # decimals of lengths: micrometers in a table in meters


def report_csv(report: Report, units: LengthText) -> str:
    """Return a table in CSV: a header, and a row for each side of a seam, each wire, each open edge, and each piece."""
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
        "Stretch (%)",
        "Stretch across (%)",
        "Stretch along (%)",
        "Largest stretch (%)",
        "Largest compression (%)",
        "Kept",
        "Asked ease (%)",
    ]


def _rows(report: Report, units: LengthText) -> Iterator[list[str]]:
    for seam in report.seams:
        for side, (piece, label) in enumerate(zip(seam.pieces, side_names(report, seam), strict=True)):
            name, place = seam_name(report, seam), report.pieces[piece].name
            kind = "Dart" if seam.is_dart else "Seam"
            yield _length_row(kind, name if label == place else f"{name}, {label}", place, seam, side, seam.ok, units)
    pieces = pieces_of_wires(report)
    for wire in report.wires:
        yield _length_row("Wire", wire.name, piece_names(report, pieces[wire.wire]), wire, 0, wire.ok, units)
    for name, index, chain in open_edges(report):
        yield _length_row("Open edge", name, report.pieces[index].name, chain, 0, chain.ok, units)
    for own in report.pieces:
        yield _piece_row(own, units)


def _length_row(
    kind: str, name: str, piece: str, entry: Lengths, side: int, is_kept: bool, units: LengthText
) -> list[str]:
    lengths = (entry.length_3d, entry.length_2d[side], entry.difference[side])
    return [
        kind,
        name,
        piece,
        *(_number(length, units.per_blender_unit) for length in lengths),
        _number(entry.percent[side]),
        _tolerance(entry.tolerance if isinstance(entry, WirePart) else 0.0),
        *[""] * 8,
        _kept(is_kept),
        _number(entry.asked_ease(side), 100),
    ]


def _piece_row(piece: Piece, units: LengthText) -> list[str]:
    flat, model = piece.area_2d, piece.area_3d
    ways = (piece.threads.across, piece.threads.along) if piece.threads else (None, None)
    return [
        "Piece",
        piece.name,
        piece.name,
        *[""] * 5,
        *(_number(area, units.area_per_blender_unit) for area in (model, flat)),
        _number(flat / model - 1, 100) if flat is not None and model else "",
        *(_number(share, 100) for share in (piece.stretch, *ways, piece.stretch_max, piece.ease_max)),
        _kept(piece.ok),
        "",
    ]


def _plain(name: str) -> str:
    """Return the text, with an apostrophe before it if spreadsheets would read it as a formula."""
    return f"'{name}" if name.startswith(("=", "+", "-", "@", "\t", "\r")) else name


def _number(value: float | None, factor: float = 1) -> str:
    """Return the product of value and factor as text. Zero has no sign.

    Return "" if the value is None, for example if the piece has no layout.
    """
    if value is None:
        return ""
    text = f"{value * factor:.{DIGITS}f}"
    return text if float(text) else text.removeprefix("-")


def _tolerance(tolerance: float) -> str:
    """Return the tolerance in percent, or "free". Seams, outlines and rigid wires have the tolerance 0."""
    return "free" if math.isinf(tolerance) else f"{100 * tolerance:g}"


def _kept(ok: bool) -> str:
    return "yes" if ok else "no"
