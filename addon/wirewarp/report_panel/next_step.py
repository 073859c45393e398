# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user does best after a run: one button, which does it and flattens again."""

from collections.abc import Sequence
from typing import NamedTuple

from ..core import BEYOND_FABRIC, CLOSED_CODE, STRAINED, Issue, percent_text
from ..solve.report import ObjectReport, UvSeams
from ..words import counted

MEND = "object.wirewarp_mend"
SHOW = "mesh.wirewarp_select_result"
# By the kind of proposal, the most needed first: what its button says, and does.
REMEDIES = {
    "SEAMS": ("Mark and Flatten", "EDGESEL"),
    "TOLERANCES": ("Loosen and Flatten", "FIXED_SIZE"),
    "DISSOLVE": ("Dissolve and Flatten", "X"),
    "MERGE": ("Merge and Flatten", "AUTOMERGE_ON"),
    "NORMALS": ("Recalculate Normals and Flatten", "NORMALS_FACE"),
}
APPLY_FIRST = "The fix is about edges that modifiers make. Mark others on the model, or:"
CHECK = "object.wirewarp_check"
FAULTY_CODES = {"non_manifold_edge", "repeated_face", "repeated_vertex_in_face"}  # with the buttons of Check and Repair
OF_CODES = {"zero_area_face": "DISSOLVE", "loose_faces": "MERGE", "inconsistent_orientation": "NORMALS"}


class NextStep(NamedTuple):
    sentence: str  # why; "" where the verdict has said it
    text: str
    icon: str
    operator: str
    settings: dict


def next_step(report: ObjectReport, left_out: list[str], *, has_suggestions: bool = False) -> NextStep | None:
    """None if the pieces may be cut, or if suggestions, whose buttons are below, are the next step.

    left_out: see as_seen, of the model as it is now.
    """
    remedies = [remedy_of(issue) for issue in report.issues]
    if report.with_modifiers and any(remedies):
        return NextStep(APPLY_FIRST, "Apply Modifiers and Flatten", "MODIFIER", MEND, {"what": "APPLY"})
    if report.uv_seams and report.uv_seams.is_good:
        return uv_step(report.uv_seams)
    for what, (text, icon) in REMEDIES.items():
        if what not in remedies:
            continue
        is_closed = {issue.code for issue in report.issues if remedy_of(issue) == what} == {CLOSED_CODE}
        if what == "SEAMS" and (has_suggestions or is_closed):  # one slit opens a closed model, and does no more
            return None
        return NextStep(_reason(report.issues, what), text, icon, MEND, {"what": what})
    if {issue.code for issue in report.issues} & FAULTY_CODES and not report.with_modifiers:
        return NextStep("", "Check and Repair", "TOOL_SETTINGS", CHECK, {})
    if report.issues:
        return _show("ISSUE", "Show Failed Place", _shown(report, report.issues))
    if left_out:
        return NextStep("", "Flatten with Modifiers", "MODIFIER", MEND, {"what": "MODIFIERS"})
    is_strained = any(piece.is_strained for piece in report.pieces)
    return _show("HINT", "Show Strained Place", _strained_places(report)) if is_strained else None


def uv_step(found: UvSeams) -> NextStep:
    """To mark the seams of the UV map, with what became of trying them."""
    became = f"{found.failed} of them fail" if found.failed else f"stretch {percent_text(found.stretch)}"
    sentence = f"The seams of the UV map make {counted(found.pieces, 'piece')}, {became}."
    return NextStep(sentence, "Use UV Map Seams", "UV", MEND, {"what": "UV_SEAMS"})


def wants_seams(report: ObjectReport) -> bool:
    """Whether Suggest Seams is a way out."""
    return not report.with_modifiers and any(issue.proposed_seams for issue in report.issues)


def piece_to_cut(report: ObjectReport, step: NextStep | None) -> int | None:
    """The piece that darts or seams are suggested for beside the next step: where there is none, the worst."""
    if step:
        return report.hints[step.settings["index"]].piece if step.settings.get("what") == "HINT" else None
    strained = [piece for piece in report.pieces if piece.is_strained]
    return max(strained, key=lambda piece: piece.needed).index if strained else None


def _show(what: str, text: str, places: list[int]) -> NextStep | None:
    """The first of these lines of the report."""
    return NextStep("", text, "RESTRICT_SELECT_OFF", SHOW, {"what": what, "index": places[0]}) if places else None


def _shown(report: ObjectReport, entries: Sequence[Issue]) -> list[int]:
    """Those that have a place, in their order: the worst first."""
    return [index for index, entry in enumerate(entries) if is_shown(report, entry)]


def _strained_places(report: ObjectReport) -> list[int]:
    """Of the worst piece, the largest first: the very worst may be a single face, in which nobody finds the way."""
    hints = report.hints
    places = [index for index in _shown(report, hints) if hints[index].code in {STRAINED, BEYOND_FABRIC}]
    own = [index for index in places if hints[index].piece == hints[places[0]].piece]
    return sorted(own, key=lambda index: -len(hints[index].faces))


def remedy_of(issue: Issue) -> str | None:
    """The kind of fix."""
    if issue.proposed_seams:
        return "SEAMS"
    return "TOLERANCES" if issue.proposed_tolerances else OF_CODES.get(issue.code)


def is_shown(report: ObjectReport, entry: Issue) -> bool:
    """Whether an issue or a hint has a place that can be selected: made by modifiers, on its flat piece only."""
    if not entry.has_place:
        return False
    if not report.with_modifiers:
        return True
    return entry.piece is not None and report.pieces[entry.piece].has_layout


def _reason(issues: Sequence[Issue], what: str) -> str:
    if what == "SEAMS":
        edges = {
            (min(edge), max(edge)) for issue in issues for edge in issue.proposed_seams
        }  # mirrored pieces share theirs
        return f"Suggested seam: {counted(len(edges), 'edge')}."
    if what == "TOLERANCES":
        wires = {wire.name for issue in issues for wire in issue.proposed_tolerances}
        return f"Suggestion: loosen {counted(len(wires), 'wire')}."
    return ""
