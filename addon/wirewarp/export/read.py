# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the data from which the pattern of a model's flat pieces is made. Refuses outdated pieces."""

import datetime
from collections.abc import Mapping, Sequence
from dataclasses import asdict

import bpy
import numpy as np

from ..blender.attributes import has_attributes, sealed, stored_text, unsealed
from ..blender.mesh import current_mesh, evaluated_mesh
from ..blender.objects import linear_part, meters_per_blender_unit
from ..core import pattern
from ..issues import ObjectError, object_error
from ..names import MARKER, PIECE_INDEX, SOURCE_VERTEX
from ..solve.chains import are_among, chains_of_marks
from ..solve.outlines import FlatPieces, OutlineEdges, outline_of, piece_of_vertices
from ..solve.report import ObjectReport
from ..state.allowances import read_allowances
from ..state.flat_pieces import current_pieces, read_flat_pieces
from ..state.identities import names_of
from ..state.record import UPRIGHT, grains
from ..state.reports import pieces_report
from .export import Allowances, Cloth, KeptMarker, PatternParts


def keep_marker(source: bpy.types.Object, kept: KeptMarker) -> None:
    source[MARKER] = sealed({"cloth": asdict(kept.cloth), "marker": kept.marker.to_dict()})


def kept_marker(text: str) -> KeptMarker | None:
    """Return the marker stored in this text. Return None if the text was edited, or if another version stored other
    data."""
    stored = unsealed(text)
    if stored is None:
        return None
    try:
        return KeptMarker(Cloth(**stored["cloth"]), pattern.Marker.from_dict(stored["marker"]))
    except (KeyError, TypeError):
        return None


EDITED = "The flat pieces were edited by hand, and a seam of the model is missing on them. Flatten the model again."


def read_pattern(scene: bpy.types.Scene, source: bpy.types.Object) -> PatternParts:
    """Return the data of a model's pattern, in Object Mode. Raises ObjectError if pieces are missing or outdated."""
    report, flat = current_pieces(source)
    return _parts(scene, source, report, flat, bpy.context.evaluated_depsgraph_get())


def read_outlines(
    scene: bpy.types.Scene, source: bpy.types.Object, flat: bpy.types.Object, depsgraph: bpy.types.Depsgraph
) -> PatternParts | None:
    """Return the data like read_pattern, even if the pieces are outdated; None if no pattern can be made from them.

    The flat pieces must not be in Edit Mode.
    """
    report = pieces_report(source)
    if report is None or not has_attributes(flat.data, PIECE_INDEX, SOURCE_VERTEX):
        return None
    try:
        return _parts(scene, source, report, flat, depsgraph)
    except ObjectError:
        return None


def _parts(
    scene: bpy.types.Scene,
    source: bpy.types.Object,
    report: ObjectReport,
    flat: bpy.types.Object,
    depsgraph: bpy.types.Depsgraph,
) -> PatternParts:
    millimeters = 1000 * meters_per_blender_unit(scene)
    pieces = read_flat_pieces(flat.data, millimeters)
    wire_ids = np.unique(pieces.marks.wire_ids[pieces.marks.rows]).tolist()
    names = names_of(source.data, wire_ids) | {wire.wire_id: wire.name for wire in report.wires}
    return PatternParts(
        title=source.name,
        pieces=_pieces(report, pieces, names, grains(flat.data, pieces.vertices)),
        failed=[piece.name for piece in report.pieces if not piece.ok],
        seam_names=[seam.name for seam in report.seams],
        allowances=_allowances(source, report, millimeters, depsgraph),
        units="imperial" if scene.unit_settings.system == "IMPERIAL" else "metric",
        date=datetime.date.today().isoformat(),
        measures=[
            (wire.name, wire.length_3d * millimeters)
            for wire in report.wires
            if wire.tolerance == 0 and wire.length_3d is not None and None not in wire.length_2d
        ],
        kept=kept_marker(stored_text(source, MARKER)),
    )


