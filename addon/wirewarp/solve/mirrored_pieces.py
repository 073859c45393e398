# SPDX-License-Identifier: GPL-3.0-or-later
"""Mirrors the fix proposed for one of two failed mirrored pieces, such as sleeves, to the other."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np

from ..core import FlattenResult, Issue, LooserWire, Piece
from .arrays import MeshArrays, triangle_areas
from .chains import edge_keys

ALIKE = 1e-3  # maximum relative difference between outlines and areas of mirrored pieces
IN_PLACE = 1e-4  # share of a piece's size: maximum distance between a vertex and its mirror image
Pairs = list[tuple[int, int]]  # vertices


def with_mirror_images(issues: Sequence[Issue], result: FlattenResult, arrays: MeshArrays) -> list[Issue]:
    """Return the issues. The issue of each mirrored piece proposes fixes for both pieces.

    If the meshes of the pieces are mirror images, the fixes are the first proposal and its mirror image. Otherwise they
    are the proposals of both issues.
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
    """Return the root of the area, and the lengths of the outline's sections in their order."""
    area = triangle_areas(arrays.vertices, arrays.triangles[piece.source_face]).sum()
    return np.array([np.sqrt(area), *sorted(chain.length_3d for chain in piece.boundaries)])


def _are_alike(issue: Issue, other: Issue, measures: np.ndarray, others: np.ndarray) -> bool:
    same_kind = issue.code == other.code and bool(issue.proposed_seams) == bool(other.proposed_seams)
    return same_kind and len(measures) == len(others) and np.allclose(measures, others, rtol=ALIKE, atol=0)


def _mirrored(issue: Issue, piece: Piece, other: Piece, arrays: MeshArrays) -> Issue | None:
    """Return the issue's proposal, mirrored to the other piece; None if that has no such edges or wires."""
    wanted = [*issue.proposed_seams, *(edge for wire in issue.proposed_tolerances for edge in wire.edges)]
    own = np.intersect1d(np.unique(piece.source_vertex), np.array(wanted).ravel())
    places, others = arrays.vertices[np.unique(piece.source_vertex)], np.unique(other.source_vertex)
    for axis in range(3):  # most models are symmetric in X; others lie down or face sideways
        image = _images(arrays.vertices[own], places, arrays.vertices[others], axis)
        if image is None:
            continue
        image_of = dict(zip(own.tolist(), others[image].tolist(), strict=True))
        seams = _mirrored_edges(issue.proposed_seams, image_of)
        wires = [_mirrored_wire(wire, image_of, arrays) for wire in issue.proposed_tolerances]
        if seams is not None and _are_edges(seams, arrays) and None not in wires:
            return replace(issue, proposed_seams=seams, proposed_tolerances=wires)
    return None


def _images(points: np.ndarray, own: np.ndarray, others: np.ndarray, axis: int) -> np.ndarray | None:
    """Return the vertices (k,) of the other piece that mirror the points (k,3); None if one has no mirror image.

    own (n,3), others (m,3): all vertices of both pieces, which are aligned by their middles.
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


def _are_edges(pairs: Pairs, arrays: MeshArrays) -> bool:
    count = len(arrays.vertices)
    return bool(np.isin(edge_keys(pairs, count), edge_keys(arrays.edges, count)).all())


def _mirrored_wire(wire: LooserWire, image_of: dict[int, int], arrays: MeshArrays) -> LooserWire | None:
    """Return the wire along the mirror image of the part of `wire` in the piece."""
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
    """Return each wire once, with its widest tolerance."""
    widest: dict[str, LooserWire] = {}
    for wire in wires:
        if wire.name not in widest or wire.tolerance > widest[wire.name].tolerance:
            widest[wire.name] = wire
    return list(widest.values())
