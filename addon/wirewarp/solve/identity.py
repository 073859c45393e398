# SPDX-License-Identifier: GPL-3.0-or-later
"""Assigns ids and names to the pieces and seams of a result.

Ids on the model's edges let a seam keep its name if its index changes. Numbers of removed seams are not used again.
"""

import random
import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core import FlattenResult, SeamReport
from .arrays import FaceRegions, MeshArrays, Region, area_vectors, edge_lengths, faces_inward
from .chains import find_edges
from .limbs import limb_names

# These are the names of the negative and the positive side of each axis, as seen by the person modeled. The person
# looks toward Blender's front (-Y), so the left hand is at +X.
SIDES = (("Right", "Left"), ("Front", "Back"), ("Bottom", "Top"))
HALVES = (("Right", "Left"), ("Front", "Back"), ("Lower", "Upper"))  # words that distinguish pieces on the same side
# A piece faces one side if its mean normal has at least this length. Other pieces, such as sleeves, are named after
# their place. A band around 270 degrees of a cylinder has this length.
FACES_ONE_WAY = 0.3
WORD_ORDER = (2, 1, 0)  # order of the axes in a name, such as "Upper Front Left"
# A piece gets no word if it is closer to the middle between the outermost pieces than this share of their distance.
# Of four even rows, the middle rows get a word, because they are 0.17 from the middle.
IN_THE_MIDDLE = 0.13
# Share of the model's size. A piece closer to the model's middle that faces no side, such as a ball, is called NO_SIDE.
# Along an axis, pieces get words only if they are at least this far apart. For "Left" and "Right", see _words().
BESIDE = 0.05
ROUNDED = 3  # offsets are rounded to this number of digits, because models are seldom exactly symmetric
NO_SIDE = "Around"


def side_names(normals: np.ndarray, offsets: np.ndarray) -> list[str]:
    """Return a name for each piece, such as "Front", or "Front Left" if there is a "Front Right". Names may repeat.

    normals (p,3): mean normals, of length 1 for flat pieces
    offsets (p,3): from the middle of the model to the middle of the piece, as a share of the model's size
    """
    sides = [_side(normal, offset) for normal, offset in zip(normals, offsets, strict=True)]
    names = list(sides)
    for side in dict.fromkeys(sides):
        own = [index for index, name in enumerate(sides) if name == side]
        for index, half in zip(own, _places_on(side, offsets[own]), strict=True):
            names[index] = f"{side} {half}".rstrip()
    return _told_apart(names)


def _told_apart(names: list[str]) -> list[str]:
    """Return the names with "Left Side Front" instead of "Left Front" if there is a "Front Left"."""
    words = {name: sorted(name.split()) for name in names}
    alike = {name for name in names for other in words if other != name and words[other] == words[name]}
    return [re.sub("^(Left|Right) ", r"\1 Side ", name) if name in alike else name for name in names]


def region_side_names(regions: Sequence[str | None], normals: np.ndarray, offsets: np.ndarray) -> list[str | None]:
    """Return the name of each piece's region. If pieces share a region, add their sides, as in "Left Sleeve" and "Right
    Sleeve". normals, offsets: see side_names."""
    names = list(regions)
    for region in filter(None, dict.fromkeys(regions)):
        own = [index for index, name in enumerate(regions) if name == region]
        sides = _places_on("", offsets[own])
        if len(own) > 2:
            sides = side_names(normals[own], offsets[own])
        for index, side in zip(own, sides, strict=True):
            names[index] = f"{side} {region}".lstrip()
    return names


def _side(normal: np.ndarray, offset: np.ndarray) -> str:
    if np.linalg.norm(normal) < FACES_ONE_WAY and np.linalg.norm(offset) < BESIDE:
        return NO_SIDE
    direction = normal if np.linalg.norm(normal) >= FACES_ONE_WAY else offset
    axis = int(np.argmax(np.abs(direction)))
    return SIDES[axis][int(direction[axis] > 0)]


def _places_on(side: str, offsets: np.ndarray) -> list[str]:
    """Return words that distinguish pieces on one side by their place, such as "Upper Front". Pieces may get the same
    words.

    The words for a mirrored pair differ only in "Left" and "Right".
    """
    axes: list[int] = []
    names, spread = [""] * len(offsets), np.ptp(offsets, axis=0).round(ROUNDED)
    while True:
        further = [sorted([*axes, axis], key=WORD_ORDER.index) for axis in WORD_ORDER if axis not in axes]
        further = [each for each in further if not any(side in SIDES[axis] for axis in each)]
        choices = [(_words(each, offsets), each) for each in further]
        better = max(choices, key=lambda each: (len(set(each[0])), sum(spread[each[1]])), default=(names, axes))
        if len(set(better[0])) <= len(set(names)):
            return names
        names, axes = better


