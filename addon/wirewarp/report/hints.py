# SPDX-License-Identifier: GPL-3.0-or-later
"""What would make good pieces better, and where, as sentences with their place."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..core import Piece
from ..issues import Hint
from ..pattern.chains import edge_keys
from ..solve.arrays import MeshArrays, triangle_areas
from ..solve.flatten import polygons_of
from ..words import tolerance_text
from .cloth import STRAIN_LIMIT, PieceStrain, connected_regions, strain_figures, strain_words

LARGEST_SHARE = 0.25  # of the area of a piece: where more is strained, only the worst of it is a place to point at
MOST_REGIONS = 4  # of all pieces
LEAST_AMOUNT = 0.1  # of the greatest: the others are single faces, or not worth words
TORN, STRAINED = "torn", "strained"
ADVICE = (
    "Some edges overlap but are not joined. If they should be, select them, use Mesh > Merge > By Distance (or Merge "
    "in the Mirror modifier), and flatten again"
)


@dataclass(frozen=True, eq=False)
class Region:
    """Triangles of one piece that hang together and must stretch or ease more than the limit, or the worst of them."""

    piece: int
    triangles: np.ndarray  # of the input
    stretch: float
    ease: float
    amount: float  # strain times area: what a dart there would have to take up

    @property
    def worst(self) -> float:
        return max(self.stretch, self.ease)


def strain_hints(pieces: Sequence[Piece], strains: Sequence[PieceStrain | None], arrays: MeshArrays) -> list[Hint]:
    """Where the cloth is strained most, the worst first. strains: None for a piece that failed."""
    regions = [
        region
        for index, (piece, strain) in enumerate(zip(pieces, strains, strict=True))
        if strain is not None
        for region in _regions(index, piece, strain, arrays)
    ]
    places: dict[tuple[int, str], list[Region]] = {}  # one line for all that read alike
    for region in sorted(_worth_words(regions), key=lambda region: -region.worst):
        places.setdefault((region.piece, strain_figures(region.stretch, region.ease)), []).append(region)
    return [_strain_hint(piece, figures, alike, arrays) for (piece, figures), alike in places.items()]


def _worth_words(regions: list[Region]) -> list[Region]:
    """Those with the largest amount; of each piece among them also where its own figure in the report is from."""
    ranked = sorted(regions, key=lambda region: -region.amount)
    chosen = [region for region in ranked[:MOST_REGIONS] if region.amount >= LEAST_AMOUNT * ranked[0].amount]
    worst = {region.piece: region for region in sorted(ranked, key=lambda region: region.worst)}
    figures = [worst[region.piece] for region in chosen]
    return [region for region in ranked if region in chosen or region in figures]


def _strain_hint(piece: int, figures: str, alike: list[Region], arrays: MeshArrays) -> Hint:
    words = strain_words(max(region.stretch for region in alike), max(region.ease for region in alike))
    return Hint(
        STRAINED,
        f"{words[0].upper()}{words[1:]} near here. Add a dart or seam here.",
        short=figures if len(alike) == 1 else f"{figures}, at {len(alike)} places",
        piece=piece,
        faces=polygons_of(arrays, np.concatenate([region.triangles for region in alike])),
    )


def wire_hints(wires: list[dict]) -> list[Hint]:
    """Elastic wires of a report that would go further if they could; the largest change, in percent, first."""
    at_limit = [wire for wire in wires if wire["at_limit"]]
    at_limit.sort(key=lambda wire: -abs(wire["percent"][0] or 0))
    return [
        Hint(
            "wire_at_limit",
            f'Wire "{wire["name"]}" is at its limit. A wider tolerance would lower the distortion.',
            short=f'"{wire["name"]}" {tolerance_text(wire["tolerance"])}',
            edges=list(pairwise(wire["vertices"])),
        )
        for wire in at_limit
    ]


def _regions(index: int, piece: Piece, strain: PieceStrain, arrays: MeshArrays) -> list[Region]:
    worst = np.maximum(strain.stretch, strain.ease)
    areas = triangle_areas(arrays.vertices, arrays.triangles[piece.source_face])
    return [
        Region(
            piece=index,
            triangles=np.asarray(piece.source_face)[members],
            stretch=float(strain.stretch[members].max()),
            ease=float(strain.ease[members].max()),
            amount=float(worst[members] @ areas[members]),
        )
        for members in connected_regions(piece, (worst > STRAIN_LIMIT) & (worst >= _worst_part(worst, areas)))
    ]


def _worst_part(strain: np.ndarray, areas: np.ndarray) -> float:
    """The strain from which on triangles make up the largest share that a place may have."""
    order = np.argsort(-strain)
    inside = np.searchsorted(np.cumsum(areas[order]), LARGEST_SHARE * areas.sum())
    return strain[order[min(inside, len(order) - 1)]]


def torn_hints(arrays: MeshArrays) -> list[Hint]:
    """One, or none; cloth that is cut apart or doubled on purpose is like that, too."""
    edges = torn_edges(arrays)
    return [Hint(TORN, f"{ADVICE}.", short=f"{len(edges)} edges", edges=edges.tolist())] if len(edges) else []


def torn_edges(arrays: MeshArrays) -> np.ndarray:
    """(k,2) the edges of outlines that have both ends in the very places of the ends of another one."""
    places = _numbered(arrays.vertices[arrays.outline.ravel()])
    keys = edge_keys(places, len(places))
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    return arrays.outline[counts[inverse] > 1]


def _numbered(points: np.ndarray) -> np.ndarray:
    """(k,) one number for each place among points (k,3)."""
    order = np.lexsort(points.T)
    is_new = np.any(np.diff(points[order], axis=0) != 0, axis=1)
    numbers = np.zeros(len(points), dtype=np.int64)
    numbers[order[1:]] = np.cumsum(is_new)
    return numbers
