# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the report of one object: the library's report with the add-on's facts, and with one fix for both pieces of a
mirrored pair. Also makes the message of a run.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from ..core import (
    ANY_LIMIT,
    CLOSED_CODE,
    TORN,
    FlattenResult,
    Issue,
    LooserWire,
    Piece,
    Report,
    ReportTables,
    as_seen,
    make_report,
    note_text,
    paragraph,
    place_name,
    tables_of,
    verdict,
    with_narrow,
)
from .arrays import MeshArrays, triangle_areas
from .chains import are_among
from .cut_faces import Pairs
from .flatten import ClothChoice, issue_of_piece, known_stretch, library_marks, limits_of
from .identity import PieceIdentity, SeamIdentity

SHOWN_SENTENCES = 4  # sentences in the message of a run; the sidebar has all
MOST_SEWN = 60  # maximum number of pieces to sew, because UV maps for textures may have an island for each face


@dataclass(frozen=True, kw_only=True)
class Facts:
    """Facts about an object that are known before it is flattened."""

    object: str
    mesh: str
    with_modifiers: bool
    shaped_by: list[str]  # causes of a visible shape that differs from the mesh: "modifiers", "shape keys"
    counts: dict[str, Any]  # numbers of elements of the object's own mesh


@dataclass(frozen=True, kw_only=True)
class UvSeams:
    """Figures of flattening with the seams of the model's own UV map. The pieces are not kept. If the user chooses
    these seams, they are marked and the model is flattened again."""

    pieces: int  # number of pieces
    failed: int  # number of failed pieces
    stretch: float  # largest Piece.needed of the pieces that can be cut from some fabric
    beyond_any: int = 0  # number of pieces that need more stretch than any fabric has
    is_beyond_fabric: bool = False  # whether a piece needs more stretch than the chosen fabric has

    @property
    def usable(self) -> int:
        return self.pieces - self.failed - self.beyond_any

    @property
    def is_good(self) -> bool:
        """Return whether to offer these seams first. Some pieces may still need seams, for example the laces of a shoe,
        but most must be usable."""
        is_sewable = self.pieces <= MOST_SEWN and self.usable > self.beyond_any
        return is_sewable and not (self.failed or self.is_beyond_fabric)


@dataclass(kw_only=True)
class ObjectReport(Report):
    """The library's report with the add-on's fields. Their defaults are for the report of an object that was not
    read."""

    mesh: str = ""
    with_modifiers: bool = False
    shaped_by: list[str] = field(default_factory=list)
    counts: dict[str, Any] | None = None
    model_state: dict[str, Any] | None = None  # see state.changes; None if it could not be read
    options: dict[str, Any] | None = None  # FlattenChoices and the grain wire; None if the object was not read
    uv_layer: str | None = None
    uv_scale: float | None = None  # Blender units per UV unit
    flat_object: str | None = None  # name of the flat object; None: nothing was written
    # Result with the seams of the UV map. None if it was not tried, or is not better than the result without them.
    uv_seams: UvSeams | None = None

    @property
    def left_out(self) -> list[str]:
        return [] if self.with_modifiers else self.shaped_by

    def follows_grain_wire(self, piece: int) -> bool:
        """Return whether the grain wire is upright in the piece with this index."""
        options = self.options or {}
        ids = {wire.wire: wire.wire_id for wire in self.wires}
        crossing = {ids[part.wire] for part in self.pieces[piece].wires}
        return options.get("orientation") == "grain" and options.get("grain_wire") in crossing

    @property
    def offered_seams(self) -> list[tuple[int, int]]:
        """Return the suggested seams that the next step marks, as vertex pairs. There are none if the UV map has good
        seams, or if all suggested seams are for closed pieces."""
        issues = [issue for issue in self.issues if issue.proposed_seams]
        is_good = self.uv_seams is not None and self.uv_seams.is_good
        if is_good or all(issue.code == CLOSED_CODE for issue in issues):
            return []
        return [edge for issue in issues for edge in issue.proposed_seams]

    @property
    def tables(self) -> ReportTables:
        """Return the tables, which are kept until pieces, wires or seams are renamed, because panels read them at every
        redraw."""
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
    """Return the report of a run. identities: ids and names of the pieces; seams: ids and names of the seams; meters:
    meters in a Blender unit."""
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
    """Return the figures of this result. arrays: the model with the seams of its UV map."""
    pieces = _library_report(result, arrays, meters, cloth).pieces
    good = [piece for piece in pieces if piece.ok]
    needed = [piece.needed for piece in good if piece.needed <= ANY_LIMIT]
    return UvSeams(
        pieces=len(pieces),
        failed=len(pieces) - len(good),
        stretch=max(needed, default=0.0),
        beyond_any=len(good) - len(needed),
        is_beyond_fabric=bool(known_stretch(cloth)) and any(piece.is_strained for piece in good),
    )


