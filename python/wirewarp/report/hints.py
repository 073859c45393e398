# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes hints on how to improve good pieces, each with its place on the model."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .. import Piece
from .model import Hint, Pairs, Threads, Wire
from .strain import PieceStrain, connected_regions, edge_keys, percent_text, thread_strains
from .wording import needs_text, strain_text
from .words import tolerance_text

# Above this strain, a dart may help. Stretch fabric allows this strain, but pulls at such places.
STRAIN_LIMIT = 0.08
LARGEST_SHARE = 0.25  # share of a piece's area; if more is strained, only the worst part is shown
MOST_PIECES = 4  # largest number of pieces with hints, the worst ones; the report has the strain of all pieces
MOST_REGIONS = 2  # largest number of places in one piece; the place with the largest strain is added if missing
LEAST_AMOUNT = 0.1  # share of the piece's largest Region.amount; smaller places, mostly single faces, get no hint
TORN, STRAINED, BEYOND_FABRIC, WIRE_AT_LIMIT = "torn", "strained", "beyond_cloth", "wire_at_limit"
TORN_ADVICE = (
    "Some edges overlap but are not joined. If they should be, select them, use Mesh > Merge > By Distance (or Merge "
    "in the Mirror modifier), and flatten again"
)


class Places:
    """The triangles of the model, with their areas and faces."""

    def __init__(self, areas: np.ndarray, polygons: np.ndarray | None) -> None:
        self.areas = areas  # (m,)
        self._polygons = polygons  # (m,) the face of each triangle; None: each triangle is a face

    def faces_of(self, triangles: np.ndarray | Sequence[int]) -> list[int]:
        """Return the faces that contain these triangles, each once, in ascending order."""
        rows = np.asarray(triangles, dtype=np.int64)
        found: list[int] = np.unique(rows if self._polygons is None else self._polygons[rows]).tolist()
        return found


@dataclass(frozen=True, eq=False)
class Region:
    """Connected triangles of one piece with more strain than the limit, or the worst part of these triangles."""

    triangles: np.ndarray  # (k,) triangles of the model
    stretch: float
    ease: float
    amount: float  # strain times area: the excess that a dart would have to remove

    @property
    def worst(self) -> float:
        return max(self.stretch, self.ease)


def strain_hints(
    pieces: Sequence[Piece], strains: Sequence[PieceStrain | None], figures: Sequence[float], places: Places
) -> list[Hint]:
    """Return hints about the most strained places, the worst piece first, and in it the worst place first.

    - strains: strain of each piece; None if it failed
    - figures: stretch of each piece, as a fraction
    """
    worst_first = sorted(range(len(pieces)), key=lambda index: -figures[index])
    hints: list[Hint] = []
    for index in worst_first:
        strain = strains[index]
        if strain is None or len({hint.piece for hint in hints}) == MOST_PIECES:
            continue
        alike: dict[tuple[str, str], list[Region]] = {}  # places with equal texts of their strain share one hint
        for region in _worth_words(_regions(pieces[index], strain, places)):
            alike.setdefault((percent_text(region.stretch), percent_text(region.ease)), []).append(region)
        hints += [_strain_hint(index, regions, rank == 0, places) for rank, regions in enumerate(alike.values())]
    return hints


def _worth_words(regions: list[Region]) -> list[Region]:
    """Return the regions with the largest amounts and the region with the largest strain. The worst strain is first."""
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
    """Return the strain that is exceeded in the share LARGEST_SHARE of the area.

    areas (q,): areas of the triangles.
    """
    order = np.argsort(-strain)
    inside = np.searchsorted(np.cumsum(areas[order]), LARGEST_SHARE * areas.sum())
    return float(strain[order[min(inside, len(order) - 1)]])


def thread_hints(pieces: Sequence[Piece], threads: Sequence[Threads | None], places: Places) -> list[Hint]:
    """Return one hint for each piece in which threads must stretch too far, the worst piece first.

    threads: stretch of the threads of each piece, or None if the piece failed.
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
    """Return the largest stretch in one direction that needs no dart, as a fraction."""
    known: float | None = getattr(threads.gives, way)
    return known if known is not None else STRAIN_LIMIT + (getattr(threads.worn, way) or 0.0)


def _thread_hint(index: int, piece: Piece, threads: Threads, places: Places) -> Hint:
    """Return a hint about the place where a dart would have to remove most fabric."""
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
    """Return hints about elastic wires that have reached their tolerance. The wire that changed most is first."""
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
    """Return one hint about all overlapping edges that are not joined, perhaps on purpose; none without such edges.

    vertices (n,3): vertices of the model. outline (k,2): edges of the model with one face.
    """
    edges = torn_edges(vertices, outline)
    pairs: Pairs = [(a, b) for a, b in edges.tolist()]
    return [Hint(TORN, f"{TORN_ADVICE}.", short=f"{len(pairs)} edges", edges=pairs)] if pairs else []


def torn_edges(vertices: np.ndarray, outline: np.ndarray) -> np.ndarray:
    """Return the outline edges (k,2) whose ends are exactly where the ends of another outline edge are."""
    numbers = _numbered(vertices[outline.ravel()])
    keys = edge_keys(numbers, len(numbers))
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    return outline[counts[inverse] > 1]


def _numbered(points: np.ndarray) -> np.ndarray:
    """Return a number for each of the points (k,3); points at the same position have the same number."""
    order = np.lexsort(points.T)
    is_new = np.any(np.diff(points[order], axis=0) != 0, axis=1)
    numbers = np.zeros(len(points), dtype=np.int64)
    numbers[order[1:]] = np.cumsum(is_new)
    return numbers
