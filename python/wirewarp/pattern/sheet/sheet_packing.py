# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs pieces on few sheets, which are taped together: each piece is placed where it adds the fewest sheets.

A piece that ends in the overlap of two sheets needs only one of them.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..geometry import are_inside, sampled
from ..pattern_data import OVERLAP

# If the work on one kind of sheet would exceed this limit, which takes half a second, no further arrangement is tried.
# The work of an arrangement is the number of cells of all pieces times the number of pieces with all their turns.
MOST_WORK = 3_000_000
CELL = OVERLAP  # millimeters, approximately; the overlap of two sheets is one cell


@dataclass(frozen=True)
class Shape:
    """The cells that a piece covers, and the sheets that it needs. A sheet has n by m cells."""

    cells: np.ndarray  # (columns, rows) bool
    needed: np.ndarray  # (n, m, columns, rows) bool: the sheets that the piece needs if it begins in cell n, m


class Placed(NamedTuple):
    sheets: int
    columns: int
    corners: np.ndarray  # (p,2) lower left corners of the pieces, from the lower left corner of all sheets
    turns: list[int]  # for each piece, the index of its placed rotation


def placed_on_sheets(
    outlines: Sequence[Sequence[Sequence[np.ndarray]]],
    step: np.ndarray,
    inset: float,
    columns: Iterable[int],
    fewest: int,
) -> Placed | None:
    """Return the arrangement with the fewest sheets; None if every arrangement that is tried needs at least `fewest`
    sheets.

    Lengths are in millimeters.

    - outlines: by piece and rotation, the outlines of the piece with the lower left corner at 0, 0
    - step (2,): distance between two neighboring sheets, across and upwards
    - inset: distance between the edge of the printed area and the nearest piece; pieces are twice as far apart
    - columns: numbers of columns to try
    """
    per_sheet = np.maximum(np.rint(step / CELL), 2).astype(int)
    cell = step / per_sheet
    shapes = [[_shape(own, cell, per_sheet, inset) for own in turned] for turned in outlines]
    sizes = [turned[0].cells.shape for turned in shapes]
    orders = [
        sorted(range(len(shapes)), key=lambda k: -sizes[k][0] * sizes[k][1]),
        sorted(range(len(shapes)), key=lambda k: -sizes[k][1]),
    ]
    best, work = None, 0
    for count in columns:
        narrowest = [min(shape.cells.shape[0] for shape in turned) for turned in shapes]
        if max(narrowest) > count * per_sheet[0] + 1:  # the overlap at the edge of the last sheet is usable, too
            continue
        for order in orders:
            # Estimate the work: each rotation of each piece is tried in about as many cells as all pieces cover
            # together.
            work += sum(len(turned) for turned in shapes) * sum(width * height for width, height in sizes)
            if work > MOST_WORK:
                return best
            cells = _placed([shapes[k] for k in order], count, per_sheet, best.sheets if best else fewest)
            if cells:
                corners, turns = np.zeros((len(shapes), 2)), [0] * len(shapes)
                corners[order] = cells[1] * cell + inset
                for piece, turn in zip(order, cells[2], strict=True):
                    turns[piece] = turn
                best = Placed(cells[0], count, corners, turns)
    return best


