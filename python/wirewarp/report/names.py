# SPDX-License-Identifier: GPL-3.0-or-later
"""Returns names of the entries of a report, for panels, sentences and tables."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain

from .model import Chain, Hint, Issue, Note, Report, Seam


def piece_names(report: Report, indices: Iterable[int]) -> str:
    """Return the names of pieces, each once, such as "Front, Back"."""
    return ", ".join(report.pieces[index].name for index in dict.fromkeys(indices))


def joined_pieces(report: Report, pieces: Iterable[int]) -> str:
    """Return the names of the pieces that a seam joins, such as "Front – Back"."""
    return " – ".join(report.pieces[index].name for index in dict.fromkeys(pieces))


def seam_name(report: Report, seam: Seam) -> str:
    """Return the name of a seam with its pieces, such as "Seam 3: Front – Back" or "Dart 4: Front"."""
    return f"{seam.name}: {joined_pieces(report, seam.pieces)}"


def side_names(report: Report, seam: Seam) -> list[str]:
    """Return a name for each side of a seam: the name of its piece, or "Side 1" if a piece has several sides."""
    if len(set(seam.pieces)) == len(seam.pieces):
        return [report.pieces[piece].name for piece in seam.pieces]
    return [f"Side {number}" for number in range(1, len(seam.pieces) + 1)]


def pieces_of_wires(report: Report) -> dict[int, list[int]]:
    """Return the indices of the pieces that contain parts of each wire, by the index of the wire."""
    pieces: dict[int, list[int]] = {wire.wire: [] for wire in report.wires}
    for piece in report.pieces:
        for part in piece.wires:
            pieces[part.wire].append(piece.index)
    return pieces


def open_edges(report: Report) -> list[tuple[str, int, Chain]]:
    """Return name, index of the piece and chain of each open edge. Open edges are sections of an outline that are not
    sewn, such as hems and necklines."""
    found = []
    for piece in report.pieces:
        free = [chain for chain in piece.outline if chain.seam is None]
        name = f"{piece.name}, open edge"
        found += [
            (f"{name} {number}" if len(free) > 1 else name, piece.index, chain)
            for number, chain in enumerate(free, start=1)
        ]
    return found


def issue_text(report: Report, issue: Issue) -> str:
    """Return the sentence of an issue, with the name of its piece before it."""
    return issue.sentence if issue.piece is None else f"{report.pieces[issue.piece].name}: {issue.sentence}"


def hint_text(report: Report, hint: Hint) -> str:
    """Return the short sentence of a hint, with the name of its piece or wire before it."""
    if hint.wire is not None:
        return f'"{report.wires[hint.wire].name}" {hint.short}'
    return hint.short if hint.piece is None else f"{report.pieces[hint.piece].name}: {hint.short}"


def note_text(report: Report, note: Note) -> str:
    return note.text if note.piece is None else f"{report.pieces[note.piece].name}: {note.text}"


def rename_wires(report: Report, names: Mapping[int, str]) -> None:
    """Set the names of wires in the whole report. names: new names, by the id of the wire in Blender."""
    name_of = {wire.wire: names.get(wire.wire_id, wire.name) for wire in report.wires}
    renamed = {wire.name: name_of[wire.wire] for wire in report.wires}
    if all(old == new for old, new in renamed.items()):
        return
    for part in chain(report.wires, *(piece.wires for piece in report.pieces)):
        part.name = name_of[part.wire]
    report.issues = [
        replace(
            issue,
            sentence=_renamed(issue.sentence, renamed),
            proposed_tolerances=[
                replace(wire, name=renamed.get(wire.name, wire.name)) for wire in issue.proposed_tolerances
            ],
        )
        for issue in report.issues
    ]


def _renamed(sentence: str, renamed: Mapping[str, str]) -> str:
    """Return the sentence with new names of wires. Only names after the word "wire" or "wires" are replaced, as in
    'wires "Hip", "Bust" and "Waist"'."""
    name = f'"({"|".join(map(re.escape, renamed))})"'
    named = re.compile(rf"\b[Ww]ires? {name}((, | and ){name})*")
    return named.sub(lambda found: re.sub(name, lambda old: f'"{renamed[old[1]]}"', found[0]), sentence)
