# SPDX-License-Identifier: GPL-3.0-or-later
"""Marked lines as they are drawn: their looks, their runs cut into dashes, and the places of their names."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..pattern.chains import EdgeMarks, chains_of_marks
from ..words import tolerance_text

ALONG = (0.25, 0.5, 0.75)  # of the edges of a line, nearest to its middle first: where else its name may stand
VIEW_SIZE = 800  # pixels that an object is wide or high in a usual view: in it dashes have the length of their style


@dataclass(frozen=True)
class LineStyle:
    label: str
    color: tuple[float, float, float]  # as the screen shows it, sRGB
    width: float  # pixels at interface scale 1
    dash: tuple[float, float] | None = None  # lengths of dash and gap in pixels; in the gaps the line is thin

    @property
    def line_width(self) -> float:
        """Of the line that goes through."""
        return THIN if self.dash else self.width

    @property
    def rim(self) -> tuple[float, float, float]:
        """Of a line below it that is a little wider: light around dark colors and dark around light ones."""
        red, green, blue = self.color
        return (1.0, 1.0, 1.0) if 0.2126 * red + 0.7152 * green + 0.0722 * blue < 0.4 else (0.0, 0.0, 0.0)


def _hex(text: str) -> tuple[float, float, float]:
    red, green, blue = (int(text[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue


THIN = 1.0  # pixels
RIM, RIM_ALPHA = 1.5, 0.6  # of the rim: pixels wider than the line
# In the order in which they are drawn: a wire on a seam or in what failed is seen on top of it.
STYLES = {
    "failed": LineStyle("Failed", _hex("#d8001f"), 4.0),
    "proposed": LineStyle("Proposed seam", _hex("#890089"), 6.0),
    "cut": LineStyle("Line to cut", _hex("#99bb77"), 2.0),
    "outline": LineStyle("Outline", _hex("#786068"), 2.5),
    "seam": LineStyle("Seam", _hex("#101018"), 4.5),
    "free": LineStyle("Free wire", _hex("#4fc3f7"), 3.5, dash=(4, 8)),
    "elastic": LineStyle("Elastic wire", _hex("#ffc400"), 3.5, dash=(14, 7)),
    "rigid": LineStyle("Rigid wire", _hex("#0048e8"), 2.5),
    "selected": LineStyle("Selected", _hex("#ffffff"), 1.2),
}
CORES = {"selected"}  # drawn on one of the others, which is seen on both sides


@dataclass(frozen=True)
class WireRun:
    """One wire, wherever it is drawn: an edge on a seam of flat pieces has a row on either side."""

    wire_id: int
    tolerance: float
    rows: np.ndarray  # (k,) of the marked edges
    ends: np.ndarray  # (k,2,3) of these rows, turned to go along the wire
    offsets: np.ndarray  # (k,) length of wire before each row


def wire_runs(vertices: np.ndarray, ends: np.ndarray, marks: EdgeMarks) -> list[WireRun]:
    """vertices (k,2) and ends (k,2,3) of marked edges, those what is no wire left out."""
    marked = marks.rows
    if not len(marked):
        return []
    pairs = np.sort(vertices[marked], axis=1)
    edges, first, edge_of_row = np.unique(pairs, axis=0, return_index=True, return_inverse=True)
    in_order = np.argsort(first)  # of the mesh, as the list of wires has them
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
        runs.append(WireRun(chain.wire_id, chain.tolerance, rows, run_ends, offsets))
    return runs


def cut_into_dashes(ends: np.ndarray, offsets: np.ndarray, dash: float, gap: float) -> np.ndarray:
    """The ends (2m,3) of the dashes on lines (k,2,3) that begin at these offsets (k,) from the first dash."""
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
    """Every edge that is a seam, part of an outline or part of a wire."""

    ends: np.ndarray  # (k,2,3) float32, in the object's own space
    normals: np.ndarray  # (k,3) float32, of the surface
    vertices: np.ndarray  # (k,2) int32, of the model
    pieces: np.ndarray  # (k,) int32, on the flat pieces; 0 on the model
    seams: np.ndarray  # (k,) bool
    outlines: np.ndarray  # (k,) bool, has one face only
    marks: EdgeMarks  # (k,)
    selected: np.ndarray  # (k,) bool, in Edit Mode


@dataclass(frozen=True)
class Name:
    """A text at a point of the surface."""

    text: str
    places: np.ndarray  # (c,3) where it may stand, the best first
    normals: np.ndarray  # (c,3)
    reach: float  # distance from the best place to the farthest end of what it names


def lines_by_kind(lines: LineEdges) -> dict[str, np.ndarray]:
    """The ends (2k,3) of the edges of each kind that there is, two rows an edge."""
    return {kind: lines.ends[mask].reshape(-1, 3) for kind, mask in _members(lines).items() if mask.any()}


def dashes_by_kind(lines: LineEdges, runs: Sequence[WireRun]) -> dict[str, np.ndarray]:
    """The ends (2m,3) of the dashes of each kind that is drawn with dashes."""
    if not len(lines.ends):
        return {}
    pixel = np.ptp(lines.ends.reshape(-1, 3), axis=0).max() / VIEW_SIZE
    if not 0 < pixel < np.inf:  # in one place, or nowhere
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
    """A mask of each kind's edges."""
    wires, tolerances = lines.marks.are_wires, lines.marks.tolerances
    return {
        "outline": lines.outlines & ~lines.seams,
        "seam": lines.seams,
        "rigid": wires & (tolerances == 0),
        "elastic": wires & (tolerances > 0) & np.isfinite(tolerances),
        "free": wires & np.isinf(tolerances),
        "selected": lines.selected,
    }


