# SPDX-License-Identifier: GPL-3.0-or-later
"""The stored report as rows of a table, worst first."""

import math
from dataclasses import dataclass

from ..words import tolerance_text
from .cloth import aspect_ratio, is_strained, largest
from .names import joined_pieces, open_edges, piece_name, piece_names, pieces_of_wires, side_names
from .verdict import VerdictLine, verdict


@dataclass(frozen=True)
class Side:
    label: str
    length_3d: float
    length_2d: float | None  # None: no layout
    difference: float | None
    percent: float | None


@dataclass(frozen=True)
class ReportRow:
    name: str
    ok: bool
    sides: list[Side]
    what: str | None = None  # for the button that selects it
    index: int = 0
    note: str = ""  # of a seam: what it joins; of a wire: where it lies, its tolerance and what came of that
    seam_id: int = 0  # of a seam, by which its name is found in the list where it can be changed
    at_limit: bool = False

    @property
    def badness(self) -> float:
        """Failures first, then the largest difference in percent."""
        worst = max((abs(side.percent) if side.percent is not None else math.inf) for side in self.sides)
        return math.inf if not self.ok else round(worst, 6)  # rounding errors do not make an order


@dataclass(frozen=True)
class PieceRow:
    index: int
    name: str
    ok: bool
    is_strained: bool  # lengths are kept, but hardly any cloth can follow
    has_layout: bool
    area_3d: float
    area_2d: float | None
    stretch: float  # largest, as shares of the flat length; inf where a face has no area
    ease: float

    @property
    def strain(self) -> float:
        """The greater of both."""
        return max(self.stretch, self.ease)


def seam_rows(report: dict) -> list[ReportRow]:
    return _worst_first([
        ReportRow(
            name=seam["name"],
            ok=seam["ok"],
            sides=_sides(seam, side_names(report, seam)),
            what="SEAM",
            index=seam["index"],
            note=joined_pieces(report, seam),
            seam_id=seam["seam_id"],
        )
        for seam in report["seams"]
    ])  # fmt: skip


def wire_rows(report: dict) -> list[ReportRow]:
    """Whole wires, with the pieces that their parts lie in."""
    pieces = pieces_of_wires(report)
    return _worst_first([
        ReportRow(
            name=wire["name"],
            ok=wire["ok"],
            sides=_sides(wire, ["Flat"]),
            what="WIRE",
            index=index,
            note=_note(piece_names(report, pieces[wire["wire"]]), _tolerance(report["method"], wire)),
            at_limit=wire["at_limit"],
        )
        for index, wire in enumerate(report["wires"])
    ])  # fmt: skip


def _note(places: str, tolerance: str) -> str:
    return "; ".join(filter(None, [places, tolerance]))


def _tolerance(method: str, wire: dict) -> str:
    text = tolerance_text(float(wire["tolerance"]))
    if text == "rigid":
        return ""
    if method == "wirewarping":
        return f"{text}, kept rigid"
    if text == "free" or wire["length_2d"] == [None]:
        return text
    if not wire["ok"]:
        return f"outside {text}"
    if not wire["at_limit"]:
        return f"within {text}"
    as_a_whole = any(abs(percent) >= 99 * float(wire["tolerance"]) for percent in wire["percent"])
    return f"at its limit of {text}" if as_a_whole else f"a part is at its limit of {text}"


def outline_rows(report: dict) -> list[ReportRow]:
    """Stretches of outline that are no seam's side: hems, necklines, armholes."""
    return _worst_first([
        ReportRow(name, chain["ok"], _sides(chain, ["Flat"]), "OUTLINE", index)
        for index, (name, _, chain) in enumerate(open_edges(report))
    ])  # fmt: skip


def piece_rows(report: dict) -> list[PieceRow]:
    """Failed ones first, then by how much their cloth is strained."""
    return [
        PieceRow(
            index=piece["index"],
            name=piece_name(report, piece["index"]),
            ok=piece["ok"],
            is_strained=is_strained(piece),
            has_layout=piece["has_layout"],
            area_3d=piece["area_3d"],
            area_2d=piece["area_2d"],
            stretch=largest(piece["stretch_max"]),
            ease=largest(piece["ease_max"]),
        )
        for piece in sorted(report["pieces"], key=lambda piece: (piece["ok"], -aspect_ratio(piece)))
    ]


def merged(sides: list[Side], texts: list[tuple[str, ...]]) -> list[tuple[str, tuple[str, ...]]]:
    """(label, text) of the sides of a seam, put together if all read the same: "Both sides"."""
    if len(sides) > 1 and len(set(texts)) == 1:
        return [("Both sides" if len(sides) == 2 else f"All {len(sides)} sides", texts[0])]
    return [(side.label, text) for side, text in zip(sides, texts, strict=True)]


def largest_difference(rows: list[ReportRow]) -> float | None:
    """Of all sides that have a layout, without its sign."""
    differences = [side.difference for row in rows for side in row.sides]
    return max((abs(difference) for difference in differences if difference is not None), default=None)


def _sides(entry: dict, labels: list[str]) -> list[Side]:
    values = zip(labels, entry["length_2d"], entry["difference"], entry["percent"], strict=True)
    return [Side(label, entry["length_3d"], *rest) for label, *rest in values]


def _worst_first(rows: list[ReportRow]) -> list[ReportRow]:
    return sorted(rows, key=lambda row: -row.badness)


@dataclass(frozen=True)
class ReportTables:
    verdict: list[VerdictLine]
    seams: list[ReportRow]
    wires: list[ReportRow]
    outlines: list[ReportRow]
    pieces: list[PieceRow]


_kept: list[tuple[dict, list[str], ReportTables]] = []  # of the last two reports: of the pieces, and of a failure


def tables_of(report: dict) -> ReportTables:
    """Of a report that was shown last, as long as its pieces and wires keep their names."""
    names = [entry["name"] for entry in report["pieces"] + report["wires"] + report["seams"]]
    for shown, known, tables in _kept:
        if shown is report and known == names:
            return tables
    tables = ReportTables(
        verdict=verdict(report),
        seams=seam_rows(report),
        wires=wire_rows(report),
        outlines=outline_rows(report),
        pieces=piece_rows(report),
    )
    _kept[:] = [(report, names, tables), *_kept[:1]]
    return tables
