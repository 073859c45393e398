# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a report from a FlattenResult."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

from .. import BoundaryReport, Cloth, Ease, FlattenResult, Piece, SeamReport, WireReport
from .. import Wire as MarkedWire
from . import model
from .asked import LENGTH_LIMIT, asked_of_outline, asked_of_wire, kept
from .coarse import coarse_hints
from .hints import Places, strain_hints, thread_hints, wire_hints
from .model import Hint, Issue, LooserWire, Note, Report, Threads
from .strain import (
    Limits,
    Wanted,
    eases_of_piece,
    piece_strain,
    stretch_figure,
    threads_of,
    triangle_areas,
    triangles_around,
    wanted_strain,
)

AT_LIMIT = 1e-6  # as a fraction; a wire is at its limit if its change is this close to its tolerance
UNUSED_TOLERANCES = "This method keeps every wire rigid, so tolerances were not used."


def make_report(
    result: FlattenResult,
    vertices: npt.ArrayLike,
    faces: npt.ArrayLike,
    *,
    wires: Sequence[MarkedWire] = (),
    eases: Sequence[Ease] = (),
    cloth: Cloth | None = None,
    fabric: str = "custom",
    limits: Limits | None = None,
    meters: float = 1.0,
    name: str = "",
    polygons: np.ndarray | None = None,
    issues: Sequence[Issue] | None = None,
) -> Report:
    """Return the report of a result of flatten(), for the same vertices, faces, wires, eases and cloth.

    - fabric: name of the cloth's preset
    - limits: maximum stretch across and along the grain, each None if unknown; by default cloth.limits
    - meters: meters in a unit of the model
    - name: name of the model
    - polygons (m,): index of the face of each triangle, if the model has larger faces than triangles
    - issues: one issue for each failed piece, to replace the sentences of the library
    """
    points = np.asarray(vertices, dtype=np.float64)
    sides = {(a, b): ease.ratio for ease in eases for a, b in np.asarray(ease.half_edges).tolist()}
    known = limits or (cloth.limits if cloth and cloth.limits else (None, None))
    places = Places(triangle_areas(points, np.asarray(faces)), polygons)
    return _Maker(result, points, wires, sides, cloth, fabric, known, meters, name, places).report(issues)


def failure_report(issue: Issue, name: str = "") -> Report:
    """Return the report of a model that could not be flattened at all."""
    return Report(object=name, issues=[issue])


