# SPDX-License-Identifier: GPL-3.0-or-later
"""How far cloth must stretch or be eased in, and whether any cloth can.

All shares are of the flat length: a stretch of 0.1 is cloth drawn out by a tenth in the direction where that is most,
an ease of 0.1 is cloth taken in by a tenth.
"""

import math
from dataclasses import dataclass

import numpy as np

from ..core import Metrics, Piece
from ..pattern.chains import edge_keys

# Of the aspect ratio. A plain limit, not one of a certain cloth: by more than a quarter hardly any stretches or eases.
CLOTH_LIMIT = 1.25
# From which share on a dart is worth a thought: pieces are cut beyond it too, but no longer lie on the model without
# being pulled. A plain limit for cloth of which nothing is known; what gives more, like neoprene, needs no dart there.
STRAIN_LIMIT = 0.08
UNSEWABLE = 2.0  # of the aspect ratio: no cloth comes to twice its length or to half of it
LESSER = 0.5  # of stretch and ease, the lesser is worth words from this share of the greater


def aspect_ratio(piece: dict) -> float:
    """Of the worst face of a piece with a layout: max(σ1, 1/σ2), inf for a face without area."""
    ratio = piece["aspect_ratio_max"]
    return math.inf if ratio is None else ratio


def is_strained(piece: dict) -> bool:
    """A good piece beyond what cloth can follow: the one that was chosen, or hardly any."""
    threads = piece.get("threads")  # which reports before there were cloths have not
    return piece["ok"] and (threads["over"] if threads else aspect_ratio(piece) > CLOTH_LIMIT)


def is_unsewable(piece: dict) -> bool:
    """A good piece that no cloth at all can follow."""
    threads = piece.get("threads")
    longest = 1 + max(threads["across"], threads["along"]) if threads else aspect_ratio(piece)
    return piece["ok"] and longest > UNSEWABLE


def ready_text(pieces: list[dict]) -> str:
    """The verdict on good pieces that are not beyond cloth: from which cloth they may be cut."""
    strain = max(largest(piece[name]) for piece in pieces for name in ("stretch_max", "ease_max"))
    return (
        f"Ready to cut, from cloth that stretches {percent_text(strain)}" if strain > STRAIN_LIMIT else "Ready to cut"
    )


def strain_words(stretch: float, ease: float) -> str:
    """What cloth must do, of shares of its flat length: "stretch up to 12% and ease in up to 9.0%"."""
    if stretch >= UNSEWABLE - 1:
        return "stretch more than any cloth can"
    worth = _worth_words([("stretch", stretch), ("ease in", ease)])
    return " and ".join(f"{verb} up to {percent_text(share)}" for verb, share in worth)


def strain_figures(stretch: float, ease: float) -> str:
    """The same in short: "stretch 12%, ease 9.0%"."""
    worth = _worth_words([("stretch", stretch), ("ease", ease)])
    return ", ".join(f"{noun} {percent_text(share)}" for noun, share in worth)


def _worth_words(strains: list[tuple[str, float]]) -> list[tuple[str, float]]:
    """The greater, and the lesser where it is not much less."""
    greatest = max(share for _, share in strains)
    return [(word, share) for word, share in strains if share >= LESSER * greatest]


def percent_text(share: float) -> str:
    if math.isinf(share):
        return "unlimited"
    if share >= UNSEWABLE - 1:
        return "over 100%"
    return f"{100 * share:.0f}%" if share >= 0.0995 else f"{100 * share:.1f}%"


def largest(share: float | None) -> float:
    """A stretch or ease of the report, where JSON has no infinity."""
    return math.inf if share is None else share


@dataclass(frozen=True)
class PieceStrain:
    """Per triangle of a piece with a layout."""

    stretch: np.ndarray  # (q,) at least 0; inf where the flat triangle has no area
    ease: np.ndarray  # (q,) from 0 to 1


def piece_strain(metrics: Metrics) -> PieceStrain:
    """From the library's strain of threads, so that what is thick is measured in the middle of its thickness.

    Threads of lengths p and q with g = p q sin γ between them have the metric (p², g; g, q²): its eigenvalues are the
    squares of the principal stretches of the map from flat to model.
    """
    p, q = 1 + metrics.face_weft_strain, 1 + metrics.face_warp_strain
    with np.errstate(invalid="ignore"):
        middle = (p * p + q * q) / 2
        spread = np.hypot((p * p - q * q) / 2, p * q * np.sin(metrics.face_shear_angle))
        longest, shortest = np.sqrt(middle + spread), np.sqrt(np.maximum(middle - spread, 0))
    squeezed = ~np.isfinite(middle)
    return PieceStrain(
        stretch=np.where(squeezed, np.inf, np.maximum(longest - 1, 0)),
        ease=np.where(squeezed, 0, np.maximum(1 - shortest, 0)),
    )


def triangles_around(piece: Piece, triangle: int) -> np.ndarray:
    """The triangles (k,) of a piece that share a vertex with one of them, itself included."""
    return np.flatnonzero(np.isin(piece.faces, piece.faces[triangle]).any(axis=1))


def connected_regions(piece: Piece, members: np.ndarray) -> list[np.ndarray]:
    """The triangles of the mask members (q,) in groups that hang together by edges of the piece."""
    triangles = np.flatnonzero(members)
    neighbors = _neighbors(np.asarray(piece.faces)[triangles], len(piece.vertices))
    labels = np.arange(len(triangles))
    while True:  # each takes the lowest label around; following labels to theirs takes long ways in few rounds
        lowest = np.minimum(labels, labels[neighbors].min(axis=1))
        lowest = lowest[lowest]
        if np.array_equal(lowest, labels):
            break
        labels = lowest
    order = np.argsort(labels, kind="stable")
    starts = np.flatnonzero(np.diff(labels[order], prepend=-1))
    return [triangles[group] for group in np.split(order, starts[1:])] if len(triangles) else []


def _neighbors(faces: np.ndarray, vertex_count: int) -> np.ndarray:
    """(t,3) the triangle across each side, itself where there is none; faces (t,3)."""
    keys = edge_keys(faces[:, [0, 1, 1, 2, 2, 0]], vertex_count)
    sides = np.argsort(keys, kind="stable")
    pairs = np.flatnonzero(keys[sides][1:] == keys[sides][:-1])
    owner = np.arange(len(keys)) // 3
    across = owner.copy()
    first, second = sides[pairs], sides[pairs + 1]
    across[first], across[second] = owner[second], owner[first]
    return across.reshape(-1, 3)
