# SPDX-License-Identifier: GPL-3.0-or-later
"""The stored report as rows of a table, worst first."""

import math
from collections.abc import Sequence
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
    asked: float = 0.0  # by how much it was to be longer than on the model, in percent

    @property
    def off(self) -> float | None:
        """By how much it is longer than it was to be."""
        return None if self.difference is None else self.difference - self.asked / 100 * self.length_3d


@dataclass(frozen=True)
class EasedSide:
    """A side of a seam that is longer, or shorter, than what it is sewn to."""

    label: str
    ease: float  # as a fraction
    length: float  # by so much, in Blender units


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
    eased: Sequence[EasedSide] = ()  # of a seam

    @property
    def badness(self) -> float:
        """Failures first, then the largest difference in percent."""
        worst = max((abs(side.percent - side.asked) if side.percent is not None else math.inf) for side in self.sides)
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
            sides=_sides(seam, side_names(report, seam), _asked(seam)),
            what="SEAM",
            index=seam["index"],
            note=_note(joined_pieces(report, seam), _variation(seam)),
            seam_id=seam["seam_id"],
            eased=eased_sides(report, seam),
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
            sides=_sides(wire, ["Flat"], [100 * wire.get("ease", 0.0)]),
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
    text, ease = tolerance_text(float(wire["tolerance"])), wire.get("ease", 0.0)
    if text == "rigid":
        return f"ease {ease_text(ease)}" if ease else ""
    if ease and text != "free":
        text = f"{text} about {ease_text(ease)}"
    if method == "wirewarping":
        return f"{text}, kept rigid"
    if text == "free" or wire["length_2d"] == [None]:
        return text
    if not wire["ok"]:
        return f"outside {text}"
    if not wire["at_limit"]:
        return f"within {text}"
    as_a_whole = any(abs(percent - 100 * ease) >= 99 * float(wire["tolerance"]) for percent in wire["percent"])
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


def _sides(entry: dict, labels: list[str], asked: list[float] | None = None) -> list[Side]:
    """asked: of each, 0 where it is None."""
    shares = asked or [0.0] * len(labels)
    columns = zip(labels, entry["length_2d"], entry["difference"], entry["percent"], shares, strict=True)
    return [
        Side(label, entry["length_3d"], length, difference, percent, share)
        for label, length, difference, percent, share in columns
    ]


def _asked(seam: dict) -> list[float]:
    """In percent. Reports that were made before there were eases have none."""
    shared = 1 + (seam.get("variation") or 0.0)
    return [100 * (shared * (1 + (ease or 0.0)) - 1) for ease in seam.get("eases", [0.0] * len(seam["length_2d"]))]


def _variation(seam: dict) -> str:
    variation = seam.get("variation") or 0.0
    return f"{ease_text(variation)} on all sides" if abs(variation) >= LEAST else ""


def eased_sides(report: dict, seam: dict) -> list[EasedSide]:
    """Of a seam of the report; sides that have a layout."""
    if "eases" not in seam:
        return []
    sides = zip(side_names(report, seam), seam["eases"], seam["length_2d"], strict=True)
    return [
        EasedSide(label, ease, length * ease / (1 + ease))
        for label, ease, length in sides
        if ease is not None and length is not None and abs(ease) >= LEAST
    ]


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
