# SPDX-License-Identifier: GPL-3.0-or-later
"""What would make good pieces better, and where."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .. import Piece
from .model import Hint, Pairs, Threads, Wire
from .strain import PieceStrain, connected_regions, edge_keys, percent_text, thread_strains
from .wording import needs_text, strain_text
from .words import tolerance_text

# A stretch from which a dart is worth a thought: the piece can be cut from stretch fabric, but is pulled there.
STRAIN_LIMIT = 0.08
LARGEST_SHARE = 0.25  # of the area of a piece: if more is strained, only the worst of it is a place to point at
MOST_PIECES = 4  # that have a place in the list
MOST_REGIONS = 2  # of one piece
LEAST_AMOUNT = 0.1  # of the greatest in the piece: smaller ones are single faces, not worth words
TORN, STRAINED, BEYOND_FABRIC, WIRE_AT_LIMIT = "torn", "strained", "beyond_cloth", "wire_at_limit"
TORN_ADVICE = (
    "Some edges overlap but are not joined. If they should be, select them, use Mesh > Merge > By Distance (or Merge "
    "in the Mirror modifier), and flatten again"
)


class Places:
    """The model's triangles: how large they are, and to which face each belongs."""

    def __init__(self, areas: np.ndarray, polygons: np.ndarray | None) -> None:
        self.areas = areas  # (m,)
        self._polygons = polygons  # (m,) the face of each triangle; None: each is a face of its own

    def faces_of(self, triangles: np.ndarray | Sequence[int]) -> list[int]:
        """The faces of these triangles, each once, ascending."""
        rows = np.asarray(triangles, dtype=np.int64)
        found: list[int] = np.unique(rows if self._polygons is None else self._polygons[rows]).tolist()
        return found


@dataclass(frozen=True, eq=False)
class Region:
    """Connected triangles of one piece with more strain than the limit, or the worst of them."""

    triangles: np.ndarray  # of the model
    stretch: float
    ease: float
    amount: float  # strain times area: what a dart there would have to take up

    @property
    def worst(self) -> float:
        return max(self.stretch, self.ease)


def strain_hints(
    pieces: Sequence[Piece], strains: Sequence[PieceStrain | None], figures: Sequence[float], places: Places
) -> list[Hint]:
    """Where the fabric is strained most: the worst piece first, in it the worst place.

    strains: None for a piece that failed; figures: the stretch of each piece.
    """
    worst_first = sorted(range(len(pieces)), key=lambda index: -figures[index])
    hints: list[Hint] = []
    for index in worst_first:
        strain = strains[index]
        if strain is None or len({hint.piece for hint in hints}) == MOST_PIECES:
            continue
        alike: dict[tuple[str, str], list[Region]] = {}  # one line for those with equal strain
        for region in _worth_words(_regions(pieces[index], strain, places)):
            alike.setdefault((percent_text(region.stretch), percent_text(region.ease)), []).append(region)
        hints += [_strain_hint(index, regions, rank == 0, places) for rank, regions in enumerate(alike.values())]
    return hints


def _worth_words(regions: list[Region]) -> list[Region]:
    """Those with the largest amount, and the one with the largest strain; the worst first."""
    ranked = sorted(regions, key=lambda region: -region.amount)
    chosen = [region for region in ranked[:MOST_REGIONS] if region.amount >= LEAST_AMOUNT * ranked[0].amount]
    worst = max(regions, key=lambda region: region.worst, default=None)
    return sorted((r for r in ranked if r in chosen or r is worst), key=lambda region: -region.worst)


def _strain_hint(piece: int, alike: list[Region], is_worst: bool, places: Places) -> Hint:
    text = strain_text(alike[0].stretch, alike[0].ease) + (" most" if is_worst else "")
    return Hint(
        STRAINED,
        f"The fabric is {text} here. Add a dart or seam.",
        short=text if len(alike) == 1 else f"{text}, at {len(alike)} places",
        piece=piece,
        faces=places.faces_of(np.concatenate([region.triangles for region in alike])),
    )


