# SPDX-License-Identifier: GPL-3.0-or-later
"""What a cloth with a grain must give along its threads and between them, and whether it does."""

import math
from collections.abc import Sequence

import numpy as np

from ..core import Piece
from ..issues import Hint
from ..solve.arrays import MeshArrays, triangle_areas
from ..solve.flatten import ClothChoice, polygons_of
from .cloth import STRAIN_LIMIT, connected_regions, percent_text

SHARE = 0.99  # of the area of a piece: single triangles in corners ask for more than any cloth will notice
MOST = 0.25  # where it is not known what the cloth gives: as far as hardly any does, see cloth.CLOTH_LIMIT
NAMES = {"swim": "swimwear", "custom": "cloth"}  # in sentences, where it is not the library's own
BEYOND_CLOTH = "beyond_cloth"


def threads_of(piece: Piece, arrays: MeshArrays, cloth: ClothChoice) -> dict:
    """For the report, of a piece with a layout: figures that all but a hundredth of its area stays below.

    across, along: by how much threads are stretched; shear: radians by which they leave the right angle; gives: what
    the cloth does, null where it is not known; worn: by how much it is to be stretched anyway; over: whether it gives
    too little.
    """
    areas, metrics = triangle_areas(arrays.vertices, arrays.triangles[piece.source_face]), piece.metrics
    needs = {
        "across": max(_widespread(metrics.face_weft_strain, areas), 0.0),
        "along": max(_widespread(metrics.face_warp_strain, areas), 0.0),
        "shear": _widespread(np.abs(metrics.face_shear_angle), areas),
    }
    gives = {"across": cloth.gives_across or None, "along": cloth.gives_along or None}
    worn = {"across": max(cloth.worn_across, 0.0), "along": max(cloth.worn_along, 0.0)}
    over = any(needs[way] > (gives[way] or MOST + worn[way]) for way in gives)
    return {"cloth": NAMES.get(cloth.name, cloth.name), **needs, "gives": gives, "worn": worn, "over": over}


def _widespread(values: np.ndarray, areas: np.ndarray) -> float:
    order = np.argsort(values)
    below = np.cumsum(areas[order])
    return float(values[order[min(np.searchsorted(below, SHARE * below[-1]), len(order) - 1)]])


def needs_text(threads: dict) -> str:
    """ "4.0% across, 2.0% along, shear 18°"."""
    shares = (f"{percent_text(threads[way])} {way}" for way in ("across", "along"))
    return f"{', '.join(shares)}, shear {math.degrees(threads['shear']):.0f}°"


def gives_text(threads: dict) -> str:
    """ "this woven gives 3.0%", or what is known of it."""
    gives = {way: percent_text(share) for way, share in threads["gives"].items() if share is not None}
    if not gives:
        return "hardly any cloth gives that"
    is_alike = len(gives) == 2 and len(set(gives.values())) == 1
    shares = gives["across"] if is_alike else " and ".join(f"{text} {way}" for way, text in gives.items())
    return f"this {threads['cloth']} gives {shares}"


def beyond_text(name: str, threads: dict) -> str:
    """ "Front: 4.0% across, 2.0% along, shear 18°: this woven gives 3.0%: needs a dart"."""
    return f"{name}: {needs_text(threads)}: {gives_text(threads)}: needs a dart"


def ready_words(threads: Sequence[dict]) -> str:
    """From which cloth good pieces may be cut."""
    if all(share is not None for each in threads for share in each["gives"].values()):
        return "Ready to cut"
    across, along = (percent_text(max(each[way] for each in threads)) for way in ("across", "along"))
    return f"Ready to cut, from {threads[0]['cloth']} that gives {across} across and {along} along"


def thread_hints(pieces: Sequence[Piece], threads: Sequence[dict | None], arrays: MeshArrays) -> list[Hint]:
    """Where the threads must give most of each piece in which that is too much. threads: None for one that failed."""
    return [
        _hint(index, piece, own, arrays)
        for index, (piece, own) in enumerate(zip(pieces, threads, strict=True))
        if own and any(own[way] > _limit(own, way) for way in own["gives"])
    ]


def _limit(threads: dict, way: str) -> float:
    """From which on a dart is worth a thought."""
    return threads["gives"][way] or STRAIN_LIMIT + threads["worn"][way]


def _hint(index: int, piece: Piece, threads: dict, arrays: MeshArrays) -> Hint:
    """At the place where a dart would have most to take up."""
    strains = {"across": piece.metrics.face_weft_strain, "along": piece.metrics.face_warp_strain}
    beyond = np.max([strain - _limit(threads, way) for way, strain in strains.items()], axis=0)
    amounts = beyond * triangle_areas(arrays.vertices, arrays.triangles[piece.source_face])
    worst = max(connected_regions(piece, beyond > 0), key=lambda members: float(amounts[members].sum()))
    is_known = any(share is not None for share in threads["gives"].values())
    short = f"{needs_text(threads)}: {gives_text(threads)}" if is_known else needs_text(threads)
    return Hint(
        BEYOND_CLOTH,
        f"{short}. Needs a dart or seam here." if is_known else f"{short}. A dart or seam here would spare the cloth.",
        short=short,
        piece=index,
        faces=polygons_of(arrays, np.asarray(piece.source_face)[worst]),
    )