def wire_line_names(lines: LineEdges, runs: Sequence[WireRun], names: Sequence[str]) -> list[Name]:
    """Of each wire in each piece, in the middle of it; elastic ones with their tolerance. names: one for each run."""
    named = []
    for run, name in zip(runs, names, strict=True):
        text = f"{name} {tolerance_text(run.tolerance)}" if 0 < run.tolerance < np.inf else name
        for piece in np.unique(lines.pieces[run.rows]).tolist():
            named.append(_name_on_line(text, lines, run.rows[lines.pieces[run.rows] == piece]))
    return named


def seam_line_names(lines: LineEdges, seam_of_edge: Mapping[tuple[int, int], int]) -> list[Name]:
    """The number of each seam, in all its pieces. seam_of_edge: index of the seam by an edge's vertices, ascending."""
    pairs = np.sort(lines.vertices, axis=1).tolist()
    numbers = np.array([1 + seam_of_edge.get((a, b), -1) for a, b in pairs], dtype=np.int32)
    rows: dict[tuple[int, int], list[int]] = {}
    for row in np.flatnonzero(numbers).tolist():
        rows.setdefault((int(numbers[row]), int(lines.pieces[row])), []).append(row)
    return [_name_on_line(f"Seam {number}", lines, np.array(own)) for (number, _), own in rows.items()]


def _name_on_line(text: str, lines: LineEdges, rows: np.ndarray) -> Name:
    """At the edge nearest to the mean of all, so that it is on the line, however that bends; or farther along it."""
    middles = lines.ends[rows].mean(axis=1)
    place = middles[np.argmin(np.linalg.norm(middles - middles.mean(axis=0), axis=1))]
    by_distance = np.argsort(np.linalg.norm(middles - place, axis=1), kind="stable")
    first = (np.array([0, *ALONG]) * len(rows)).astype(int)
    best = by_distance[np.unique(np.concatenate([first, first[1:] + 1]).clip(max=len(rows) - 1))]  # one to either side
    reach = float(np.linalg.norm(lines.ends[rows] - place, axis=2).max())
    return Name(text, middles[best], lines.normals[rows[best]], reach)