def _words(axes: Sequence[int], offsets: np.ndarray) -> list[str]:
    """Return each piece's words: one for each axis on which the piece is not near the middle of all pieces."""
    words = [""] * len(offsets)
    for axis in axes:
        low, high = offsets[:, axis].min(), offsets[:, axis].max()
        if high - low < BESIDE:  # the pieces are at the same place along this axis
            continue
        middle, near = (low + high) / 2, IN_THE_MIDDLE * (high - low)
        if axis == 0 and len(offsets) > 2:  # left and right are relative to the middle of the model
            middle, near = 0.0, BESIDE
        for index, apart in enumerate(offsets[:, axis] - middle):
            word = HALVES[axis][int(apart > 0)] if abs(apart) >= near else ""
            words[index] = f"{words[index]} {word}".strip()
    return words


def from_top(offsets: np.ndarray) -> list[int]:
    """Return the pieces from top to bottom and front to back, so that both pieces of a mirrored pair get the same
    number."""
    x, y, z = offsets.T.round(ROUNDED)
    return np.lexsort((x, np.abs(x), y, -z)).tolist()


def numbered(wanted: Sequence[str], taken: Sequence[str]) -> list[str]:
    """Return the wanted names, with numbers if several pieces would have the same name, or if a name is taken."""
    used, asked = set(taken), Counter(wanted)
    following: dict[str, int] = {}
    names = []
    for name in wanted:
        number = following.get(name, 2 if name in used else 1)
        if number == 1 and asked[name] == 1 and f"{name} 1" not in used:
            names.append(name)
        else:
            while f"{name} {number}" in used:
                number += 1
            names.append(f"{name} {number}")
            following[name] = number + 1
        used.add(names[-1])
    return names


def region_names(piece_of_face: np.ndarray, piece_count: int, regions: FaceRegions) -> list[str | None]:
    """Return, for each piece, the name of a region with most of its faces; None if there is no such region.

    A region that has most of the faces of every piece is ignored.
    """
    faces_in_piece = np.bincount(piece_of_face[regions.sample], minlength=piece_count)
    names: list[str | None] = [None] * piece_count
    for kind in (regions.materials, regions.groups):  # groups come last, because they are more specific
        for piece, name in _names_by(kind, piece_of_face, faces_in_piece):
            names[piece] = name
    return names


def _names_by(
    regions: Sequence[Region], piece_of_face: np.ndarray, faces_in_piece: np.ndarray
) -> list[tuple[int, str]]:
    """Return pairs (piece, name). If a piece has several regions, it is named after the region with the fewest
    pieces."""
    if not regions:
        return []
    counts = np.array([np.bincount(piece_of_face[each.faces], minlength=len(faces_in_piece)) for each in regions])
    carried = 2 * counts > faces_in_piece  # (regions, pieces)
    pieces_in = carried.sum(axis=1)
    carried[pieces_in == len(faces_in_piece)] = False  # a region of all pieces does not distinguish them
    best = np.argmin(np.where(carried, pieces_in[:, None], len(faces_in_piece) + 1), axis=0)
    return [(piece, regions[best[piece]].name) for piece in np.flatnonzero(carried.any(axis=0)).tolist()]


MAX_ID = 2**31 - 1  # largest value of an INT attribute


@dataclass(frozen=True)
class KnownPieces:
    ids: np.ndarray  # (f,) int32, piece ids of the model's faces; 0 on faces that have not been in a piece yet
    names: Mapping[int, str]  # names of the pieces of the last run, by id
    model_name: str  # former name of the model


@dataclass(frozen=True)
class PieceIdentity:
    piece_id: int  # random, 31 bits
    name: str  # unique among the pieces of the object


@dataclass(frozen=True)
class _Shape:
    """Measures of the pieces' shapes, one row per piece, and of their triangles."""

    triangle_areas: np.ndarray  # (m,)
    areas: np.ndarray  # (p,)
    normals: np.ndarray  # (p,3), mean normals over the area
    offsets: np.ndarray  # (p,3), middles of the pieces, from the middle of the model, as a share of its size
    places: np.ndarray  # (n,3), places of the vertices, in the same coordinates


