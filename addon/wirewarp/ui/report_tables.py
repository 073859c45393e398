# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panel shows of a report, made once a report: drawing the sidebar must not depend on the size of it."""

from dataclasses import dataclass

from .report_rows import PieceRow, ReportRow, helper_rows, outline_rows, piece_rows, seam_rows, wire_rows
from .verdict import VerdictLine, verdict


@dataclass(frozen=True)
class ReportTables:
    verdict: list[VerdictLine]
    seams: list[ReportRow]
    wires: list[ReportRow]
    outlines: list[ReportRow]
    helpers: list[ReportRow]
    pieces: list[PieceRow]


_kept: list[tuple[dict, list[str], ReportTables]] = []  # of the last two reports: of the pieces, and of a failure


def tables_of(report: dict) -> ReportTables:
    """Of a report that was shown last, as long as its pieces and wires keep their names."""
    names = [entry["name"] for entry in report["pieces"] + report["wires"]]
    for shown, known, tables in _kept:
        if shown is report and known == names:
            return tables
    tables = ReportTables(
        verdict=verdict(report),
        seams=seam_rows(report),
        wires=wire_rows(report),
        outlines=outline_rows(report),
        helpers=helper_rows(report),
        pieces=piece_rows(report),
    )
    _kept[:] = [(report, names, tables), *_kept[:1]]
    return tables