def _pieces(
    report: ObjectReport, flat: FlatPieces, wire_names: Mapping[int, str], grains: Mapping[int, np.ndarray]
) -> list[pattern.FlatPiece]:
    """Return the pieces. grains: grain directions by index of the piece; the grain of other pieces is upright."""
    outline = outline_of(flat)
    wires = _inner_wires(flat, outline, wire_names)
    found = []
    for piece in (piece for piece in report.pieces if piece.has_layout):
        own = outline.edges[outline.piece == piece.index]
        chains = [pattern.Chain(np.array(chain.vertices), chain.seam) for chain in piece.outline]
        edges = set(map(tuple, flat.source_vertex[own].tolist()))
        closed = _closed_slits(chains, edges)
        chains = [chain for chain in chains if tuple(chain.sources.tolist()) not in closed]
        steps = [step for chain in chains for step in zip(chain.sources[:-1], chain.sources[1:], strict=True)]
        if not edges.issuperset(steps):  # faces of a mirrored object have their corners in the opposite order
            own = own[:, ::-1]
            if not edges.issuperset(step[::-1] for step in steps):
                raise object_error("edited_pieces", EDITED)
        inside, grain = wires.get(piece.index, []), grains.get(piece.index, UPRIGHT)
        found.append(pattern.FlatPiece(piece.name, flat.vertices, flat.source_vertex, own, chains, inside, grain))
    return found


def _closed_slits(chains: Sequence[pattern.Chain], outline: set[tuple[int, int]]) -> set[tuple[int, ...]]:
    """Return both sides of each seam that is a single edge inside a piece. Such a seam splits no vertex, so the
    piece is not open there."""
    single = {tuple(chain.sources.tolist()) for chain in chains if len(chain.sources) == 2}
    return {side for side in single if side[::-1] in single and not {side, side[::-1]} & outline}


def _inner_wires(
    flat: FlatPieces, outline: OutlineEdges, names: Mapping[int, str]
) -> dict[int, list[pattern.FlatWire]]:
    count, marks = len(flat.vertices), flat.marks.take(flat.marks.rows)
    edges = flat.edges[flat.marks.rows]
    on_outline = are_among(edges, outline.edges)
    piece_of_vertex = piece_of_vertices(count, flat.loop_vertices, flat.face_sizes, flat.face_piece)
    wires: dict[int, list[pattern.FlatWire]] = {}
    for chain in chains_of_marks(edges, marks.without(on_outline), flat.vertices):
        kind = "rigid" if chain.tolerance == 0 else "elastic" if np.isfinite(chain.tolerance) else "super_elastic"
        wire = pattern.FlatWire(names[chain.wire_id], kind, np.array(chain.vertices))
        wires.setdefault(int(piece_of_vertex[chain.vertices[0]]), []).append(wire)
    return wires


def _allowances(
    source: bpy.types.Object, report: ObjectReport, millimeters: float, depsgraph: bpy.types.Depsgraph
) -> Allowances:
    """Return the allowances marked on the mesh that was flattened. Marks on edges inside pieces have no effect."""
    flattened = evaluated_mesh(source, depsgraph) if report.with_modifiers else current_mesh(source)
    with flattened as mesh:
        marked = read_allowances(mesh)
    is_mirrored = bool(np.linalg.det(linear_part(source)) < 0)
    seams: dict[tuple[int, int], bool] = {}  # whether each edge of an outline is sewn, by its vertices in both orders
    chains = [chain for piece in report.pieces if piece.has_layout for chain in piece.outline]
    for chain in chains:
        for a, b in zip(chain.vertices[:-1], chain.vertices[1:], strict=True):
            seams[a, b] = seams[b, a] = chain.seam is not None
    found = Allowances([], [], [])
    for (a, b), width in zip(marked.edges.tolist(), marked.widths.tolist(), strict=True):
        if width < 0 and seams.get((a, b)) is False:
            found.folds.append((a, b))
        elif (a, b) in seams:
            found.both.append((a, b, max(width, 0.0) * millimeters))
    for (a, b), width in zip(marked.sides.tolist(), marked.side_widths.tolist(), strict=True):
        if (a, b) in seams:
            ends = (b, a) if is_mirrored else (a, b)
            found.sides.append((*ends, max(width, 0.0) * millimeters))
    return found


def pieces_over_others(pieces: Sequence[pattern.PatternPiece]) -> list[str]:
    lines = [[line.points for line in piece.of_role("cut", "inner_cut")] for piece in pieces]
    low, high = np.array([piece.bounds for piece in pieces]).transpose(1, 0, 2)
    meet = np.triu(np.all((low[:, None] < high) & (low < high[:, None]), axis=2), 1)
    over = [pair for pair in np.argwhere(meet).tolist() if pattern.geometry.overlap(*(lines[index] for index in pair))]
    return [pieces[index].name for index in sorted({index for pair in over for index in pair})]