def identify_pieces(
    result: FlattenResult, arrays: MeshArrays, known: KnownPieces, model_name: str
) -> list[PieceIdentity]:
    """Return the identity of each piece of a FlattenResult. A piece that is the whole model has the model's name."""
    count = len(result.pieces)
    piece_of_triangle = np.zeros(len(arrays.triangles), dtype=np.int64)
    for index, piece in enumerate(result.pieces):
        piece_of_triangle[piece.source_face] = index
    shape = _measure(piece_of_triangle, count, arrays)
    ids = assign_ids(piece_of_triangle, known.ids[arrays.triangle_polygons], shape.triangle_areas, count, set())
    old = [known.names.get(piece_id, "") for piece_id in ids]
    if list(known.names.values()) == [known.model_name]:
        # Old names are not used, because the former only piece may now be a part of the model, or the model may have
        # been renamed.
        old = [""] * count
    names = _first_of_each(old)
    new = [index for index in from_top(shape.offsets) if not names[index]]
    suggested = _new_names(result, arrays, piece_of_triangle, shape, model_name)
    wanted = [old[index] or suggested[index] for index in new]
    for index, name in zip(new, numbered(wanted, [name for name in names if name]), strict=True):
        names[index] = name
    return [PieceIdentity(piece_id, name) for piece_id, name in zip(ids, names, strict=True)]


def _new_names(
    result: FlattenResult, arrays: MeshArrays, piece_of_triangle: np.ndarray, shape: _Shape, model_name: str
) -> list[str]:
    """Return a name for each piece, from its region, its limb or its side. Names may repeat."""
    count = len(result.pieces)
    piece_of_face = np.zeros(len(arrays.polygon_starts), dtype=np.int64)
    piece_of_face[arrays.triangle_polygons] = piece_of_triangle
    limbs = limb_names(result, _are_darts(result.seams, arrays), shape.places, shape.offsets, shape.areas)
    regions = [own or limb for own, limb in zip(region_names(piece_of_face, count, arrays.regions), limbs, strict=True)]
    outward = -shape.normals if faces_inward(arrays) else shape.normals
    regions = region_side_names(regions, outward, shape.offsets)
    sides = side_names(outward, shape.offsets) if count > 1 else [model_name]
    return [region or side for region, side in zip(regions, sides, strict=True)]


def ids_by_face(result: FlattenResult, arrays: MeshArrays, identities: Sequence[PieceIdentity]) -> np.ndarray:
    """Return the piece ids of the model's faces, (f,) int32."""
    ids = np.zeros(len(arrays.polygon_starts), dtype=np.int32)
    for piece, identity in zip(result.pieces, identities, strict=True):
        ids[arrays.triangle_polygons[piece.source_face]] = identity.piece_id
    return ids


def assign_ids(owners: np.ndarray, ids: np.ndarray, weights: np.ndarray, count: int, taken: set[int]) -> list[int]:
    """Return, for each owner, the id with the largest weight among its elements.

    Elements are faces of pieces or edges of seams. Of owners with the same id, the heaviest keeps it. Other owners get
    new ids.

    owners, weights (k,): owner of each element, from 0 to count - 1, and its weight
    ids (k,): id of each element, 0 or less for none
    taken: other ids that new ids must not repeat
    """
    marked = ids > 0  # other values are not ids
    pairs = owners[marked].astype(np.int64) << 32 | ids[marked].astype(np.int64)
    present, place = np.unique(pairs, return_inverse=True)
    order = np.argsort(np.bincount(place, weights[marked], minlength=len(present)), kind="stable")
    carried = np.zeros(count, dtype=np.int64)
    carried[present[order] >> 32] = present[order] & 0xFFFFFFFF  # the last assignment has the largest weight and wins
    taken, given = taken | set(np.unique(ids).tolist()), set()
    assigned = carried.tolist()
    for owner in np.argsort(-np.bincount(owners, weights, minlength=count), kind="stable").tolist():
        if assigned[owner] == 0 or assigned[owner] in given:
            assigned[owner] = new_id(taken)
            taken.add(assigned[owner])
        given.add(assigned[owner])
    return assigned


def new_id(taken: Collection[int] = ()) -> int:
    """Return a random id of a piece, seam or wire, so that ids of joined and appended meshes differ."""
    while True:
        number = random.randint(1, MAX_ID)
        if number not in taken:
            return number


def _measure(piece_of_triangle: np.ndarray, count: int, arrays: MeshArrays) -> _Shape:
    vectors = area_vectors(arrays.vertices, arrays.triangles)
    triangle_areas = np.linalg.norm(vectors, axis=0)
    areas = np.bincount(piece_of_triangle, triangle_areas, minlength=count)
    centers = arrays.vertices[arrays.triangles].mean(axis=1)
    low, high = centers.min(axis=0), centers.max(axis=0)
    size = max(float(np.linalg.norm(high - low)), np.finfo(float).tiny)
    divided = np.maximum(areas, np.finfo(float).tiny)  # a piece without area fails but still has a name

    def mean(rows: np.ndarray) -> np.ndarray:
        return np.array([np.bincount(piece_of_triangle, row, minlength=count) / divided for row in rows]).T

    middle = (low + high) / 2
    offsets = mean((centers - middle).T * triangle_areas / size)
    return _Shape(triangle_areas, areas, mean(vectors), offsets, (arrays.vertices - middle) / size)


