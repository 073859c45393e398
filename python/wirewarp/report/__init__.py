# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report of a flattening: all lengths, the verdict, hints, and rows for tables.

The Blender add-on and the command line share this code.
"""

from .coarse import COARSE, COARSE_ADVICE
from .csv_table import report_csv
from .elements import Elements, elements_of
from .hints import BEYOND_FABRIC, STRAINED, TORN, TORN_ADVICE, WIRE_AT_LIMIT, torn_hints
from .json_form import ReportError, from_dict, run_to_dict, to_dict
from .make import failure_report, make_report
from .model import METHOD_NAMES, Chain, Hint, Issue, LooserWire, Note, Piece, Report, Seam, Threads, Wire
from .names import hint_text, issue_text, joined_pieces, note_text, open_edges, rename_wires
from .rows import ReportRow, ReportTables, Side, largest_difference, merged, tables_of
from .strain import percent_text
from .verdict import (
    ANY_LIMIT,
    CLOSED_CODE,
    Kind,
    Level,
    Line,
    Verdict,
    as_seen,
    listed,
    place_name,
    verdict,
    with_narrow,
)
from .wording import by_way, needs_text, set_beyond_fabric
from .words import LengthText, counted, ease_text, paragraph, quoted, tolerance_text, wire_text

__all__ = [
    "ANY_LIMIT",
    "CLOSED_CODE",
    "COARSE",
    "COARSE_ADVICE",
    "report_csv",
    "Elements",
    "elements_of",
    "BEYOND_FABRIC",
    "STRAINED",
    "TORN",
    "TORN_ADVICE",
    "WIRE_AT_LIMIT",
    "torn_hints",
    "ReportError",
    "from_dict",
    "run_to_dict",
    "to_dict",
    "failure_report",
    "make_report",
    "METHOD_NAMES",
    "Chain",
    "Hint",
    "Issue",
    "LooserWire",
    "Note",
    "Piece",
    "Report",
    "Seam",
    "Threads",
    "Wire",
    "hint_text",
    "issue_text",
    "joined_pieces",
    "note_text",
    "open_edges",
    "rename_wires",
    "ReportRow",
    "ReportTables",
    "Side",
    "largest_difference",
    "merged",
    "tables_of",
    "percent_text",
    "Kind",
    "Level",
    "Line",
    "Verdict",
    "as_seen",
    "listed",
    "place_name",
    "verdict",
    "with_narrow",
    "by_way",
    "needs_text",
    "set_beyond_fabric",
    "LengthText",
    "counted",
    "ease_text",
    "paragraph",
    "quoted",
    "tolerance_text",
    "wire_text",
]
