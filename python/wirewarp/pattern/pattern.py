# SPDX-License-Identifier: GPL-3.0-or-later
"""Defines a pattern, with the methods that make, change, lay out and write it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack, get_args

import numpy as np
import numpy.typing as npt

from .checks import checked_length, checked_names, problem
from .formats import writing
from .formats.pdf import page_sizes
from .formats.svg import page_size
from .label.card import with_card, with_card_anew
from .make.copies import copied_sides, copies_of, drawn_once
from .make.fold import unfolded
from .make.marks import marks, walks_of
from .make.notches import check_spacing
from .make.outline import FlatPiece, Side, flat_piece
from .make.pieces import finished, joined_by, lay_all, notes_on_sides, outlined, warnings_of
from .make.seams import sewn_sides
from .make.sewing import sewing_steps
from .make.widths import Widths
from .marker import Marker, at_corner
from .model import PatternPiece, short_name
from .nest.items import Grain
from .nest.nesting import Cloth, Preview, nesting
from .options import PatternOptions
from .pattern_data import PatternData, Written
from .progress import Progress, Steps, in_one_go
from .sheet.papers import Page
from .sheet.plan import plan
from .units import Units, UnitSystem

if TYPE_CHECKING:
    from .._wirewarp import FlattenResult


@dataclass(frozen=True)
class Pattern(PatternData):
    """A sewing pattern, with methods that make, change, nest and write the pattern."""

    @classmethod
    def from_result(
        cls,
        result: "FlattenResult",
        *,
        piece_names: Sequence[str] | None = None,
        millimeters_per_unit: float = 1000.0,
        progress: Progress | None = None,
        **options: Unpack[PatternOptions],
    ) -> "Pattern":
        """Return the pattern of a result. No piece may have failed.

        - options: see PatternOptions
        - progress(stage, fraction): called about ten times a second; returns False to cancel

        Raises FlattenError for bad input or a failed piece, or with the code "cancelled".
        """
        scale = checked_length("millimeters_per_unit", millimeters_per_unit, 1e-9, 1e9)
        names = checked_names(piece_names, len(result.pieces))
        for name, piece in zip(names, result.pieces, strict=True):
            if piece.error is not None:
                raise problem(f'"{name}" is not ready to cut: {piece.error.message}', piece.error.code)
        pieces = [flat_piece(piece, name, scale) for piece, name in zip(result.pieces, names, strict=True)]
        seam_names = [f"Seam {number}" for number in range(1, len(result.seams) + 1)]
        wires = enumerate(result.wires, start=1)
        rigid = [
            (wire.name or f"Wire {number}", wire.length_3d * scale) for number, wire in wires if not wire.tolerance
        ]
        options.setdefault("measures", rigid)
        return cls.from_pieces(pieces, seam_names, progress=progress, **options).arranged()

    @classmethod
    def from_pieces(
        cls,
        pieces: Sequence[FlatPiece],
        seam_names: Sequence[str],
        *,
        progress: Progress | None = None,
        **options: Unpack[PatternOptions],
    ) -> "Pattern":
        """Return the pattern of flat pieces, for example of pieces that were edited after flatten().

        The pieces keep their relative places, with the lower left corner at 0, 0. seam_names: by the index of the seam.
        """
        return in_one_go(cls.making(pieces, seam_names, **options), progress)

    @classmethod
    def making(
        cls,
        pieces: Sequence[FlatPiece],
        seam_names: Sequence[str],
        *,
        title: str = "",
        allowance: float = 10.0,
        allowances: npt.ArrayLike | None = None,
        side_allowances: npt.ArrayLike | None = None,
        folds: npt.ArrayLike | None = None,
        hem: float | None = None,
        pairs: bool = False,
        on_fold: bool = False,
        measures: Sequence[tuple[str, float]] = (),
        notch_spacing: float = 100.0,
        corner: str = "auto",
        darts: str = "close",
        material: str = "",
        date: str = "",
        units: Units = "metric",
    ) -> Steps["Pattern"]:
        """Do the work of from_pieces() in steps, for programs such as a GUI that must react between two steps."""
        if units not in get_args(Units):
            raise problem(f"units is {units!r}: give 'metric' or 'imperial'.")
        if not all(isinstance(text, str) for text in (title, material, date)):
            raise problem("title, material and date must be texts.")
        laid = yield from lay_all(pieces, Widths(allowance, hem, allowances, side_allowances, folds), corner, darts)
        loops = [loop for piece in laid for loop in piece.loops]
        seams = sewn_sides(loops, len(seam_names))
        check_spacing(checked_length("notch_spacing", notch_spacing, 0, math.inf), seam_names, seams)
        system = UnitSystem(units)
        copies = copies_of(laid, [outlined(own) for own in laid], pairs, on_fold)
        seams = sewn_sides(loops, len(seam_names), copies.starts)
        copied = copied_sides(copies, laid, seams)
        points = marks(laid, seams, copied.groups, notch_spacing)
        joined, notes = joined_by(laid), notes_on_sides(seams, system)

        def described(side: Side) -> dict[str, str]:
            """Return name, joined pieces and note of a side. A side that is drawn for several copies has the names of
            all their seams, such as "Seam 3 / 5"."""
            by_seam = {own.seam: own for own in copied.copies(side) if own.seam is not None}
            first, *others = (seam_names[seam] for seam in by_seam)
            names = [first, *(others if short_name(first) == first else map(short_name, others))]
            partners = [name for seam, own in by_seam.items() for name in joined[seam] if name != laid[own.piece].name]
            own_notes = [notes.get(id(own), "") for own in by_seam.values()]
            each = [f"{short_name(name)}: {note}" for name, note in zip(names, own_notes, strict=True) if note]
            note = own_notes[0] if len(set(own_notes)) == 1 else "; ".join(each)
            return {"name": " / ".join(names), "joins": " – ".join(dict.fromkeys(partners)), "note": note}

        done = []
        for own in laid:
            yield "marks and lines", own.index / len(laid)
            done.append(finished(own, points[own.index], described, material))
        drawn, walks = drawn_once(done, copies), walks_of(laid, seam_names, seams, points)
        warnings = [warning for own in laid for warning in warnings_of(own)]
        low = np.min([piece.bounds[0] for piece in drawn], axis=0)
        moved = [piece.moved(-low) for piece in drawn]
        steps = yield from sewing_steps(laid, seams, seam_names)
        made = cls(title, moved, system, warnings, date, walks, steps, list(measures))
        return (yield from made._adding_cards())

    @classmethod
    def of_cut_lines(
        cls,
        pieces: Sequence[FlatPiece],
        *,
        allowance: float = 10.0,
        allowances: npt.ArrayLike | None = None,
        side_allowances: npt.ArrayLike | None = None,
        folds: npt.ArrayLike | None = None,
        pairs: bool = False,
        on_fold: bool = False,
        darts: str = "close",
        units: Units = "metric",
    ) -> "Pattern":
        """Return a pattern with lines but without texts and marks, and with the pieces in their places.

        This is faster than from_pieces(), and enough to show cutting lines and pages.
        """
        widths = Widths(allowance, None, allowances, side_allowances, folds)
        laid = in_one_go(lay_all(pieces, widths, "auto", darts))
        lined = [outlined(own) for own in laid]
        return cls("", drawn_once(lined, copies_of(laid, lined, pairs, on_fold)), UnitSystem(units))

    def _adding_cards(self) -> Steps["Pattern"]:
        """Return the pattern with numbered pieces and with their texts, in steps."""
        count = len(self.pieces)
        pieces: list[PatternPiece] = []
        for number, piece in enumerate(self.pieces, start=1):
            yield "texts", len(pieces) / count
            pieces.append(with_card(piece, number, count, self.heading, self.units))
        return replace(self, pieces=pieces)

    def with_quantities(self, quantities: Mapping[int, tuple[int, int]]) -> "Pattern":
        """Return the pattern with other quantities of some pieces.

        quantities: number of copies as drawn and number of mirrored copies, by the number of the piece. Raises
        FlattenError for unknown pieces and invalid quantities.
        """
        unknown = set(quantities) - {piece.number for piece in self.pieces}
        if unknown:
            raise problem(f"Piece {min(unknown)} does not exist: there are {len(self.pieces)} pieces.")
        for number, counts in quantities.items():
            if len(counts) != 2 or any(type(count) is not int or count < 0 for count in counts) or not any(counts):
                raise problem(f"The quantity of piece {number} is {counts!r}: give two whole numbers, not both 0.")
        pieces = [replace(piece, quantity=quantities.get(piece.number, piece.quantity)) for piece in self.pieces]
        return in_one_go(replace(self, pieces=pieces)._adding_cards())

    def nested(
        self,
        width: float,
        length: float | None = None,
        *,
        progress: Progress | None = None,
        **options: Any,  # noqa: ANN401
    ) -> Marker:
        """Do the work of nesting() in one call. progress("nesting", fraction) is called about ten times a second.

        If `progress` returns False, the best marker so far is returned; without a marker, FlattenError ("cancelled") is
        raised.
        """
        return in_one_go(self.nesting(width, length, **options), progress)

    def nesting(
        self,
        width: float,
        length: float | None = None,
        *,
        gap: float = 5.0,
        grain: Grain = "one way",
        times: int = 1,
        seconds: float = 10.0,
        preview: Preview | None = None,
    ) -> Steps[Marker]:
        """Find the marker that uses the least fabric, in steps. On a roll, spyrrow is used if it is installed.

        The marker has every piece in its quantity on one layer of fabric. Pieces on the fold are opened. Save the
        marker, because another search may find other places. Lengths are in millimeters.

        - width: usable width of the fabric
        - length: length of a sheet; None for a roll, whose length is the result
        - gap: smallest distance between pieces
        - grain="one way": all pieces are upright
        - grain="both ways": pieces may turn by 180 degrees
        - grain="free": pieces may turn by any angle
        - times: number of copies of the whole pattern
        - seconds: duration of the search; 0 returns the first marker found
        - preview: called with each better marker

        Raises FlattenError for bad input and for a piece that is too large for the fabric.
        """
        whole = [at_corner(unfolded(piece) if piece.on_fold else piece) for piece in self.pieces]
        return nesting(whole, Cloth(width, length, gap, grain), times, seconds, self.units, preview)

    def laid_on(self, marker: Marker) -> "Pattern":
        """Return a pattern that shows the marker. It has a piece for each copy on the marker, at the place of the copy.

        Raises FlattenError if the marker was made from other pieces, or if this pattern already has a marker.
        """
        if self.marker:
            raise problem("The pattern is already laid out on a marker.")
        card = len(self.pieces), self.heading, self.units
        whole = [at_corner(with_card_anew(unfolded(piece), *card) if piece.on_fold else piece) for piece in self.pieces]
        if not marker.is_of(whole):
            raise problem("The pieces have changed since the marker was made: nest them again.")
        # Texts beside a piece are removed, because they could overlap other pieces.
        by_number = {piece.number: piece.without_texts_beside() for piece in whole}
        laid = [
            replace(by_number[placement.piece], quantity=(1, 0)).placed(marker.motion(placement))
            for placement in marker.placements
        ]
        return replace(self, pieces=laid, marker=marker, warnings=[*self.warnings, *marker.warnings])

    def page_sizes(self, paper: str | float | None = None, **options: bool) -> list[np.ndarray]:
        """Return width and height (2,) in millimeters of each page of the PDF that write() makes with these options.

        Raises FlattenError for a pattern that does not fit on the paper.
        """
        return page_sizes(self, paper, **options)

    def pages(self, paper: str | float | None = None, keep_places: bool = False) -> tuple["Pattern", list[Page]]:
        """Return the pattern as placed on the pages of a PDF with these options, and the pages.

        Raises FlattenError for a pattern that does not fit on the paper.
        """
        planned = plan(self, paper, keep_places)
        return planned.pattern, [Page(sheet.name, sheet.low, sheet.size) for sheet in planned.sheets]

    @property
    def svg_size(self) -> np.ndarray:
        """Return width and height (2,) of an SVG file in millimeters, including the test square."""
        return page_size(self)

    def write(
        self,
        path: str | Path,
        *,
        progress: Progress | None = None,
        **options: Any,  # noqa: ANN401
    ) -> Written:
        """Write a file in the format of its suffix. The file is read again and checked before it replaces an old file.

        docs/pattern.md describes the options:

        - .pdf: `paper`, `proof` and `keep_places`
        - .svg: `preset`
        - .dxf: `dialect` and `control_square`
        - all: progress(stage, fraction), called about ten times a second; returns False to cancel

        After an error, an existing file is unchanged. Raises:

        - FlattenError: bad options, a pattern that does not fit on the paper, or the code "cancelled"
        - OSError: the path cannot be written
        - RuntimeError: the written file differs from the pattern
        """
        return in_one_go(self.writing(path, **options), progress)

    def writing(self, path: str | Path, **options: Any) -> Steps[Written]:  # noqa: ANN401
        """Do the work of write() in steps. If close() ends the steps early, an existing file is not changed."""
        return writing(self, Path(path), options)
