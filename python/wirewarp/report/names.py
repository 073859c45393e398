# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of the entries of a report in panels, sentences and tables."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain

from .model import Chain, Hint, Issue, Note, Report, Seam


def piece_names(report: Report, indices: Iterable[int]) -> str:
    """Return each piece once: "Front, Back"."""
    return ", ".join(report.pieces[index].name for index in dict.fromkeys(indices))


def joined_pieces(report: Report, pieces: Iterable[int]) -> str:
    """Return the pieces that a seam joins: "Front – Back"."""
    return " – ".join(report.pieces[index].name for index in dict.fromkeys(pieces))


def seam_name(report: Report, seam: Seam) -> str:
    """Return "Seam 3: Front – Back", "Dart 4: Front"."""
    return f"{seam.name}: {joined_pieces(report, seam.pieces)}"


def side_names(report: Report, seam: Seam) -> list[str]:
    """Return one name for each side of a seam."""
    if len(set(seam.pieces)) == len(seam.pieces):
        return [report.pieces[piece].name for piece in seam.pieces]
    return [f"Side {number}" for number in range(1, len(seam.pieces) + 1)]


def pieces_of_wires(report: Report) -> dict[int, list[int]]:
    """Return the pieces that each wire crosses."""
    pieces: dict[int, list[int]] = {wire.wire: [] for wire in report.wires}
    for piece in report.pieces:
        for part in piece.wires:
            pieces[part.wire].append(piece.index)
    return pieces


def open_edges(report: Report) -> list[tuple[str, int, Chain]]:
    """Return (name, piece, chain) of every open section of outline: hems, necklines, armholes."""
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
    """Return the sentence of an issue, preceded by the name of its piece."""
    return issue.sentence if issue.piece is None else f"{report.pieces[issue.piece].name}: {issue.sentence}"


def hint_text(report: Report, hint: Hint) -> str:
    """Return a short hint, preceded by the name of its piece or wire."""
    if hint.wire is not None:
        return f'"{report.wires[hint.wire].name}" {hint.short}'
    return hint.short if hint.piece is None else f"{report.pieces[hint.piece].name}: {hint.short}"


def note_text(report: Report, note: Note) -> str:
    return note.text if note.piece is None else f"{report.pieces[note.piece].name}: {note.text}"


def rename_wires(report: Report, names: Mapping[int, str]) -> None:
    """Give the wires these names, by their ids in Blender."""
    renamed = {wire.name: names[wire.wire_id] for wire in report.wires}
    if all(old == new for old, new in renamed.items()):
        return
    report_name = {wire.wire: wire.name for wire in report.wires}
    name_of = {wire.wire: names[wire.wire_id] for wire in report.wires}
    for part in chain(report.wires, *(piece.wires for piece in report.pieces)):
        part.name = name_of[part.wire]
    report.issues = [
        replace(
            issue,
            sentence=_renamed(issue.sentence, {report_name[wire]: name_of[wire] for wire in issue.wires}),
            proposed_tolerances=[
                replace(wire, name=renamed.get(wire.name, wire.name)) for wire in issue.proposed_tolerances
            ],
        )
        for issue in report.issues
    ]


def _renamed(sentence: str, renamed: Mapping[str, str]) -> str:
    """Replace each quoted name once, also if two wires exchange their names."""
    for number, old in enumerate(renamed):
        sentence = sentence.replace(f'"{old}"', f'"\0{number}"')
    for number, new in enumerate(renamed.values()):
        sentence = sentence.replace(f'"\0{number}"', f'"{new}"')
    return sentence
