# SPDX-License-Identifier: GPL-3.0-or-later
"""Prepares marked lines for drawing: styles, dashes, places of names, and arrows for the grain and for eases."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core import ease_text, pattern, wire_text
from ..solve.chains import EdgeMarks, chains_of_marks

# The edges of a line are sorted by distance from its middle. A name may be on the first edge of the sorted list, or on
# the edges at these shares of the list.
ALONG = (0.25, 0.5, 0.75)
# Length of an arrow's head, as a share of half the length of a grain arrow, and of the whole length of an ease arrow.
HEAD = 0.25
_TURNS = [np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) for a in np.radians(range(0, 90, 15))]
# Dashes have the lengths of their style if the object's largest dimension is this many pixels on the screen, as it
# often is.
VIEW_SIZE = 800


@dataclass(frozen=True)
class LineStyle:
    label: str
    color: tuple[float, float, float]  # sRGB, as on the screen
    width: float  # pixels at interface scale 1
    dash: tuple[float, float] | None = None  # lengths of dash and gap in pixels; the gaps show a thin line

    @property
    def line_width(self) -> float:
        return THIN if self.dash else self.width

    @property
    def rim(self) -> tuple[float, float, float]:
        """Return the color of the slightly wider line below: white around dark colors, and black around light
        colors."""
        red, green, blue = self.color
        return (1.0, 1.0, 1.0) if 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.4 else (0.0, 0.0, 0.0)


def _hex(text: str) -> tuple[float, float, float]:
    red, green, blue = (int(text[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue


THIN = 1.0  # pixels, the least width of a line on the screen
# Extra width of a rim beyond its line, in pixels (a thin edge on both sides), and opacity, so that the color dominates.
RIM, RIM_ALPHA = 1.5, 0.6
# The styles are in drawing order, so that a wire is visible on a seam or a failed area.
STYLES = {
    "failed": LineStyle("Failed", _hex("#d8001f"), 4.0),
    "proposed": LineStyle("Suggestion", _hex("#890089"), 6.0),
    "page": LineStyle("Page", _hex("#9c78fc"), 1.5),
    "cut": LineStyle("Cutting line", _hex("#99bb77"), 2.0),
    "ease": LineStyle("Side with ease", _hex("#ff4bb4"), 3.0),
    "grain": LineStyle("Grain", _hex("#0a8f7a"), 3.0),
    "default grain": LineStyle("Grain (automatic)", _hex("#7fc4b5"), 1.2),
    "allowance": LineStyle("Own allowance", _hex("#99bb77"), 9.0),  # on models, drawn under the seam or outline
    "outline": LineStyle("Outline", _hex("#786068"), 2.5),
    "seam": LineStyle("Seam", _hex("#101018"), 4.5),
    "free": LineStyle("Free wire", _hex("#4fc3f7"), 3.5, dash=(4, 8)),
    "elastic": LineStyle("Elastic wire", _hex("#ffc400"), 3.5, dash=(14, 7)),
    "rigid": LineStyle("Rigid wire", _hex("#0048e8"), 2.5),
    "selected": LineStyle("Selected", _hex("#ffffff"), 1.2),
}
CORES = {"selected"}  # drawn over a wider line, which stays visible on both sides


@dataclass(frozen=True)
class WireRun:
    """A wire with all its drawn edges. On flat pieces, an edge on a seam is drawn once on each side."""

    wire_id: int
    tolerance: float
    ease: float
    rows: np.ndarray  # (k,) rows of the drawn edges in LineEdges
    ends: np.ndarray  # (k,2,3) ends of these edges, in the direction of the wire
    offsets: np.ndarray  # (k,) length of the wire before each of these edges


def wire_runs(vertices: np.ndarray, ends: np.ndarray, marks: EdgeMarks) -> list[WireRun]:
    """Return the wires. vertices (k,2): the model's vertices of each drawn edge; ends (k,2,3): places of the ends of
    each drawn edge; marks: marks of the drawn edges."""
    marked = marks.rows
    if not len(marked):
        return []
    pairs = np.sort(vertices[marked], axis=1)
    edges, first, edge_of_row = np.unique(pairs, axis=0, return_index=True, return_inverse=True)
    in_order = np.argsort(first)  # in the order of the mesh, like the list of wires
    edges, first, edge_of_row = edges[in_order], marked[first[in_order]], np.argsort(in_order)[edge_of_row.ravel()]
    turned = np.where((vertices[:, 0] > vertices[:, 1])[:, None, None], ends[:, ::-1], ends)
    numbers, edges = np.unique(edges, return_inverse=True)
    edges, positions = edges.reshape(-1, 2), np.empty((len(numbers), 3))
    positions[edges] = turned[first]
    order = np.argsort(edge_of_row, kind="stable")
    starts = np.searchsorted(edge_of_row[order], np.arange(len(edges) + 1))
    lengths = np.linalg.norm(turned[:, 1] - turned[:, 0], axis=1)
    runs = []
    for chain in chains_of_marks(edges, marks.take(first), positions):
        along = np.cumsum(lengths[first[chain.edges]])
        sizes = [starts[edge + 1] - starts[edge] for edge in chain.edges]
        rows = np.concatenate([marked[order[starts[edge] : starts[edge + 1]]] for edge in chain.edges])
        backward = np.repeat(edges[chain.edges, 0] != chain.vertices[:-1], sizes)
        run_ends = np.where(backward[:, None, None], turned[rows][:, ::-1], turned[rows])
        offsets = np.repeat(along - lengths[first[chain.edges]], sizes)
        runs.append(WireRun(chain.wire_id, chain.tolerance, chain.ease, rows, run_ends, offsets))
    return runs


def cut_into_dashes(ends: np.ndarray, offsets: np.ndarray, dash: float, gap: float) -> np.ndarray:
    """Return the ends (2m,3) of the dashes. ends (k,2,3): ends of edges; offsets (k,): distance along the wire from its
    beginning to each edge; dash, gap: lengths in the same unit."""
    period = dash + gap
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    first = np.floor(offsets / period).astype(np.int64)
    counts = np.floor((offsets + lengths) / period).astype(np.int64) - first + 1
    line = np.repeat(np.arange(len(ends)), counts)
    number = first[line] + np.arange(len(line)) - np.repeat(np.cumsum(counts) - counts, counts)
    begin = np.maximum(number * period - offsets[line], 0)
    end = np.minimum(number * period + dash - offsets[line], lengths[line])
    seen = end > begin
    shares = np.column_stack([begin, end])[seen] / lengths[line[seen], None]
    start, way = ends[line[seen], 0], ends[line[seen], 1] - ends[line[seen], 0]
    return (start[:, None] + shares[:, :, None] * way[:, None]).reshape(-1, 3).astype(np.float32)


@dataclass(frozen=True)
class LineEdges:
    """All edges that are seams or parts of outlines or wires."""

    ends: np.ndarray  # (k,2,3) float32, in the object's own space
    normals: np.ndarray  # (k,3) float32, normals of the surface
    vertices: np.ndarray  # (k,2) int32, vertices of the model
    pieces: np.ndarray  # (k,) int32: on flat pieces, the index of the piece; in the map, its id; on the model, 0
    seams: np.ndarray  # (k,) bool, whether the edge is a seam
    seam_ids: np.ndarray  # (k,) int32, id of the edge's seam in the last run; 0 none
    outlines: np.ndarray  # (k,) bool, whether the edge has only one face
    allowances: np.ndarray  # (k,) bool, whether an edge of a model has an allowance of its own
    marks: EdgeMarks  # (k,)
    selected: np.ndarray  # (k,) bool, whether the edge is selected in Edit Mode


@dataclass(frozen=True)
class Name:
    """A text at a point of the surface."""

    texts: tuple[str, ...]  # alternatives: the first text that fits is written
    places: np.ndarray  # (c,3) possible places, the best first
    normals: np.ndarray  # (c,3) normals of the surface at these places
    reach: float  # distance from the best place to the farthest point of the named line or piece
    piece: int = 0  # piece on which the name needs room
    room: float = np.inf  # size of this piece, see Rooms; infinite on models
    around: np.ndarray | None = None  # (c,3) outermost points of the piece, for a name that fits only beside it
    is_selected: bool = False  # a name of selected edges is always written


def lines_by_kind(lines: LineEdges) -> dict[str, np.ndarray]:
    """Return the ends (2k,3) of the edges of each kind of line, two rows per edge."""
    return {kind: lines.ends[mask].reshape(-1, 3) for kind, mask in _members(lines).items() if mask.any()}


def dashes_by_kind(lines: LineEdges, runs: Sequence[WireRun]) -> dict[str, np.ndarray]:
    """Return the ends (2m,3) of the dashes, for each kind of line that has dashes."""
    if not len(lines.ends):
        return {}
    pixel = np.ptp(lines.ends.reshape(-1, 3), axis=0).max() / VIEW_SIZE
    if not 0 < pixel < np.inf:  # all points coincide, or some are not finite
        return {}
    dashes = {}
    for kind, mask in _members(lines).items():
        style = STYLES[kind]
        own = [run for run in runs if mask[run.rows[0]]]
        if style.dash and own:
            ends = np.concatenate([run.ends for run in own])
            offsets = np.concatenate([run.offsets for run in own])
            dashes[kind] = cut_into_dashes(ends, offsets, *(pixel * length for length in style.dash))
    return dashes


def _members(lines: LineEdges) -> dict[str, np.ndarray]:
    wires, tolerances = lines.marks.are_wires, lines.marks.tolerances
    return {
        "allowance": lines.allowances,
        "outline": lines.outlines & ~lines.seams,
        "seam": lines.seams,
        "rigid": wires & (tolerances == 0),
        "elastic": wires & (tolerances > 0) & np.isfinite(tolerances),
        "free": wires & np.isinf(tolerances),
        "selected": lines.selected,
    }


Rooms = Mapping[int, float]  # size of each piece: square root of the area of a box around it; empty on models


def wire_line_names(lines: LineEdges, runs: Sequence[WireRun], names: Sequence[str], rooms: Rooms) -> list[Name]:
    """Return names, with tolerance and ease, for the middle of each wire in each piece. names: name of the wire of each
    run."""
    named = []
    for run, name in zip(runs, names, strict=True):
        has_text = 0 < run.tolerance < np.inf or run.ease != 0
        text = f"{name} {wire_text(run.tolerance, run.ease)}" if has_text else name
        for piece in np.unique(lines.pieces[run.rows]).tolist():
            named.append(_name_on_line((text,), lines, run.rows[lines.pieces[run.rows] == piece], rooms))
    return named


def seam_line_names(
    lines: LineEdges, numbers: np.ndarray, texts: Callable[[int, int], tuple[str, ...]], rooms: Rooms
) -> list[Name]:
    """Return the names of each seam, one in each of its pieces.

    numbers (k,): seam of each edge, 0 for none
    texts: returns the texts of this seam in this piece, see Name
    """
    rows: dict[tuple[int, int], list[int]] = {}
    for row in np.flatnonzero(numbers).tolist():
        rows.setdefault((int(numbers[row]), int(lines.pieces[row])), []).append(row)
    return [_name_on_line(texts(number, piece), lines, np.array(own), rooms) for (number, piece), own in rows.items()]


def piece_rooms(lines: LineEdges) -> Rooms:
    """Return the room of each piece in a plane: the root of the area of the smallest box around the piece. Boxes are
    tried in steps of 15 degrees."""
    rooms = {}
    for piece in np.unique(lines.pieces).tolist():
        points = lines.ends[lines.pieces == piece].reshape(-1, 3)[:, :2]
        areas = [float(np.prod(np.ptp(points @ turn, axis=0))) for turn in _TURNS]
        rooms[piece] = min(areas) ** 0.5
    return rooms


def arrow(lines: LineEdges, piece: int, middle: np.ndarray, direction: np.ndarray, length: float) -> np.ndarray | None:
    """Return the ends (6,3) of the strokes of an arrow of at most this length, beside the name at the middle (2,) of a
    flat piece. direction: a unit vector (2,). Return None if there is no room."""
    a, b = (
        lines.ends[(lines.pieces == piece) & (lines.seams | lines.outlines)][:, :, :2].astype(np.float64).swapaxes(0, 1)
    )
    aside = np.array([direction[1], -direction[0]])
    center = middle + aside * min(_reach(middle, aside, a, b) / 2, length)
    half = min(length / 2, *(0.8 * _reach(center, way, a, b) for way in (direction, -direction)))
    if not 0 < half < np.inf:
        return None
    tip, tail = center + half * direction, center - half * direction
    heads = [tip + HEAD * half * (side * aside * 0.5 - direction) for side in (-1, 1)]
    corners = np.zeros((6, 3), dtype=np.float32)
    corners[:, :2] = [tail, tip, tip, heads[0], tip, heads[1]]
    return corners


def _reach(point: np.ndarray, way: np.ndarray, a: np.ndarray, b: np.ndarray) -> float:
    """Return the distance from a point (2,) along the unit vector `way` to the first of the segments from a (k,2) to b
    (k,2). The distance is infinite if there is no segment in this direction."""
    distances = pattern.geometry.crossings(point, way, a, b)
    return float(distances[distances > 0].min(initial=np.inf))


def _name_on_line(texts: tuple[str, ...], lines: LineEdges, rows: np.ndarray, rooms: Rooms) -> Name:
    """Return a name with places on the line of these rows, first on the edge nearest to the line's middle."""
    middles = lines.ends[rows].mean(axis=1)
    place = middles[np.argmin(np.linalg.norm(middles - middles.mean(axis=0), axis=1))]
    by_distance = np.argsort(np.linalg.norm(middles - place, axis=1), kind="stable")
    first = (np.array([0, *ALONG]) * len(rows)).astype(int)
    # In this order, the edge after each chosen edge is usually on the other side of the middle, so it is added, too.
    best = by_distance[np.unique(np.concatenate([first, first[1:] + 1]).clip(max=len(rows) - 1))]
    reach = float(np.linalg.norm(lines.ends[rows] - place, axis=2).max())
    piece = int(lines.pieces[rows[0]])
    return Name(
        texts,
        middles[best],
        lines.normals[rows[best]],
        reach,
        piece,
        rooms.get(piece, np.inf),
        is_selected=bool(lines.selected[rows].any()),
    )


