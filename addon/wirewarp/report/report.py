# SPDX-License-Identifier: GPL-3.0-or-later
"""A flattening as a JSON-able dict.

Every length stands twice: in Blender units under its name and in metres under its name + "_m"; areas likewise with
"_m2". What JSON cannot say becomes null (no layout: no 2D length) or "inf" (the tolerance of a super-elastic wire).
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from ..core import FlattenResult, HelperWire, Piece, SeamReport, WireReport
from ..issues import Issue, note, warning
from ..solve.arrays import MeshArrays
from ..solve.flatten import ClothChoice, issue_of_piece, polygons_of
from ..solve.identity import PieceIdentity
from ..solve.seams import SeamIdentity
from ..words import quoted
from .asked import LENGTH_LIMIT, asked_of_outline, asked_of_wire, kept
from .cloth import PieceStrain, piece_strain, triangles_around
from .hints import strain_hints, wire_hints
from .threads import thread_hints, threads_of
from .twins import with_twins

SCHEMA = "wirewarp-report-4"
AT_LIMIT = 1e-6  # an elastic wire this close to its tolerance would go further if it could
METHOD_NAMES = {
    "refined": "Refined",
    "wirewarp++": "WireWarping++",
    "wirewarping": "WireWarping, all wires rigid",
}


def object_report(
    result: FlattenResult,
    arrays: MeshArrays,
    identities: Sequence[PieceIdentity],
    seams: Sequence[SeamIdentity],
    meters: float,
    cloth: ClothChoice | None = None,
) -> dict:
    """The report of one object; identities of its pieces; meters: metres in a Blender unit; cloth: as chosen."""
    issues = [
        issue_of_piece(piece, index, arrays) for index, piece in enumerate(result.pieces) if piece.error is not None
    ]
    issues = with_twins(issues, result, arrays)
    failed = {issue.piece for issue in issues}
    method = result.report["method"]
    strains = [piece_strain(piece.metrics) if _has_layout(piece) else None for piece in result.pieces]
    pieces = [
        {"index": index, **asdict(identity), **_piece(piece, arrays, meters), **_strain(piece, strain, arrays)}
        for index, (identity, piece, strain) in enumerate(zip(identities, result.pieces, strains, strict=True))
    ]
    threads = [threads_of(piece, arrays, cloth) if cloth and _has_layout(piece) else None for piece in result.pieces]
    for entry, own in zip(pieces, threads, strict=True):
        entry["threads"] = own
    at_limit = {part["wire"] for piece in pieces for part in piece["wires"] if part["at_limit"]}
    wires = [
        _wire(wire, arrays, meters)
        | {
            "at_limit": wire.wire_index in at_limit,
            "vertices": arrays.wires[wire.wire_index].chain.vertices,
            "wire_id": arrays.wires[wire.wire_index].chain.wire_id,
            "marked_id": arrays.wires[wire.wire_index].marked_id,
        }
        for wire in result.wires
    ]
    good = [None if index in failed else strain for index, strain in enumerate(strains)]
    good_threads = [None if index in failed else own for index, own in enumerate(threads)]
    hints = wire_hints(wires)
    hints += thread_hints(result.pieces, good_threads, arrays) if cloth else strain_hints(result.pieces, good, arrays)
    return {
        "schema": SCHEMA,
        "ok": not issues,
        "method": method,
        "method_name": METHOD_NAMES[method],
        "pieces": pieces,
        "seams": [
            {"index": index, **asdict(identity), **_seam(seam, failed, meters)}
            for index, (identity, seam) in enumerate(zip(seams, result.seams, strict=True))
        ],
        "wires": wires,
        "issues": [_issue(issue) for issue in issues],
        "hints": [dict(vars(hint)) for hint in hints],
        "notes": _notes(method, wires) + _warnings(pieces),
        "reused_pieces": result.report["reused_pieces"],
        "seconds": dict(result.report["seconds"]),
    }


def failure_report(issue: Issue) -> dict:
    """The report of an object that could not be flattened at all."""
    return {
        "schema": SCHEMA,
        "ok": False,
        "pieces": [],
        "seams": [],
        "wires": [],
        "issues": [_issue(issue)],
        "hints": [],
        "notes": [],
    }


def _issue(issue: Issue) -> dict:
    entry = asdict(issue)
    for wire in entry["proposed_tolerances"]:
        wire["tolerance"] = _tolerance(wire["tolerance"])
    return entry


def _tolerance(tolerance: float) -> float | str:
    return "inf" if math.isinf(tolerance) else tolerance


def _piece(piece: Piece, arrays: MeshArrays, meters: float) -> dict:
    metrics = piece.metrics
    aspect = metrics.face_aspect_ratio
    return {
        "ok": piece.error is None,
        "has_layout": _has_layout(piece),
        "faces": len(polygons_of(arrays, piece.source_face)),
        "triangles": len(piece.source_face),
        "area_3d": number(metrics.area_3d),
        "area_3d_m2": number(metrics.area_3d * meters**2),
        "area_2d": number(metrics.area_2d),
        "area_2d_m2": number(metrics.area_2d * meters**2),
        "arap_energy": number(metrics.arap_energy),
        "cloth_energy": number(metrics.cloth_energy),
        "aspect_ratio_max": number(np.max(aspect)) if len(aspect) else None,
        "angle_deviation_rms": number(metrics.angle_deviation_rms),
        "angle_deviation_max": number(metrics.angle_deviation_max),
        "flipped_faces": len(polygons_of(arrays, metrics.flipped_faces)),
        "overlapping_faces": len(polygons_of(arrays, metrics.overlapping_faces)),
        "wires": [_wire(wire, arrays, meters) for wire in piece.wires],
        "helper_wires": [_helper(wire, meters) for wire in piece.helper_wires],
        "outline": _outline(piece, arrays, meters),
        "termination": str(piece.report.termination),
        "message": piece.report.message,
        "warnings": list(piece.report.warnings),
        "start": piece.report.start,
        "inner_solves": piece.report.inner_solves,
        "outer_iterations": piece.report.outer_iterations,
        "gradient_evaluations": piece.report.gradient_evaluations,
        "factorizations": piece.report.factorizations,
        "constraint_residual": number(piece.report.constraint_residual),
        "objective": number(piece.report.objective),
    }


def _has_layout(piece: Piece) -> bool:
    return bool(np.isfinite(piece.vertices).all() and len(piece.vertices))


def _strain(piece: Piece, strain: PieceStrain | None, arrays: MeshArrays) -> dict:
    """The largest stretch and ease of the cloth, and the faces around the place where it is that."""
    found: dict[str, Any] = {}
    for name in ("stretch", "ease"):
        shares = getattr(strain, name) if strain else ()
        faces = triangles_around(piece, int(np.argmax(shares))) if len(shares) else ()
        found[f"{name}_max"] = number(np.max(shares)) if len(shares) else None
        found[f"{name}_faces"] = polygons_of(arrays, np.asarray(piece.source_face)[faces]) if len(faces) else []
    return found


def _wire(wire: WireReport, arrays: MeshArrays, meters: float) -> dict:
    ease = arrays.wires[wire.wire_index].chain.ease
    given = abs(wire.variation - ease)
    if str(wire.kind) == "super_elastic":
        is_kept = math.isfinite(wire.length_2d)  # nothing else is promised
    else:
        is_kept = kept(wire) and given <= wire.tolerance + LENGTH_LIMIT
    return {
        "name": wire.name,
        "wire": wire.wire_index,
        "part": wire.part if wire.part >= 0 else None,
        "kind": str(wire.kind),
        "tolerance": _tolerance(wire.tolerance),
        "ease": ease,
        **lengths(wire.length_3d, [wire.length_2d], [asked_of_wire(wire, ease)], meters),
        "ok": bool(is_kept),
        "at_limit": bool(0 < wire.tolerance < math.inf and given >= wire.tolerance - AT_LIMIT),
    }


def _helper(wire: HelperWire, meters: float) -> dict:
    return {**lengths(wire.length_3d, [wire.length_2d], [], meters), "variation": number(wire.variation)}


def _outline(piece: Piece, arrays: MeshArrays, meters: float) -> list[dict]:
    return [
        {
            "seam": chain.seam,
            "vertices": [int(vertex) for vertex in chain.vertices],
            **lengths(chain.length_3d, [chain.length_2d], [asked], meters),
            "ok": bool(kept(chain)),
        }
        for chain, asked in zip(piece.boundaries, asked_of_outline(piece, arrays), strict=True)
    ]


def _seam(seam: SeamReport, failed: set, meters: float) -> dict:
    """variation: by how much all sides are longer than on the model, eases: by how much more each side is."""
    asked = [seam.length_3d * (1 + seam.variation) * (1 + ease) for ease in seam.eases]
    pairs = zip(seam.length_2d, asked, strict=True)
    within = all(abs(length - wanted) <= LENGTH_LIMIT * seam.length_3d for length, wanted in pairs)  # NaN is not
    return {
        "pieces": [int(piece) for piece in seam.pieces],
        "edges": np.asarray(seam.edges).tolist(),
        **lengths(seam.length_3d, seam.length_2d, asked, meters),
        "variation": number(seam.variation),
        "eases": [number(ease) for ease in seam.eases],
        "mismatch": number(seam.mismatch),
        "mismatch_m": number(seam.mismatch * meters),
        "ok": within and not failed.intersection(seam.pieces),
    }


def lengths(length_3d: float, lengths_2d: Iterable[float], asked: Sequence[float], meters: float) -> dict:
    """The 3D length and, one per side, the 2D length, the one asked for, the difference (2D less 3D) and the
    percentage.
    """
    flat = [float(length) for length in lengths_2d]
    differences = [length - length_3d for length in flat]
    return {
        "length_3d": number(length_3d),
        "length_3d_m": number(length_3d * meters),
        "length_2d": [number(length) for length in flat],
        "length_2d_m": [number(length * meters) for length in flat],
        "length_asked": [number(length) for length in asked],
        "length_asked_m": [number(length * meters) for length in asked],
        "difference": [number(difference) for difference in differences],
        "difference_m": [number(difference * meters) for difference in differences],
        "percent": [number(100 * difference / length_3d) if length_3d else None for difference in differences],
    }


def number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def _notes(method: str, wires: list[dict]) -> list[dict]:
    loose = [wire["name"] for wire in wires if wire["tolerance"] != 0]
    if method == "wirewarping" and loose:
        return [note(f"This method keeps every wire rigid, so these tolerances were not used: {quoted(loose)}.")]
    return []


def _warnings(pieces: list[dict]) -> list[dict]:
    """Pieces that keep every promise but could be better: those that were cancelled, for one."""
    return [warning(f"{piece['name']}: {text}") for piece in pieces if piece["ok"] for text in piece["warnings"]]