def _library_report(result: FlattenResult, arrays: MeshArrays, meters: float, cloth: ClothChoice | None) -> Report:
    issues = [issue_of_piece(piece, index, arrays) for index, piece in enumerate(result.pieces) if piece.error]
    return make_report(
        result,
        arrays.vertices,
        arrays.triangles,
        **library_marks(arrays),
        **limits_of(cloth),
        meters=meters,
        polygons=arrays.triangle_polygons,
        issues=with_mirror_images(issues, result, arrays),
    )


def failure_report(issue: Issue, facts: Facts | None = None) -> ObjectReport:
    """Return the report of an object that could not be flattened at all."""
    return ObjectReport(issues=[issue], **(vars(facts) if facts else {}))


def run_message(reports: Sequence[ObjectReport], narrow: Mapping[str, Sequence[str]]) -> tuple[str, str]:
    """Return the level (INFO, WARNING or ERROR) and the text of a run's message.

    narrow: names of the pieces without room for their allowances, by object; unused if a piece failed.
    """
    notes = [(note, note_text(report, note)) for report in reports for note in report.notes]
    makers = [maker for report in reports for maker in report.left_out]
    if not all(report.ok for report in reports):
        warnings = [text for note, text in notes if note.is_warning]
        torn = {hint.sentence for report in reports for hint in report.hints if hint.code == TORN}
        ignored = [line.text for line in as_seen(verdict(), makers).lines[1:]]
        return "ERROR", paragraph([_failure_text(reports), *ignored, *warnings, *torn])
    found = with_narrow(as_seen(verdict(*reports), makers), narrow)
    is_fine = found.is_ready and not any(note.is_warning for note, _ in notes)
    sentences = [line.text for line in found.lines] + [text for _, text in notes]
    return "INFO" if is_fine else "WARNING", paragraph(sentences)


def _failure_text(reports: Sequence[ObjectReport]) -> str:
    lines = [f"{place_name(report, issue.piece)}: {issue.sentence}" for report in reports for issue in report.issues]
    hidden = len(lines) - SHOWN_SENTENCES
    more = [f"And {hidden} more: see the report in the sidebar."] if hidden > 0 else []
    return paragraph(lines[:SHOWN_SENTENCES] + more)


ALIKE = 1e-3  # maximum relative difference of the measures of mirrored pieces, see _measures
IN_PLACE = 1e-4  # share of a piece's size: maximum distance between a vertex and its mirror image, 0.1 mm per meter


def with_mirror_images(issues: Sequence[Issue], result: FlattenResult, arrays: MeshArrays) -> list[Issue]:
    """Return the issues with shared fixes: both issues of a mirrored pair of pieces suggest the fixes of both pieces.

    If the meshes of the two pieces are mirror images, the fixes of the first piece are mirrored for the second piece.
    """
    found = list(issues)
    fixable = [index for index, issue in enumerate(issues) if issue.proposed_seams or issue.proposed_tolerances]
    measures = {index: _measures(result.pieces[issues[index].piece], arrays) for index in fixable}
    taken: set[int] = set()
    for first, second in combinations(fixable, 2):
        if taken & {first, second} or not _are_alike(issues[first], issues[second], measures[first], measures[second]):
            continue
        taken |= {first, second}
        piece, other_piece = (result.pieces[issues[index].piece] for index in (first, second))
        other = _mirrored(issues[first], piece, other_piece, arrays) or issues[second]
        for index in (first, second):
            found[index] = replace(
                issues[index],
                proposed_seams=_joined(issues[first].proposed_seams, other.proposed_seams),
                proposed_tolerances=_widest([*issues[first].proposed_tolerances, *other.proposed_tolerances]),
                both_sides=True,
            )
    return found


