# SPDX-License-Identifier: GPL-3.0-or-later
"""The stored report as rows of a table, worst first. No Blender in here."""

import math
from dataclasses import dataclass

from ..cloth import aspect_ratio
from ..tolerance_text import tolerance_text


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
    tolerance: str = ""  # of an elastic or free wire, and what came of it
    at_limit: bool = False
    seam: int | None = None  # for the button that selects it

    @property
    def badness(self) -> float:
        """Failures first, then the largest difference in percent."""
        worst = max((abs(side.percent) if side.percent is not None else math.inf) for side in self.sides)
        return math.inf if not self.ok else round(worst, 6)  # rounding errors do not make an order


def seam_rows(report: dict) -> list[ReportRow]:
    rows = []
    for seam in report["seams"]:
        pieces = [report["pieces"][piece]["name"] for piece in seam["pieces"]]
        name = f"Seam {seam['index'] + 1}, {', '.join(dict.fromkeys(pieces))}"
        sides = range(1, len(pieces) + 1)
        labels = [f"Side {k}" for k in sides] if len(set(pieces)) == 1 else pieces
        rows.append(ReportRow(name, seam["ok"], _sides(seam, labels), seam=seam["index"]))
    return _worst_first(rows)


def wire_rows(report: dict) -> list[ReportRow]:
    """Whole wires, and under each the pieces its parts lie in."""
    rows = []
    for wire in report["wires"]:
        places = [
            piece["name"] for piece in report["pieces"] for part in piece["wires"] if part["wire"] == wire["wire"]
        ]
        name = ", ".join([wire["name"], *dict.fromkeys(places)])
        rows.append(
            ReportRow(name, wire["ok"], _sides(wire, [""]), _tolerance(report["method"], wire), wire["at_limit"])
        )
    return _worst_first(rows)


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
    return f"at its limit of {text}" if wire["at_limit"] else f"within {text}"


def outline_rows(report: dict) -> list[ReportRow]:
    """Stretches of outline that are no seam's side: hems, necklines, armholes."""
    rows = []
    for piece in report["pieces"]:
        free = [chain for chain in piece["outline"] if chain["seam"] is None]
        for number, chain in enumerate(free, start=1):
            name = f"{piece['name']}, open edge {number}"
            rows.append(ReportRow(name, chain["ok"], _sides(chain, [""])))
    return _worst_first(rows)


def helper_rows(report: dict) -> list[ReportRow]:
    """The wires that were added, numbered through all pieces; they may take any length."""
    helpers = [(piece["name"], wire) for piece in report["pieces"] for wire in piece.get("helper_wires", [])]
    return [
        ReportRow(f"Helper {number}, {name}", True, _sides(wire, [""]))
        for number, (name, wire) in enumerate(helpers, start=1)
    ]


def piece_rows(report: dict) -> list[tuple[int, bool, list[str]]]:
    """(index, ok, lines) of each piece, failed ones first, then by their aspect ratio."""
    rows = []
    for piece in sorted(report["pieces"], key=lambda piece: (piece["ok"], -aspect_ratio(piece))):
        lines = [f"{piece['name']}, {piece['faces']} faces"]
        if piece["has_layout"]:
            lines.append(f"Distortion {piece['arap_energy']:.4f}")
            lines.append(f"Aspect ratio up to {aspect_ratio(piece):.3f}")
            deviation = math.degrees(piece["angle_deviation_max"])
            lines.append(f"Angles up to {deviation:.1f}° off")
        rows.append((piece["index"], piece["ok"], lines))
    return rows


def _sides(entry: dict, labels: list[str]) -> list[Side]:
    values = zip(labels, entry["length_2d"], entry["difference"], entry["percent"], strict=True)
    return [Side(label, entry["length_3d"], *rest) for label, *rest in values]


def _worst_first(rows: list[ReportRow]) -> list[ReportRow]:
    return sorted(rows, key=lambda row: -row.badness)
