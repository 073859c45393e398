# SPDX-License-Identifier: GPL-3.0-or-later
"""The stored report as rows of a table, worst first."""

import math
from dataclasses import dataclass

from ..words import ease_text, tolerance_text
from .cloth import aspect_ratio, is_strained, largest
from .names import joined_pieces, open_edges, piece_name, piece_names, pieces_of_wires, side_names
from .verdict import VerdictLine, verdict

LEAST = 5e-5  # of eases: less is shown as none


@dataclass(frozen=True)
class Side:
    label: str
    length_3d: float
    length_2d: float | None  # None: no layout
    difference: float | None
    percent: float | None
    length_asked: float | None  # None: that is not known without a layout

    @property
    def off(self) -> float | None:
        """By how much it is longer than it was to be."""
        return None if self.length_2d is None or self.length_asked is None else self.length_2d - self.length_asked


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
        worst = max(math.inf if side.off is None else abs(side.off) / side.length_3d for side in self.sides)
        return math.inf if not self.ok else round(worst, 8)  # rounding errors do not make an order


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
    threads: dict | None = None  # of a cloth: see threads.threads_of

    @property
    def strain(self) -> float:
        """The greatest."""
        return max(self.threads["across"], self.threads["along"]) if self.threads else max(self.stretch, self.ease)


def seam_rows(report: dict) -> list[ReportRow]:
    return _worst_first([
        ReportRow(
            name=seam["name"],
            ok=seam["ok"],
            sides=_sides(seam, side_names(report, seam)),
            what="SEAM",
            index=seam["index"],
            note=_note(joined_pieces(report, seam), _variation(seam)),
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
    tolerance = float(wire["tolerance"])
    text, ease = tolerance_text(tolerance), asked_ease(wire) or 0.0
    if text == "rigid":
        return _ease(wire)
    if abs(ease) >= LEAST and text != "free":
        text = f"{text} about {ease_text(ease)}"
    if method == "wirewarping":
        return f"{text}, kept rigid"
    if text == "free" or wire["length_2d"] == [None]:
        return text
    if not wire["ok"]:
        return f"outside {text}"
    if not wire["at_limit"]:
        return f"within {text}"
    share = wire["length_2d"][0] / ((1 + ease) * wire["length_3d"]) - 1
    as_a_whole = abs(share) * (1 + wire.get("ease", 0.0)) >= 0.99 * tolerance
    return f"at its limit of {text}" if as_a_whole else f"a part is at its limit of {text}"


def outline_rows(report: dict) -> list[ReportRow]:
    """Stretches of outline that are no seam's side: hems, necklines, armholes."""
    return _worst_first([
        ReportRow(name, chain["ok"], _sides(chain, ["Flat"]), "OUTLINE", index, _ease(chain))
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
            threads=piece.get("threads"),
        )
        for piece in sorted(report["pieces"], key=lambda piece: (piece["ok"], -aspect_ratio(piece)))
    ]


def merged(sides: list[Side], texts: list[tuple[str, ...]]) -> list[tuple[str, tuple[str, ...]]]:
    """(label, text) of the sides of a seam, put together if all read the same: "Both sides"."""
    if len(sides) > 1 and len(set(texts)) == 1:
        return [("Both sides" if len(sides) == 2 else f"All {len(sides)} sides", texts[0])]
    return [(side.label, text) for side, text in zip(sides, texts, strict=True)]


def largest_difference(rows: list[ReportRow]) -> float | None:
    """From what they were to be, of all sides that have a layout, without its sign."""
    differences = [side.off for row in rows for side in row.sides]
    return max((abs(difference) for difference in differences if difference is not None), default=None)


def _sides(entry: dict, labels: list[str]) -> list[Side]:
    asked = [length_asked(entry, side) for side in range(len(labels))]
    columns = zip(labels, entry["length_2d"], entry["difference"], entry["percent"], asked, strict=True)
    return [Side(label, entry["length_3d"], *rest) for label, *rest in columns]


def length_asked(entry: dict, side: int = 0) -> float | None:
    """Of an entry of the report; those that were made before there were eases ask for the length on the model."""
    return entry["length_asked"][side] if "length_asked" in entry else entry["length_3d"]


def asked_ease(entry: dict, side: int = 0) -> float | None:
    """By how much a line was to be longer than on the model, as a fraction; that of worn cloth is below 0."""
    length = length_asked(entry, side)
    return length / entry["length_3d"] - 1 if length and entry["length_3d"] else None


def _ease(entry: dict) -> str:
    ease = asked_ease(entry) or 0.0
    return f"ease {ease_text(ease)}" if abs(ease) >= LEAST else ""


def _variation(seam: dict) -> str:
    variation = seam.get("variation") or 0.0
    return f"{ease_text(variation)} on all sides" if abs(variation) >= LEAST else ""


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