def _measures(piece: Piece, arrays: MeshArrays) -> np.ndarray:
    """Return the square root of the area, and the lengths of the outline's sections in ascending order."""
    area = triangle_areas(arrays.vertices, arrays.triangles[piece.source_face]).sum()
    return np.array([np.sqrt(area), *sorted(chain.length_3d for chain in piece.boundaries)])


def _are_alike(issue: Issue, other: Issue, measures: np.ndarray, others: np.ndarray) -> bool:
    same_kind = issue.code == other.code and bool(issue.proposed_seams) == bool(other.proposed_seams)
    return same_kind and len(measures) == len(others) and np.allclose(measures, others, rtol=ALIKE, atol=0)


def _mirrored(issue: Issue, piece: Piece, other: Piece, arrays: MeshArrays) -> Issue | None:
    """Return the issue with its fixes mirrored to the other piece; None if that piece has no such edges or wires."""
    wanted = [*issue.proposed_seams, *(edge for wire in issue.proposed_tolerances for edge in wire.edges)]
    own = np.intersect1d(np.unique(piece.source_vertex), np.array(wanted).ravel())
    places, others = arrays.vertices[np.unique(piece.source_vertex)], np.unique(other.source_vertex)
    # Most models are symmetric in X. The other axes are for models that are rotated.
    for axis in range(3):
        image = _images(arrays.vertices[own], places, arrays.vertices[others], axis)
        if image is None:
            continue
        image_of = dict(zip(own.tolist(), others[image].tolist(), strict=True))
        seams = _mirrored_edges(issue.proposed_seams, image_of)
        wires = [_mirrored_wire(wire, image_of, arrays) for wire in issue.proposed_tolerances]
        if seams is not None and are_among(seams, arrays.edges).all() and None not in wires:
            return replace(issue, proposed_seams=seams, proposed_tolerances=wires)
    return None


def _images(points: np.ndarray, own: np.ndarray, others: np.ndarray, axis: int) -> np.ndarray | None:
    """Return the index in `others` of the mirror image of each point, (k,); None if a point has none.

    points (k,3): points of the first piece
    own (n,3), others (m,3): all vertices of the two pieces
    """
    mirror = np.where(np.arange(3) == axis, -1.0, 1.0)
    low, high = own.min(axis=0), own.max(axis=0)
    middle = (others.min(axis=0) + others.max(axis=0)) / 2
    mapped = (points - (low + high) / 2) * mirror + middle
    found = np.empty(len(points), dtype=np.int64)
    limit = IN_PLACE * np.linalg.norm(high - low)
    for row, point in enumerate(mapped):
        distances = np.linalg.norm(others - point, axis=1)
        found[row] = np.argmin(distances)
        if distances[found[row]] > limit:
            return None
    return found


def _mirrored_edges(edges: Iterable[tuple[int, int]], image_of: dict[int, int]) -> Pairs | None:
    pairs = [(image_of.get(a, -1), image_of.get(b, -1)) for a, b in edges]
    return None if any(-1 in pair for pair in pairs) else [(min(pair), max(pair)) for pair in pairs]


def _mirrored_wire(wire: LooserWire, image_of: dict[int, int], arrays: MeshArrays) -> LooserWire | None:
    """Return the wire that contains the mirror image of `wire`, with the tolerance of `wire`; None if there is no such
    wire. Only edges of `wire` with vertices in image_of need an image."""
    image = _mirrored_edges([edge for edge in wire.edges if edge[0] in image_of and edge[1] in image_of], image_of)
    wanted = set(image or ())
    for each in arrays.wires:
        edges = list(pairwise(each.chain.vertices))
        if wanted and wanted <= {(min(edge), max(edge)) for edge in edges}:
            return LooserWire(name=each.name, tolerance=wire.tolerance, edges=edges)
    return None


def _joined(first: Pairs, second: Pairs) -> Pairs:
    return list(dict.fromkeys([*first, *second]))


def _widest(wires: Sequence[LooserWire]) -> list[LooserWire]:
    """Return each wire once, with its largest tolerance."""
    widest: dict[str, LooserWire] = {}
    for wire in wires:
        if wire.name not in widest or wire.tolerance > widest[wire.name].tolerance:
            widest[wire.name] = wire
    return list(widest.values())