def _first_of_each(names: list[str]) -> list[str]:
    """Return the names with "" instead of repeated names, because the user may have used a name twice."""
    first = {name: index for index, name in reversed(list(enumerate(names)))}
    return [name if first[name] == index else "" for index, name in enumerate(names)]


KINDS = ("Seam", "Dart")  # each kind is numbered separately
GIVEN = re.compile(rf"({'|'.join(KINDS)}) (\d+)")  # matches a name that the user has not changed


@dataclass(frozen=True)
class KnownSeams:
    ids: np.ndarray  # (k,) int32, seam ids of the model's seam edges; 0 on edges that have not been in a seam yet
    names: Mapping[int, str]  # names of all present and former seams by id


@dataclass(frozen=True)
class SeamIdentity:
    seam_id: int  # random, 31 bits
    name: str  # unique among the seams of the object
    is_dart: bool


def identify_seams(result: FlattenResult, arrays: MeshArrays, known: KnownSeams) -> list[SeamIdentity]:
    seam_of_edge, lengths = _seam_of_edge(result.seams, arrays), edge_lengths(arrays.vertices, arrays.seams)
    inside = seam_of_edge >= 0
    taken = {*known.names, *known.ids.tolist()}
    ids = assign_ids(seam_of_edge[inside], known.ids[inside], lengths[inside], len(result.seams), taken)
    names, darts = dict(known.names), _are_darts(result.seams, arrays)
    kinds = {seam_id: KINDS[is_dart] for seam_id, is_dart in zip(ids, darts, strict=True)}
    numbers = {kind: _highest_number(kind, names, kinds) for kind in KINDS}
    identities = []
    for seam_id, is_dart in zip(ids, darts, strict=True):
        kind, given = KINDS[is_dart], GIVEN.fullmatch(names.get(seam_id, ""))
        # A seam needs a new name if it is new, if the user has cleared its name, or if it became a dart or is no longer
        # a dart.
        if not names.get(seam_id) or (given and given[1] != kind):
            numbers[kind] += 1
            names[seam_id] = f"{kind} {numbers[kind]}"
        identities.append(SeamIdentity(seam_id, names[seam_id], is_dart))
    return identities


def _highest_number(kind: str, names: Mapping[int, str], kinds: Mapping[int, str]) -> int:
    """Return the highest number in the names of this kind of seam, or the number of such seams if it is larger.

    names: of all present and removed seams, by id
    kinds: of the present seams, by id
    """
    given = {seam_id: GIVEN.fullmatch(name) for seam_id, name in names.items()}
    # If a seam becomes a dart, or a dart becomes a seam, a new seam or dart may get the number in
    # its former name.
    own = {i: match for i, match in given.items() if (match[1] if match else kinds.get(i, KINDS[0])) == kind}
    # The count includes renamed seams.
    return max([len(own), *(int(match[2]) for match in own.values() if match)])


def ids_by_edge(result: FlattenResult, arrays: MeshArrays, identities: Sequence[SeamIdentity]) -> np.ndarray:
    """Return the seam ids of the model's seam edges, (k,) int32."""
    seam_of_edge = _seam_of_edge(result.seams, arrays)
    ids = np.array([identity.seam_id for identity in identities] + [0], dtype=np.int32)
    return ids[seam_of_edge]


def _seam_of_edge(seams: Sequence[SeamReport], arrays: MeshArrays) -> np.ndarray:
    """Return, for each seam edge of the model, the index of the seam that contains it, (k,); -1 for none."""
    found = np.full(len(arrays.seams), -1, dtype=np.int64)
    if seams:
        place = find_edges(np.concatenate([seam.edges for seam in seams]), arrays.seams)
        index = np.repeat(np.arange(len(seams)), [len(seam.edges) for seam in seams])
        found[place[place >= 0]] = index[place >= 0]
    return found


def _are_darts(seams: Sequence[SeamReport], arrays: MeshArrays) -> list[bool]:
    edges = np.concatenate([arrays.seams, arrays.outline])
    unique = np.unique(np.sort(edges, axis=1), axis=0)  # an edge of the outline may be marked as a seam, too
    edges_at = np.bincount(unique.ravel(), minlength=len(arrays.vertices))
    return [_is_dart(seam, edges_at) for seam in seams]


def _is_dart(seam: SeamReport, edges_at: np.ndarray) -> bool:
    """Return whether the seam is a dart: both sides are in one piece, and an end of the seam is inside it.

    edges_at (n,): number of seam and outline edges at each vertex
    """
    if len(set(seam.pieces)) > 1:
        return False
    vertices, counts = np.unique(np.asarray(seam.edges), return_counts=True)
    return bool(np.any((counts == 1) & (edges_at[vertices] == 1)))
