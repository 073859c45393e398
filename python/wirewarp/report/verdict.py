# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the verdict: which pieces can be cut, and from which fabric. Blender and the command line share the verdict."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from . import wording
from .model import ANY_FABRIC, Issue, Piece, Report, Ways
from .strain import percent_text
from .words import counted

CLOSED_CODE = "closed_chart"
SEAM_CODES = {"boundary_too_short", "handles", "infeasible_lengths", CLOSED_CODE}  # faults that a seam can fix
ANY_LIMIT = 1.0  # largest stretch of any fabric, as a fraction: to twice its length
NOT_KNOWN = Ways(across=None, along=None)
SHOWN_NAMES = 4  # largest number of names in a list, because readers need the end of the sentence, too


class Level(StrEnum):
    GOOD = "good"  # the pieces can be cut
    CAUTION = "caution"  # read the sentence before you cut
    BAD = "bad"  # do not cut


class Kind(StrEnum):
    """Kinds of verdicts, the worst first. A verdict has the worst kind of all its pieces."""

    NOT_FLATTENED = "not flattened"
    FAILED = "failed"  # a guarantee is broken
    CLOSED = "closed"  # a piece is closed and has no seam yet
    NEEDS_SEAM = "needs seam"  # a piece, such as a tube, cannot be flattened without another seam
    NO_FABRIC = "no fabric"  # a piece must stretch to more than twice its length
    BEYOND_FABRIC = "beyond fabric"  # a piece must stretch further than the chosen fabric can
    NEEDS_STRETCH = "needs stretch"  # the maximum stretch is unknown, and not every fabric stretches far enough
    NOT_AS_SEEN = "not as seen"  # modifiers or shape keys were ignored
    TOO_NARROW = "too narrow"  # pieces have no room for their allowances
    READY = "ready"  # all pieces can be cut from the chosen fabric
    READY_FOR_ANY = "ready for any fabric"

    @property
    def level(self) -> Level:
        if self in (Kind.READY, Kind.READY_FOR_ANY):
            return Level.GOOD
        return Level.BAD if self in (Kind.NOT_FLATTENED, Kind.FAILED) else Level.CAUTION


CUTTABLE = (Kind.NEEDS_STRETCH, Kind.READY, Kind.READY_FOR_ANY)  # kinds for which a fabric stretches far enough


@dataclass(frozen=True)
class Line:
    kind: Kind
    text: str


@dataclass(frozen=True)
class Verdict:
    lines: tuple[Line, ...]  # the worst first

    @property
    def kind(self) -> Kind:
        return self.lines[0].kind

    @property
    def is_ready(self) -> bool:
        return all(line.kind.level is Level.GOOD for line in self.lines)


@dataclass(frozen=True)
class _Entry:
    report: Report
    piece: Piece

    @property
    def place(self) -> str:
        return place_name(self.report, self.piece.index)


def verdict(*reports: Report) -> Verdict:
    """Return the verdict on one report, or the common verdict on all reports of a run."""
    entries = [_Entry(report, piece) for report in reports for piece in report.pieces]
    if not entries:
        return Verdict((Line(Kind.NOT_FLATTENED, wording.NOT_FLATTENED),))
    with_objects = len(reports) > 1
    by_kind: dict[Kind, list[_Entry]] = {}
    for entry in entries:
        by_kind.setdefault(_kind_of(entry), []).append(entry)
    if Kind.FAILED in by_kind:  # pieces that need seams are counted as failed; the issues name them
        by_kind[Kind.FAILED] += by_kind.pop(Kind.CLOSED, []) + by_kind.pop(Kind.NEEDS_SEAM, [])
    if Kind.NEEDS_STRETCH in by_kind:  # all pieces are cut from the same fabric, so one sentence is enough
        by_kind[Kind.NEEDS_STRETCH] += by_kind.pop(Kind.READY_FOR_ANY, [])
    whole = [report.object or "the model" for report in reports if any(issue.piece is None for issue in report.issues)]
    lines = [Line(Kind.FAILED, wording.failed_models(listed(whole, ", ")))] if whole else []
    for kind in Kind:
        own = sorted(by_kind.get(kind, []), key=lambda entry: -entry.piece.excess)
        if own:
            lines += [Line(kind, text) for text in _texts(kind, own, entries, with_objects)]
    return Verdict(tuple(lines))


def as_seen(found: Verdict, makers: Iterable[str]) -> Verdict:
    """Return the verdict with a line about ignored modifiers or shape keys, and without lines about what can be cut.
    makers: "modifiers", "shape keys" or both. Without makers, the verdict is unchanged."""
    names = list(dict.fromkeys(makers))
    if not names:
        return found
    lines = [line for line in found.lines if line.kind not in CUTTABLE]
    return Verdict((*lines, Line(Kind.NOT_AS_SEEN, wording.ignored(names))))


def with_narrow(found: Verdict, narrow: Mapping[str, Sequence[str]]) -> Verdict:
    """Return the verdict with a line about pieces without room for their allowances.

    Lines about ready pieces are left out. narrow: names of the narrow pieces, by object.
    """
    with_objects = len(narrow) > 1
    names = [_with_object(owner, name) if with_objects else name for owner, own in narrow.items() for name in own]
    if not names:
        return found
    lines = [line for line in found.lines if line.kind.level is not Level.GOOD]
    every = listed(names, "; " if with_objects else ", ")
    return Verdict((*lines, Line(Kind.TOO_NARROW, wording.too_narrow(every, len(set(names)) == 1))))