def _placed(
    shapes: Sequence[Sequence[Shape]], columns: int, per_sheet: np.ndarray, fewest: int
) -> tuple[int, np.ndarray, list[int]] | None:
    """Return the number of sheets, the start cells (p,2) of the pieces, and the indices of their rotations. Return None
    if the pieces need at least `fewest` sheets. shapes: by piece, its shape in each rotation."""
    width = columns * per_sheet[0] + 1
    taken = np.zeros((width, 0), dtype=bool)  # cells of placed pieces
    used = np.zeros((columns, 0), dtype=bool)  # sheets with pieces
    corners, turns = [], []
    for turned in shapes:
        tallest = max(shape.cells.shape[1] for shape in turned)
        more = -(-tallest // per_sheet[1]) + 1  # rows of sheets to add, so that this piece has room above the others
        taken = np.pad(taken, ((0, 0), (0, more * per_sheet[1])))
        used = np.pad(used, ((0, 0), (0, more)))
        tried = [
            (*_best_cell(taken, used, shape, per_sheet), turn)
            for turn, shape in enumerate(turned)
            if shape.cells.shape[0] <= width
        ]
        _, y, x, turn = min(tried)
        shape, at = turned[turn], np.array([x, y])
        corners.append(at)
        turns.append(turn)
        _mark(taken, shape.cells, at)
        sheet, within = np.divmod(at, per_sheet)
        _mark(used, shape.needed[within[0], within[1]], sheet)
        if used.sum() >= fewest:
            return None
        rows = int(np.flatnonzero(used.any(axis=0)).max()) + 1
        used, taken = used[:, :rows], taken[:, : (rows * per_sheet[1] + 1)]
    return int(used.sum()), np.array(corners), turns


def _best_cell(taken: np.ndarray, used: np.ndarray, shape: Shape, per_sheet: np.ndarray) -> tuple[int, int, int]:
    """Return the least number of new sheets that a piece needs, and the lowest of its best start cells (y, x)."""
    cost = _new_sheets(used, shape.needed, per_sheet)
    collides = _collides(taken, shape.cells)
    fits = tuple(slice(min(sizes)) for sizes in zip(cost.shape, collides.shape, strict=True))
    cost = np.where(collides[fits], np.iinfo(np.int64).max, cost[fits])
    x, y = np.nonzero(cost == cost.min())
    lowest = np.lexsort((x, y))[0]
    return int(cost.min()), int(y[lowest]), int(x[lowest])


def _mark(whole: np.ndarray, part: np.ndarray, at: np.ndarray) -> None:
    """Mark the true cells of `part` in `whole`. at (2,): cell of `whole` at which the part begins."""
    target = whole[at[0] : at[0] + part.shape[0], at[1] : at[1] + part.shape[1]]
    target |= part[: target.shape[0], : target.shape[1]]


def _collides(taken: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """Return for each start cell whether the piece would overlap other pieces."""
    shape = [_quick(size) for size in taken.shape]  # where the piece does not fit, counts are wrong and not used
    product = np.fft.rfft2(taken, shape) * np.conj(np.fft.rfft2(cells, shape))
    counts = np.fft.irfft2(product, shape)
    fits = [size - own + 1 for size, own in zip(taken.shape, cells.shape, strict=True)]
    found: np.ndarray = counts[: fits[0], : fits[1]] > 0.5
    return found


def _quick(size: int) -> int:
    """Return the least number that is at least `size` and has only the prime factors 2, 3 and 5. Such sizes are fast to
    transform."""
    while True:
        rest = size
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1:
            return size
        size += 1


def _new_sheets(used: np.ndarray, needed: np.ndarray, per_sheet: np.ndarray) -> np.ndarray:
    """Return for each start cell the number of sheets that the piece needs and that are not used yet."""
    n, m, columns, rows = needed.shape
    unused = np.pad(~used, ((0, columns), (0, rows)), constant_values=True)
    windows = np.lib.stride_tricks.sliding_window_view(unused, (columns, rows))[: used.shape[0], : used.shape[1]]
    # The function tensordot() uses BLAS, which is fast.
    costs = np.tensordot(windows.astype(float), needed.astype(float), axes=([2, 3], [2, 3]))
    return costs.transpose(0, 2, 1, 3).reshape(used.shape[0] * n, used.shape[1] * m).astype(np.int64)


def _shape(outlines: Sequence[np.ndarray], cell: np.ndarray, per_sheet: np.ndarray, inset: float) -> Shape:
    points = [sampled(np.concatenate([line, line[:1]]), float(cell.min()) / 2) for line in outlines]
    high = np.max([line.max(axis=0) for line in outlines], axis=0)
    size = np.ceil((high + 2 * inset) / cell - 1e-9).astype(int)
    centers = np.stack(np.meshgrid(*(np.arange(count) + 0.5 for count in size), indexing="ij"), axis=-1)
    cells = are_inside(centers.reshape(-1, 2) * cell - inset, outlines).reshape(size)
    around = np.array([[x, y] for x in (0, 1, 2) for y in (0, 1, 2)]) * inset * (1 - 1e-9)
    border = (np.concatenate(points)[:, None] + around).reshape(-1, 2)
    cells[tuple(np.minimum((border / cell).astype(int), size - 1).T)] = True
    return Shape(cells, _needed(cells, per_sheet))


def _needed(cells: np.ndarray, per_sheet: np.ndarray) -> np.ndarray:
    """Return the array Shape.needed. A part in the first cells of a sheet is in the overlap, so the sheet before shows
    this part, too."""
    sums = np.pad(cells.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    ends = []
    for count, own in zip(cells.shape, per_sheet.tolist(), strict=True):
        begin, sheet = np.arange(own)[:, None], np.arange(-(-(count + own) // own))
        ends.append([np.clip(at - begin, 0, count) for at in (sheet * own + 1, (sheet + 1) * own)])
    (left, right), (below, above) = ends
    counts = [sums[x][:, :, y] for x, y in ((right, above), (left, above), (right, below), (left, below))]
    inside = counts[0] - counts[1] - counts[2] + counts[3]  # axes: cell and sheet across, cell and sheet upwards
    found: np.ndarray = (inside > 0).transpose(0, 2, 1, 3)
    return found
