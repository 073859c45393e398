# SPDX-License-Identifier: GPL-3.0-or-later
"""Rewrites the library's errors for users of Blender: with faces, display units, wire names and Blender's commands.

The sentences count elements, which a button selects. Reports write the name of the piece before each sentence.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from ..core import FlattenError, LengthText, counted, quoted

MOST_LISTED = 5  # maximum number of names in a list, because nobody reads longer lists


@dataclass(frozen=True)
class ErrorFacts:
    """An error of the library, and facts that only the add-on knows."""

    error: FlattenError
    faces: int  # number of the mesh's faces that contain the triangles error.faces
    flipped: int  # number of flipped faces of the piece
    overlapping: int  # number of overlapping faces of the piece
    wires: list[str]  # names of all wires, in the library's order
    lengths: LengthText
    piece: str = "the piece"  # "the piece", or the name of the piece in quotes

    def __getitem__(self, name: str) -> Any:  # noqa: ANN401
        return self.error.arguments[name]

    def get(self, name: str) -> Any:  # noqa: ANN401
        return self.error.arguments.get(name)

    @property
    def edge_text(self) -> str:
        return counted(len(self.error.edges), "edge")

    @property
    def vertex_text(self) -> str:
        return counted(len(self.error.vertices), "vertex", "vertices")

    @property
    def face_text(self) -> str:
        return counted(self.faces, "face")

    def wire_text(self, indices: list[int]) -> str:
        """Return the names of wires, such as 'wire "Hip"' or 'wires "Hip" and "Bust"'."""
        return f"wire{'s' if len(indices) > 1 else ''} {_listed([quoted([self.wires[index]]) for index in indices])}"


def _listed(words: list[str]) -> str:
    """Return "a, b and c" for three texts, and "a, b, c, d, e and 2 more" for more than five."""
    more = len(words) - MOST_LISTED
    *first, last = [*words[:MOST_LISTED], f"{more} more"] if more > 0 else words
    return f"{', '.join(first)} and {last}" if first else last


def percent(fraction: float) -> str:
    return f"{100 * fraction:.3g}%"


def error_sentence(facts: ErrorFacts) -> str:
    """Return the fault, its place and the remedy. For errors that only scripts can cause, return the library's
    sentence."""
    sentence = SENTENCES.get(str(facts.error.code))
    return sentence(facts) if sentence else facts.error.message


def _inconsistent_orientation(facts: ErrorFacts) -> str:
    fault = f"The faces at {facts.edge_text} point to opposite sides"
    if facts["is_one_sided"]:
        return f"{fault}, because the piece is one-sided like a Möbius strip. Mark these edges as seams."
    return f"{fault}. In Edit Mode, use Mesh > Normals > Recalculate Outside."


def _outline_too_short(facts: ErrorFacts) -> str:
    lengths = [facts.lengths.rough(length) for length in facts["lengths"]]
    count = len(lengths)
    if count == 1:
        fault = "The piece cannot be flattened: mark another seam"
    elif count == 2:
        fault = "The piece is a tube: mark a seam from one opening to the other"
    else:
        fault = f"The piece cannot be flattened: mark seams between its {count} openings"
    outlines = "outline is" if count == 1 else "outlines are"
    return f"{fault}. The {outlines} too short to surround the flat piece: {_listed(lengths)}."


def _infeasible_lengths(facts: ErrorFacts) -> str:
    match facts["reason"]:
        case "wires":
            method = "" if facts["is_refined"] else ", by the method Refined"
            return (
                "Not all wires of the piece can keep their lengths in the plane. It can be flattened with "
                f"{_looser(facts)}{method}."
            )
        case "stretch":
            remedy = "Use less stretch, or mark a seam" if facts["is_good_unstretched"] else "Mark a seam"
            return (
                f"No flat shape of the piece was found with the lengths that the fabric's stretch requires. {remedy}."
            )
        case "method":
            return (
                "WireWarping++ finds no flat shape for the wires of the piece. Use the method Refined, which keeps "
                "them within their tolerances."
            )
    free = ", even with its wires free" if facts["has_wires"] else ""
    return f"No flat shape of the piece was found that keeps the length of its outline{free}. Mark a seam."


def _looser(facts: ErrorFacts) -> str:
    """Return words such as 'a tolerance of 0.3% to 1.2% on wires "Hip" and "Bust" and with wire "Arm" free'."""
    proposed = facts.error.proposed_tolerances
    elastic = {wire: tolerance for wire, tolerance in proposed if not math.isinf(tolerance)}
    free = [wire for wire, tolerance in proposed if math.isinf(tolerance)]
    parts = []
    if elastic:
        limits = dict.fromkeys([percent(min(elastic.values())), percent(max(elastic.values()))])
        parts.append(f"a tolerance of {' to '.join(limits)} on {facts.wire_text(list(elastic))}")
    if free:
        parts.append(f"{facts.wire_text(free)} free")
    return " and with ".join(parts)


def _not_solvable(facts: ErrorFacts) -> str:
    match facts["reason"]:
        case "helper_wires":
            return (
                f"WireWarp cannot add helper wires between {facts.edge_text} of the piece. Use the method Refined, "
                "which needs no helper wires, or remesh the piece."
            )
        case "sizes":
            return (
                "WireWarp cannot calculate the shape of the piece, because its faces differ too much in size. At "
                f"{facts.face_text}, merge vertices that are very close together, or remesh the piece."
            )
    return "WireWarp cannot calculate the shape of the piece. Remesh it, or cut it in two with a seam."


def _wrong_option(facts: ErrorFacts) -> str:
    if facts["name"] == "thickness" and facts.error.faces:
        return (
            f"The surface curves more tightly at {facts.face_text} than a material of this thickness can. Use a "
            "smaller thickness, or smooth the surface there."
        )
    if facts["name"] == "method" and facts.error.edges:
        return (
            "WireWarping++ keeps seams and outlines at one length, but a tolerance is set for "
            f"{facts.wire_text(facts['wires'])} along them. Use the method Refined, or make such wires rigid and mark "
            "an ease."
        )
    return facts.error.message


def _also(flipped: int, overlapping: int) -> str:
    """Return words such as ", has 3 flipped faces and overlaps itself at 1 face"."""
    faults = [f"has {counted(flipped, 'flipped face')}"] if flipped else []
    faults += [f"overlaps itself at {counted(overlapping, 'face')}"] if overlapping else []
    return f", {' and '.join(faults)}" if len(faults) > 1 else f", and {faults[0]}" if faults else ""


def _lengths_not_kept(facts: ErrorFacts) -> str:
    line = facts.wire_text(facts["wires"]) if facts["wires"] else "the outline"
    if facts.get("tolerance") is not None:
        fault = f"The piece does not keep the length of {line} within its tolerance of {percent(facts['tolerance'])}"
    else:
        too = "long" if facts["difference"] > 0 else "short"
        worst = f"the worst, on {line}, is {percent(abs(facts['difference']))} too {too}"
        fault = f"The piece does not keep the length of {facts.edge_text} ({worst})"
    remedy = ", or widen the tolerance of its wires" if facts["has_wires"] else ""
    return f"{fault}{_also(facts.flipped, facts.overlapping)}. Add a seam where the piece curves most{remedy}."


def _flipped(facts: ErrorFacts) -> str:
    free = ", or remove a nearby wire or widen its tolerance" if facts["has_wires"] else ""
    fault = f"The piece is flipped at {facts.face_text}{_also(0, facts.overlapping)}"
    return f"{fault}. Add a seam or a dart there{free}."


def _no_proposal(facts: ErrorFacts) -> str:
    match facts["reason"]:
        case "unfolded":
            return "The piece is flat enough: it is unfolded without distortion."
        case "strain":
            strain, limit = percent(facts["strain"]), percent(facts["limit"])
            return f"The piece is flat enough: its stretch is {strain}, and {limit} is accepted."
        case "too_long":
            length, limit = facts.lengths.rough(facts["length"]), facts.lengths.rough(facts["limit"])
            return f"The piece can be flattened with seams of {length}, but no more than {limit} are allowed."
        case "no_set":
            return "The piece cannot be flattened, and no seams were found that flatten all of it. Mark a first seam."
        case "too_strained":
            return "Every set of seams that was found leaves a piece that stretches by over 100%. Mark a first seam."
        case "no_gain":
            kind, wires = facts["kind"], facts["wires"]
            loosen = f"loosen {facts.wire_text(wires)} or " if wires else ""
            move = "move a seam to the place where the piece curves most"
            cut = "divide the piece by a seam" if kind == "dart" else move
            return f"No {kind} helps {facts.piece}, which must stretch by {percent(facts['strain'])}: {loosen}{cut}."
    leads = "to a point inside" if facts["kind"] == "dart" else "across it"
    return (
        f"The piece has no room for a {facts['kind']}. Every line along edges {leads} meets a wire or the outline. "
        "Subdivide the piece, or mark a seam by hand."
    )


SENTENCES: dict[str, Callable[[ErrorFacts], str]] = {
    "cancelled": lambda _: "Canceled before the piece was flat. Flatten again.",
    "closed_chart": lambda _: "The piece is closed: choose where to cut it.",
    "boundary_too_short": _outline_too_short,
    "empty_mesh": lambda _: (
        "The mesh has no faces, so there is nothing to flatten. In Edit Mode, fill its outlines with "
        "faces (F, or Face > Grid Fill)."
    ),
    "flipped_faces": _flipped,
    "handles": lambda facts: (
        f"The piece has {counted(facts['num_handles'], 'handle')} like a torus. Mark seams that cut every handle."
    ),
    "inconsistent_orientation": _inconsistent_orientation,
    "infeasible_lengths": _infeasible_lengths,
    "invalid_option": _wrong_option,
    "lengths_not_kept": _lengths_not_kept,
    "loose_faces": lambda facts: (
        f"The mesh consists of {facts['num_parts']} separate parts, because faces that touch do "
        "not share edges. In Edit Mode, use Mesh > Merge > By Distance."
    ),
    "no_proposal": _no_proposal,
    "non_finite_coordinates": lambda facts: (
        f"The coordinates of {facts.vertex_text} are not numbers, or far too large. "
        f"Move or delete {'it' if len(facts.error.vertices) == 1 else 'them'}."
    ),
    "non_manifold_edge": lambda facts: (
        f"Three or more faces meet at {facts.edge_text}. Mark these edges as seams, or delete the extra faces."
    ),
    "non_manifold_vertex": lambda facts: (
        f"The piece touches itself at {facts.vertex_text} without sharing an edge. "
        "In Edit Mode, select the faces on one side there and use Mesh > Split > Selection."
    ),
    "not_solvable": _not_solvable,
    "overlapping_faces": lambda facts: (
        f"The piece overlaps itself at {facts.face_text}. Cut it in two with a seam, or add a dart there."
    ),
    "repeated_face": lambda facts: (
        f"{counted(facts.faces, 'face has', 'faces have')} the same vertices as another face. "
        "In Edit Mode, use Mesh > Delete > Only Faces."
    ),
    "repeated_vertex_in_face": lambda facts: (
        f"{counted(facts.faces, 'face uses', 'faces use')} the same vertex twice. "
        "In Edit Mode, use Mesh > Delete > Only Faces."
    ),
    "zero_area_face": lambda facts: (
        f"{counted(facts.faces, 'face has', 'faces have')} no area. In Edit Mode, use Mesh > "
        "Clean Up > Degenerate Dissolve."
    ),
}
