# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of one object: the library's, with the add-on's facts about the object; and the message of a run."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from ..core import (
    CLOSED_CODE,
    TORN,
    FlattenResult,
    Issue,
    Report,
    ReportTables,
    as_seen,
    library,
    make_report,
    note_text,
    paragraph,
    place_name,
    tables_of,
    verdict,
)
from .arrays import MeshArrays
from .flatten import ClothChoice, issue_of_piece, known_stretch, library_cloth, library_marks, maximum_stretch
from .identity import PieceIdentity, SeamIdentity
from .mirrored_pieces import with_mirror_images

SHOWN_SENTENCES = 4


@dataclass(frozen=True, kw_only=True)
class Facts:
    """Facts about an object before it is flattened."""

    object: str
    mesh: str
    with_modifiers: bool
    shaped_by: list[str]  # causes of a different visible shape: "modifiers", "shape keys"
    counts: dict[str, Any]  # numbers of elements of its own mesh


@dataclass(frozen=True, kw_only=True)
class UvSeams:
    """The result of flattening with the seams of the model's own UV map, which was tried because the marked ones fail.

    It is not kept: if the user wants it, the seams are marked and the model is flattened again.
    """

    pieces: int
    failed: int
    stretch: float  # largest Piece.stretch of the good pieces
    is_beyond_fabric: bool = False  # whether the chosen fabric does not stretch that far

    @property
    def is_good(self) -> bool:
        return not (self.failed or self.is_beyond_fabric)


@dataclass(kw_only=True)
class ObjectReport(Report):
    """The library's report with the add-on's fields. Defaults are for stored reports that a user has changed."""

    mesh: str = ""
    with_modifiers: bool = False
    shaped_by: list[str] = field(default_factory=list)
    counts: dict[str, Any] | None = None
    model_state: dict[str, Any] | None = None  # see state.changes; None if it could not be read
    options: dict[str, Any] | None = None  # FlattenChoices and the grain wire; None if the object was not read
    uv_layer: str | None = None
    uv_scale: float | None = None  # Blender units per UV unit
    flat_object: str | None = None  # None: nothing was written
    uv_seams: UvSeams | None = None  # None: not tried

    @property
    def left_out(self) -> list[str]:
        """Return the modifiers and shape keys that the run ignored."""
        return [] if self.with_modifiers else self.shaped_by

    @property
    def offered_seams(self) -> list[tuple[int, int]]:
        """Return the proposed seams that the next step marks, as vertex pairs.

        There are none if the UV map has good seams, or if all proposed seams only slit closed pieces open.
        """
        issues = [issue for issue in self.issues if issue.proposed_seams]
        is_good = self.uv_seams is not None and self.uv_seams.is_good
        if is_good or all(issue.code == CLOSED_CODE for issue in issues):
            return []
        return [edge for issue in issues for edge in issue.proposed_seams]

    @property
    def tables(self) -> ReportTables:
        """Return the tables, which are kept until pieces, wires or seams are renamed, because panels read them at
        every redraw.
        """
        names = [*(piece.name for piece in self.pieces), *(wire.name for wire in self.wires)]
        names += [seam.name for seam in self.seams]
        known, tables = vars(self).get("_tables", (None, None))
        if known != names:
            tables = tables_of(self)
            vars(self)["_tables"] = names, tables
        return tables


def object_report(
    result: FlattenResult,
    arrays: MeshArrays,
    facts: Facts,
    identities: Sequence[PieceIdentity],
    seams: Sequence[SeamIdentity],
    meters: float,
    cloth: ClothChoice | None = None,
) -> ObjectReport:
    """Return the report. identities: names and ids of pieces; meters: in one Blender unit."""
    report = _library_report(result, arrays, meters, cloth)
    for piece, identity in zip(report.pieces, identities, strict=True):
        piece.name, piece.piece_id = identity.name, identity.piece_id
    for seam, own in zip(report.seams, seams, strict=True):
        seam.name, seam.seam_id, seam.is_dart = own.name, own.seam_id, own.is_dart
    for wire in report.wires:
        marked = arrays.wires[wire.wire]
        wire.wire_id, wire.marked_id = marked.chain.wire_id, marked.marked_id
    return ObjectReport(**vars(report) | vars(facts))


def uv_seams(result: FlattenResult, arrays: MeshArrays, meters: float, cloth: ClothChoice | None) -> UvSeams:
    """Return the result. arrays: with the seams of the UV map."""
    pieces = _library_report(result, arrays, meters, cloth).pieces
    good = [piece for piece in pieces if piece.ok]
    return UvSeams(
        pieces=len(pieces),
        failed=len(pieces) - len(good),
        stretch=max((piece.needed for piece in good), default=0.0),
        is_beyond_fabric=bool(known_stretch(cloth)) and any(piece.is_strained for piece in good),
    )


def _library_report(result: FlattenResult, arrays: MeshArrays, meters: float, cloth: ClothChoice | None) -> Report:
    issues = [issue_of_piece(piece, index, arrays) for index, piece in enumerate(result.pieces) if piece.error]
    return make_report(
        result,
        arrays.vertices,
        arrays.triangles,
        **library_marks(library(), arrays),
        cloth=library_cloth(cloth) if cloth else None,
        limits=maximum_stretch(cloth) if cloth else None,
        fabric=cloth.name if cloth else "",
        meters=meters,
        polygons=arrays.triangle_polygons,
        issues=with_mirror_images(issues, result, arrays),
    )


def failure_report(issue: Issue, facts: Facts | None = None) -> ObjectReport:
    """Return the report of an object that could not be flattened at all."""
    return ObjectReport(issues=[issue], **(vars(facts) if facts else {}))


def run_message(reports: Sequence[ObjectReport]) -> tuple[str, str]:
    """Return the level (INFO, WARNING or ERROR) and the text of a run's message."""
    notes = [(note, note_text(report, note)) for report in reports for note in report.notes]
    makers = [maker for report in reports for maker in report.left_out]
    if not all(report.ok for report in reports):
        warnings = [text for note, text in notes if note.is_warning]
        torn = {hint.sentence for report in reports for hint in report.hints if hint.code == TORN}
        ignored = [line.text for line in as_seen(verdict(), makers).lines[1:]]
        return "ERROR", paragraph([_failure_text(reports), *ignored, *warnings, *torn])
    found = as_seen(verdict(*reports), makers)
    is_fine = found.is_ready and not any(note.is_warning for note, _ in notes)
    sentences = [line.text for line in found.lines] + [text for _, text in notes]
    return "INFO" if is_fine else "WARNING", paragraph(sentences)


def _failure_text(reports: Sequence[ObjectReport]) -> str:
    """Return one sentence for each failure."""
    lines = [f"{place_name(report, issue.piece)}: {issue.sentence}" for report in reports for issue in report.issues]
    hidden = len(lines) - SHOWN_SENTENCES
    more = [f"And {hidden} more: see the report in the sidebar."] if hidden > 0 else []
    return paragraph(lines[:SHOWN_SENTENCES] + more)