def _kind_of(entry: _Entry) -> Kind:
    piece, threads = entry.piece, entry.piece.threads
    if not piece.ok:
        return _kind_of_failed(piece, [issue for issue in entry.report.issues if issue.piece == piece.index])
    if not threads:
        if piece.needed <= ANY_FABRIC:
            return Kind.READY_FOR_ANY
        return Kind.NO_FABRIC if piece.needed > ANY_LIMIT else Kind.NEEDS_STRETCH
    over = [way for way in ("across", "along") if threads.is_over(way)]
    if any(getattr(threads.gives, way) is not None for way in over):
        return Kind.BEYOND_FABRIC
    if over:
        return Kind.NO_FABRIC if piece.needed > ANY_LIMIT else Kind.NEEDS_STRETCH
    is_any = threads.gives == NOT_KNOWN and piece.needed <= ANY_FABRIC
    return Kind.READY_FOR_ANY if is_any else Kind.READY


def _kind_of_failed(piece: Piece, issues: Sequence[Issue]) -> Kind:
    codes = {issue.code for issue in issues}
    if codes == {CLOSED_CODE}:
        return Kind.CLOSED
    # A piece with a layout counts as failed, because somebody might cut it by mistake.
    is_uncut = bool(codes) and codes <= SEAM_CODES and not piece.has_layout
    # If no seam was found that helps, the cause may also be a length of a wire or the stretch of the fabric, so the
    # piece counts as failed.
    is_helped = all(issue.proposed_seams for issue in issues if issue.code == "infeasible_lengths")
    return Kind.NEEDS_SEAM if is_uncut and is_helped else Kind.FAILED


def _texts(kind: Kind, own: list[_Entry], entries: list[_Entry], with_objects: bool) -> list[str]:
    """Return the sentences about the pieces of one kind. own: these pieces, the worst first. entries: all pieces."""
    everything = len(own) == len(entries)
    names = _names(own, with_objects)
    match kind:
        case Kind.FAILED:
            return [wording.failed(len(own), len(entries))]
        case Kind.CLOSED | Kind.NEEDS_SEAM:
            return [wording.uncut("" if everything and len(own) == 1 else names, len(own), kind is Kind.CLOSED)]
        case Kind.NO_FABRIC:
            return [wording.no_fabric(names)]
        case Kind.BEYOND_FABRIC:
            shown = [
                wording.beyond_fabric(_names([entry], with_objects), entry.piece.threads)
                for entry in own[:SHOWN_NAMES]
                if entry.piece.threads
            ]
            hidden = len(own) - len(shown)
            more = [f"And {counted(hidden, 'more piece')}"] if hidden else []
            *others, last = shown + more
            return [*others, f"{last}. {wording.BEYOND_REMEDY}"]
        case Kind.NEEDS_STRETCH:
            return [_needs_stretch(own, "" if everything else names)]
    which = f"{counted(len(own), 'piece')}, {kept_text([entry.report for entry in own])}" if everything else names
    if kind is Kind.READY_FOR_ANY:
        return [wording.ready_for_any(which)]
    unknown = [entry.piece.needed for entry in own if entry.piece.threads and entry.piece.threads.gives == NOT_KNOWN]
    return [wording.ready_for_stretch(which, max(unknown)) if unknown else wording.ready(which)]


def _needs_stretch(own: list[_Entry], names: str) -> str:
    threads = [entry.piece.threads for entry in own if entry.piece.threads]
    is_exact = kept_text([entry.report for entry in own]) == wording.EXACT
    if threads:
        stretch = wording.by_way(max(each.across for each in threads), max(each.along for each in threads))
    else:
        stretch = percent_text(max(entry.piece.needed for entry in own))
    return wording.needs_stretch(names, is_exact, stretch)


def _names(entries: Sequence[_Entry], with_objects: bool) -> str:
    every = [entry.place if with_objects else entry.piece.name for entry in entries]
    return listed(every, "; " if with_objects else ", ")


def listed(names: Iterable[str], between: str = ", ") -> str:
    """Return a text that lists each name once. Names beyond SHOWN_NAMES are only counted."""
    every = list(dict.fromkeys(names))
    shown, hidden = every[:SHOWN_NAMES], len(every) - SHOWN_NAMES
    if hidden > 0:
        return f"{between.join(shown)} and {hidden} more"
    if between != ", ":  # the names contain commas, so "and" would be ambiguous
        return between.join(shown)
    *others, last = shown
    return f"{', '.join(others)} and {last}" if others else last


def kept_text(reports: Iterable[Report]) -> str:
    """Return the words about kept lengths in these reports, EXACT or TOLERATED."""
    loose = any(wire.tolerance != 0 for report in reports if report.method != "wirewarping" for wire in report.wires)
    return wording.TOLERATED if loose else wording.EXACT


def place_name(report: Report, piece: int | None) -> str:
    """Return a text with the name of the object, and with the name of the piece if it differs."""
    return _with_object(report.object, report.object if piece is None else report.pieces[piece].name)


def _with_object(owner: str, name: str) -> str:
    return name if name == owner else f"{owner}, {name}"