def _regions(piece: Piece, strain: PieceStrain, places: Places) -> list[Region]:
    worst = np.maximum(strain.stretch, strain.ease)
    areas = places.areas[piece.source_face]
    return [
        Region(
            triangles=np.asarray(piece.source_face)[members],
            stretch=float(strain.stretch[members].max()),
            ease=float(strain.ease[members].max()),
            amount=float(worst[members] @ areas[members]),
        )
        for members in connected_regions(piece, (worst > STRAIN_LIMIT) & (worst >= _worst_part(worst, areas)))
    ]


def _worst_part(strain: np.ndarray, areas: np.ndarray) -> float:
    """The strain from which triangles make up the largest share that a place may have."""
    order = np.argsort(-strain)
    inside = np.searchsorted(np.cumsum(areas[order]), LARGEST_SHARE * areas.sum())
    return float(strain[order[min(inside, len(order) - 1)]])


def thread_hints(pieces: Sequence[Piece], threads: Sequence[Threads | None], places: Places) -> list[Hint]:
    """Where the threads must stretch most, in each piece in which that is too much; the worst piece first.

    threads: None for a piece that failed.
    """
    found = [
        (
            max(own.across - _limit(own, "across"), own.along - _limit(own, "along")),
            _thread_hint(index, piece, own, places),
        )
        for index, (piece, own) in enumerate(zip(pieces, threads, strict=True))
        if own and (own.across > _limit(own, "across") or own.along > _limit(own, "along"))
    ]
    return [hint for _, hint in sorted(found, key=lambda each: -each[0])]


def _limit(threads: Threads, way: str) -> float:
    """The stretch along these threads from which a dart is worth a thought."""
    known: float | None = getattr(threads.gives, way)
    return known if known is not None else STRAIN_LIMIT + (getattr(threads.worn, way) or 0.0)


def _thread_hint(index: int, piece: Piece, threads: Threads, places: Places) -> Hint:
    """At the place where a dart would have most to take up."""
    strains = thread_strains(piece.metrics)
    beyond = np.max([strain - _limit(threads, way) for way, strain in strains.items()], axis=0)
    amounts = beyond * places.areas[piece.source_face]
    worst = max(connected_regions(piece, beyond > 0), key=lambda members: float(amounts[members].sum()))
    short = needs_text(threads)
    return Hint(
        BEYOND_FABRIC,
        f"{short}. Add a dart or seam here.",
        short=short,
        piece=index,
        faces=places.faces_of(np.asarray(piece.source_face)[worst]),
    )


def wire_hints(wires: Sequence[Wire]) -> list[Hint]:
    """Elastic wires that would change their length further if they could; the largest change first."""
    at_limit = [(index, wire) for index, wire in enumerate(wires) if wire.at_limit]
    at_limit.sort(key=lambda each: -abs(each[1].percent[0] or 0))
    return [
        Hint(
            WIRE_AT_LIMIT,
            "This wire is at its limit. A wider tolerance would lower the distortion.",
            short=tolerance_text(wire.tolerance),
            wire=index,
            edges=list(pairwise(wire.vertices)),
        )
        for index, wire in at_limit
    ]


def torn_hints(vertices: np.ndarray, outline: np.ndarray) -> list[Hint]:
    """One hint, or none; fabric that is cut apart or doubled on purpose is like that, too.

    vertices (n,3) of the model; outline (k,2): its edges of one face.
    """
    edges = torn_edges(vertices, outline)
    pairs: Pairs = [(a, b) for a, b in edges.tolist()]
    return [Hint(TORN, f"{TORN_ADVICE}.", short=f"{len(pairs)} edges", edges=pairs)] if pairs else []


def torn_edges(vertices: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """(k,2) the edges of outlines with both ends exactly where another one has its ends."""
    numbers = _numbered(vertices[outline.ravel()])
    keys = edge_keys(numbers, len(numbers))
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    return outline[counts[inverse] > 1]


def _numbered(points: np.ndarray) -> np.ndarray:
    """(k,) one number for each position among points (k,3)."""
    order = np.lexsort(points.T)
    is_new = np.any(np.diff(points[order], axis=0) != 0, axis=1)
    numbers = np.zeros(len(points), dtype=np.int64)
    numbers[order[1:]] = np.cumsum(is_new)
    return numbers