SHARE = 0.25  # length of an arrow as a share of the eased line, so that the line is clearly longer
LONGEST = 0.12  # greatest length of an arrow, as a share of the object's size, so that most of the surface is visible
BEYOND = 2.2  # distance from the edge to the middle of the text, in lengths of the arrow, so that the arrow is visible


@dataclass(frozen=True)
class SideEases:
    """Edges with an ease on one side, each in the direction of the outline of the face on the eased side."""

    vertices: np.ndarray  # (k,2) int32
    ends: np.ndarray  # (k,2,3) places of the vertices
    inward: np.ndarray  # (k,3) unit vectors in the face on the eased side, away from the edge
    normals: np.ndarray  # (k,3) normals of this face
    ratios: np.ndarray  # (k,) float32, eases as fractions
    pieces: np.ndarray  # (k,) int32, index of the flat piece; 0 on the model
    size: float  # largest dimension of the object


def ease_arrows(eases: SideEases) -> tuple[np.ndarray, list[Name]]:
    """Return the ends (2k,3) of the strokes of one arrow in the middle of each eased line, and names with the eases."""
    strokes, names = [np.empty((0, 3), dtype=np.float32)], []
    for rows in _lines(eases):
        lengths = np.linalg.norm(eases.ends[rows, 1] - eases.ends[rows, 0], axis=1)
        row = rows[int(np.searchsorted(np.cumsum(lengths), lengths.sum() / 2))]
        length = min(SHARE * lengths.sum(), LONGEST * eases.size)
        base, inward = eases.ends[row].mean(axis=0), eases.inward[row]
        tip, aside = base + length * inward, np.cross(eases.normals[row], inward)
        heads = [tip + HEAD * length * (side * aside - 1.5 * inward) for side in (-1, 1)]
        strokes.append(np.array([base, tip, tip, heads[0], tip, heads[1]], dtype=np.float32))
        text, reach = ease_text(float(eases.ratios[row])), float(lengths.sum() / 2)
        place = (base + BEYOND * length * inward)[None]
        names.append(Name((text,), place, eases.normals[row][None], reach, int(eases.pieces[row])))
    return np.concatenate(strokes), names


def _lines(eases: SideEases) -> Iterator[list[int]]:
    """Yield the rows of each connected line of edges with the same ratio, in order along the outline."""
    begins = {(int(start), float(ratio)): row for row, (start, ratio) in enumerate(_keys(eases, 0))}
    after = [begins.get((int(end), float(ratio)), -1) for end, ratio in _keys(eases, 1)]
    waiting = dict.fromkeys([*sorted(set(range(len(after))) - set(after)), *range(len(after))])
    while waiting:
        row, line = next(iter(waiting)), []
        while row in waiting:
            del waiting[row]
            line.append(row)
            row = after[row]
        yield line


def _keys(eases: SideEases, end: int) -> Iterator[tuple[int, float]]:
    return zip(eases.vertices[:, end].tolist(), eases.ratios.tolist(), strict=True)