@dataclass(frozen=True)
class _Maker:
    _result: FlattenResult
    _vertices: np.ndarray  # (n,3)
    _wires: Sequence[MarkedWire]
    _sides: dict[tuple[int, int], float]  # eases by directed edge, for edges with an ease on one side
    _cloth: Cloth | None
    _fabric: str
    _limits: Limits
    _meters: float
    _name: str
    _places: Places

    def report(self, issues: Sequence[Issue] | None) -> Report:
        result = self._result
        if issues is None:
            issues = [_issue(piece, index, self._wires) for index, piece in enumerate(result.pieces) if piece.error]
        pieces = [self._piece(index, piece) for index, piece in enumerate(result.pieces)]
        failed = {piece.index for piece in pieces if not piece.ok}
        at_limit = {part.wire for piece in pieces for part in piece.wires if part.at_limit}
        wires = [self._whole_wire(wire, wire.wire_index in at_limit) for wire in result.wires]
        method = result.report["method"]
        notes = [Note(UNUSED_TOLERANCES)] if method == "wirewarping" and any(wire.tolerance for wire in wires) else []
        notes += [Note(text, True, piece.index) for piece in pieces if piece.ok for text in piece.warnings]
        return Report(
            object=self._name,
            meters=self._meters,
            method=method,
            pieces=pieces,
            seams=[self._seam(index, seam, failed) for index, seam in enumerate(result.seams)],
            wires=wires,
            issues=list(issues),
            hints=wire_hints(wires)
            + self._strain_hints(pieces)
            + coarse_hints([own for piece, own in zip(pieces, result.pieces, strict=True) if piece.ok], self._meters),
            notes=notes,
            reused_pieces=result.report["reused_pieces"],
            seconds=dict(result.report["seconds"]),
        )

    def _strain_hints(self, pieces: Sequence[model.Piece]) -> list[Hint]:
        if self._cloth:
            threads = [piece.threads if piece.ok else None for piece in pieces]
            return thread_hints(self._result.pieces, threads, self._places)
        strains = [
            piece_strain(own.metrics).beyond(self._wanted(own)) if piece.ok else None
            for piece, own in zip(pieces, self._result.pieces, strict=True)
        ]
        return strain_hints(self._result.pieces, strains, [piece.needed for piece in pieces], self._places)

    def _piece(self, index: int, piece: Piece) -> model.Piece:
        metrics, aspect = piece.metrics, piece.metrics.face_aspect_ratio
        has_layout = bool(len(piece.vertices) and np.isfinite(piece.vertices).all())
        strain = piece_strain(metrics) if has_layout else None
        areas = self._places.areas[piece.source_face]
        wanted = self._wanted(piece)
        stretch: float | None = None
        threads: Threads | None = None
        if strain:
            stretch = stretch_figure(strain.beyond(wanted), areas)
            if self._cloth:
                threads = threads_of(metrics, areas, wanted, self._cloth, self._fabric, self._limits)
                stretch = max(threads.across, threads.along)
        asked = asked_of_outline(piece, self._vertices, self._sides)
        return model.Piece(
            index=index,
            name=f"Piece {index + 1}",
            ok=piece.error is None,
            has_layout=has_layout,
            faces=len(self._places.faces_of(piece.source_face)),
            triangles=len(piece.source_face),
            area_3d=_number(metrics.area_3d),
            area_2d=_number(metrics.area_2d),
            arap_energy=_number(metrics.arap_energy),
            cloth_energy=_number(metrics.cloth_energy),
            stretch=None if stretch is None else _number(stretch),
            aspect_ratio_max=_number(np.max(aspect)) if len(aspect) else None,
            stretch_max=_largest(strain.stretch) if strain else None,
            stretch_faces=self._faces_around(piece, strain.stretch) if strain else [],
            ease_max=_largest(strain.ease) if strain else None,
            ease_faces=self._faces_around(piece, strain.ease) if strain else [],
            angle_deviation_rms=_number(metrics.angle_deviation_rms),
            angle_deviation_max=_number(metrics.angle_deviation_max),
            flipped_faces=len(self._places.faces_of(metrics.flipped_faces)),
            overlapping_faces=len(self._places.faces_of(metrics.overlapping_faces)),
            wires=[self._wire(wire) for wire in piece.wires],
            helper_wires=[
                model.HelperWire(**_lengths(wire.length_3d, [wire.length_2d], []), variation=_number(wire.variation))
                for wire in piece.helper_wires
            ],
            outline=[_chain(chain, length) for chain, length in zip(piece.boundaries, asked, strict=True)],
            threads=threads,
            termination=str(piece.report.termination),
            message=piece.report.message,
            warnings=list(piece.report.warnings),
            start=piece.report.start,
            inner_solves=piece.report.inner_solves,
            outer_iterations=piece.report.outer_iterations,
            gradient_evaluations=piece.report.gradient_evaluations,
            factorizations=piece.report.factorizations,
            constraint_residual=_number(piece.report.constraint_residual),
            objective=_number(piece.report.objective),
        )

    def _wanted(self, piece: Piece) -> Wanted:
        return wanted_strain(eases_of_piece(piece, [wire.ease for wire in self._wires], self._sides))

    def _faces_around(self, piece: Piece, shares: np.ndarray) -> list[int]:
        """Return the faces around the triangle with the largest value. shares (k,): stretch or ease of triangles."""
        around = triangles_around(piece, int(np.argmax(shares)))
        return self._places.faces_of(np.asarray(piece.source_face)[around])

    def _wire(self, wire: WireReport) -> model.WirePart:
        ease = self._wires[wire.wire_index].ease
        given = abs(wire.variation - ease)
        if str(wire.kind) == "super_elastic":
            is_kept = math.isfinite(wire.length_2d)  # a free wire may have any length
        else:
            is_kept = kept(wire) and given <= wire.tolerance + LENGTH_LIMIT
        return model.WirePart(
            name=wire.name,
            wire=wire.wire_index,
            part=wire.part if wire.part >= 0 else None,
            kind=str(wire.kind),
            tolerance=wire.tolerance,
            ease=ease,
            **_lengths(wire.length_3d, [wire.length_2d], [asked_of_wire(wire, ease)]),
            ok=bool(is_kept),
            at_limit=bool(0 < wire.tolerance < math.inf and given >= wire.tolerance - AT_LIMIT),
        )

    def _whole_wire(self, wire: WireReport, at_limit: bool) -> model.Wire:
        known = vars(self._wire(wire)) | {"at_limit": at_limit}
        return model.Wire(**known, vertices=self._wires[wire.wire_index].vertices.tolist())

    def _seam(self, index: int, seam: SeamReport, failed: set[int]) -> model.Seam:
        asked = [seam.length_3d * (1 + seam.variation) * (1 + ease) for ease in seam.eases]
        pairs = zip(seam.length_2d, asked, strict=True)
        # For NaN, the comparison is false, so the seam is not ok.
        within = all(abs(length - wanted) <= LENGTH_LIMIT * seam.length_3d for length, wanted in pairs)
        return model.Seam(
            index=index,
            name=f"Seam {index + 1}",
            is_dart=False,
            pieces=[int(piece) for piece in seam.pieces],
            edges=[(a, b) for a, b in np.asarray(seam.edges).tolist()],
            **_lengths(seam.length_3d, seam.length_2d, asked),
            variation=_number(seam.variation),
            eases=[_number(ease) for ease in seam.eases],
            mismatch=_number(seam.mismatch),
            ok=within and not failed.intersection(seam.pieces),
        )


def _issue(piece: Piece, index: int, wires: Sequence[MarkedWire]) -> Issue:
    error = piece.error
    assert error
    return Issue(
        code=str(error.code),
        sentence=error.message,
        piece=index,
        vertices=list(error.vertices),
        edges=list(error.edges),
        faces=list(error.faces),
        wires=list(error.arguments.get("wires", [])),
        proposed_seams=list(error.proposed_seams),
        proposed_tolerances=[
            LooserWire(name=wires[wire].name, tolerance=tolerance, edges=list(pairwise(wires[wire].vertices.tolist())))
            for wire, tolerance in error.proposed_tolerances
        ],
    )


def _chain(chain: BoundaryReport, asked: float) -> model.Chain:
    return model.Chain(
        seam=chain.seam,
        vertices=chain.vertices.tolist(),
        **_lengths(chain.length_3d, [chain.length_2d], [asked]),
        ok=bool(kept(chain)),
    )


def _lengths(length_3d: float, lengths_2d: Iterable[float], asked: Iterable[float]) -> dict[str, Any]:
    return {
        "length_3d": _number(length_3d),
        "length_2d": [_number(length) for length in lengths_2d],
        "length_asked": [_number(length) for length in asked],
    }


def _largest(shares: np.ndarray) -> float | None:
    return _number(np.max(shares)) if len(shares) else None


def _number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
