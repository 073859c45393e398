# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the rows of tables from a report, the worst row first."""

import math
from dataclasses import dataclass

from .model import Chain, Lengths, Piece, Report, Seam, Wire
from .names import joined_pieces, open_edges, piece_names, pieces_of_wires, side_names
from .verdict import Verdict, verdict
from .words import ease_text, tolerance_text

LEAST = 5e-5  # as a fraction; smaller eases are not shown


@dataclass(frozen=True)
class Side:
    label: str
    length_3d: float | None
    length_2d: float | None  # None without a layout
    difference: float | None
    percent: float | None
    length_asked: float | None  # target length; None without a layout

    @property
    def off(self) -> float | None:
        """Return the flat length minus the target length; None without a layout."""
        return None if self.length_2d is None or self.length_asked is None else self.length_2d - self.length_asked


@dataclass(frozen=True)
class ReportRow:
    name: str
    ok: bool
    sides: list[Side]
    what: str | None = None  # kind of the entry for elements_of(); None if nothing can be selected
    index: int = 0
    note: str = ""  # pieces and change of a seam; pieces, tolerance and result of a wire
    seam_id: int = 0  # id of the seam in Blender; 0 elsewhere
    at_limit: bool = False

    @property
    def badness(self) -> float:
        """Return how bad the row is: inf for a failure, otherwise the largest relative difference from the target."""
        worst = max(
            math.inf if side.off is None or not side.length_3d else abs(side.off) / side.length_3d
            for side in self.sides
        )
        return math.inf if not self.ok else round(worst, 8)  # rounded, so that rounding errors do not affect the order


def seam_rows(report: Report) -> list[ReportRow]:
    return _worst_first([
        ReportRow(
            name=seam.name,
            ok=seam.ok,
            sides=_sides(seam, side_names(report, seam)),
            what="SEAM",
            index=seam.index,
            note=_note(joined_pieces(report, seam.pieces), _variation(seam)),
            seam_id=seam.seam_id,
        )
        for seam in report.seams
    ])  # fmt: skip


def wire_rows(report: Report) -> list[ReportRow]:
    """Return the rows of whole wires. Their notes name the pieces that contain parts of the wire."""
    pieces = pieces_of_wires(report)
    return _worst_first([
        ReportRow(
            name=wire.name,
            ok=wire.ok,
            sides=_sides(wire, ["Flat"]),
            what="WIRE",
            index=index,
            note=_note(piece_names(report, pieces[wire.wire]), _tolerance(report.method, wire)),
            at_limit=wire.at_limit,
        )
        for index, wire in enumerate(report.wires)
    ])  # fmt: skip


def outline_rows(report: Report) -> list[ReportRow]:
    """Return the rows of open edges, such as hems and necklines."""
    return _worst_first([
        ReportRow(name, chain.ok, _sides(chain, ["Flat"]), "OUTLINE", index, _ease(chain))
        for index, (name, _, chain) in enumerate(open_edges(report))
    ])  # fmt: skip


def piece_rows(report: Report) -> list[Piece]:
    """Return the pieces: first failed pieces, then the pieces with the largest excess over the fabric's stretch."""
    return sorted(report.pieces, key=lambda piece: (piece.ok, -piece.excess))


def _note(places: str, tolerance: str) -> str:
    return "; ".join(filter(None, [places, tolerance]))


def _tolerance(method: str, wire: Wire) -> str:
    text, ease = tolerance_text(wire.tolerance), wire.asked_ease() or 0.0
    if text == "rigid":
        return _ease(wire)
    if abs(ease) >= LEAST and text != "free":
        text = f"{text} about {ease_text(ease)}"
    if method == "wirewarping":
        return f"{text}, kept rigid"
    (flat,) = wire.length_2d
    if text == "free" or flat is None or not wire.length_3d:
        return text
    if not wire.ok:
        return f"outside {text}"
    if not wire.at_limit:
        return f"within {text}"
    share = flat / ((1 + ease) * wire.length_3d) - 1
    as_a_whole = abs(share) * (1 + wire.ease) >= 0.99 * wire.tolerance
    return f"at its limit of {text}" if as_a_whole else f"a part is at its limit of {text}"


def merged(sides: list[Side], texts: list[tuple[str, ...]]) -> list[tuple[str, tuple[str, ...]]]:
    """Return pairs of label and texts for the sides of a seam. If all texts are equal, there is one pair with the label
    "Both sides" or "All 3 sides"."""
    if len(sides) > 1 and len(set(texts)) == 1:
        return [("Both sides" if len(sides) == 2 else f"All {len(sides)} sides", texts[0])]
    return [(side.label, text) for side, text in zip(sides, texts, strict=True)]


def largest_difference(rows: list[ReportRow]) -> float | None:
    """Return the largest absolute difference from the target length; None if no side has a layout."""
    differences = [side.off for row in rows for side in row.sides]
    return max((abs(difference) for difference in differences if difference is not None), default=None)


def _sides(entry: Lengths, labels: list[str]) -> list[Side]:
    columns = zip(labels, entry.length_2d, entry.difference, entry.percent, entry.length_asked, strict=True)
    return [Side(label, entry.length_3d, *rest) for label, *rest in columns]


def _ease(entry: Wire | Chain) -> str:
    ease = entry.asked_ease() or 0.0
    return f"ease {ease_text(ease)}" if abs(ease) >= LEAST else ""


def _variation(seam: Seam) -> str:
    variation = seam.variation or 0.0
    return f"{ease_text(variation)} on all sides" if abs(variation) >= LEAST else ""


def _worst_first(rows: list[ReportRow]) -> list[ReportRow]:
    return sorted(rows, key=lambda row: -row.badness)


@dataclass(frozen=True)
class ReportTables:
    verdict: Verdict
    seams: list[ReportRow]
    wires: list[ReportRow]
    outlines: list[ReportRow]
    pieces: list[Piece]


def tables_of(report: Report) -> ReportTables:
    return ReportTables(
        verdict=verdict(report),
        seams=seam_rows(report),
        wires=wire_rows(report),
        outlines=outline_rows(report),
        pieces=piece_rows(report),
    )
