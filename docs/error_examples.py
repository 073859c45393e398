# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists example values for every error sentence of the add-on.

The page on errors shows the sentences. A test checks that no sentence is missing.
"""

import math
from types import ModuleType
from typing import Any

WIRES = ["Hip", "Bust"]
Example = tuple[str, dict[str, Any], dict[str, int], dict[str, Any]]
PROPOSED = {"proposed_seams": [(0, 1)]}
# An example has the code, its arguments, numbers of faces that only the add-on knows, and the elements of the error.
EXAMPLES: list[Example] = [
    ("empty_mesh", {}, {}, {}),
    ("non_finite_coordinates", {}, {}, {"vertices": [1, 2]}),
    ("loose_faces", {"num_parts": 1200}, {}, {}),
    ("repeated_vertex_in_face", {}, {"faces": 2}, {}),
    ("repeated_face", {}, {"faces": 2}, {}),
    ("zero_area_face", {}, {"faces": 2}, {}),
    ("non_manifold_edge", {}, {}, {"edges": [(0, 1), (1, 2)]}),
    ("non_manifold_vertex", {}, {}, {"vertices": [1]}),
    ("inconsistent_orientation", {"is_one_sided": False}, {}, {"edges": [(0, 1)]}),
    ("inconsistent_orientation", {"is_one_sided": True}, {}, {"edges": [(0, 1)]}),
    ("closed_chart", {}, {}, PROPOSED),
    ("handles", {"num_handles": 1}, {}, PROPOSED),
    ("boundary_too_short", {"lengths": [0.25]}, {}, PROPOSED),
    ("boundary_too_short", {"lengths": [0.31, 0.28]}, {}, PROPOSED),
    ("boundary_too_short", {"lengths": [0.31, 0.28, 0.2]}, {}, PROPOSED),
    ("infeasible_lengths", {"reason": "wires", "is_refined": True}, {}, {"proposed_tolerances": [(0, 0.012)]}),
    ("infeasible_lengths", {"reason": "wires", "is_refined": True}, {}, {"proposed_tolerances": [(1, math.inf)]}),
    ("infeasible_lengths", {"reason": "outline", "has_wires": True}, {}, PROPOSED),
    ("infeasible_lengths", {"reason": "stretch", "is_good_unstretched": True}, {}, PROPOSED),
    ("infeasible_lengths", {"reason": "stretch", "is_good_unstretched": False}, {}, PROPOSED),
    ("infeasible_lengths", {"reason": "method"}, {}, {}),
    ("not_solvable", {"reason": "sizes"}, {"faces": 2}, {}),
    ("not_solvable", {"reason": "precision"}, {}, {}),
    ("not_solvable", {"reason": "helper_wires"}, {}, {"edges": [(0, 1)]}),
    ("cancelled", {}, {}, {}),
    ("invalid_option", {"name": "thickness"}, {"faces": 3}, {"faces": [0]}),
    ("invalid_option", {"name": "method", "wires": [0]}, {}, {"edges": [(0, 1)]}),
    ("lengths_not_kept", {"wires": [], "difference": 0.004, "has_wires": True}, {}, {"edges": [(0, 1)]}),
    ("lengths_not_kept", {"wires": [0], "tolerance": 0.03, "has_wires": True}, {}, {"edges": [(0, 1)]}),
    ("flipped_faces", {"has_wires": True}, {"faces": 2}, PROPOSED),
    ("overlapping_faces", {}, {"faces": 2}, PROPOSED),
    ("no_proposal", {"reason": "unfolded"}, {}, {}),
    ("no_proposal", {"reason": "strain", "strain": 0.004, "limit": 0.005}, {}, {}),
    ("no_proposal", {"reason": "too_long", "length": 0.4, "limit": 0.15}, {}, {}),
    ("no_proposal", {"reason": "no_set"}, {}, {}),
    ("no_proposal", {"reason": "too_strained"}, {}, {}),
    ("no_proposal", {"reason": "no_gain", "kind": "dart", "strain": 0.149, "wires": [0]}, {}, {}),
    ("no_proposal", {"reason": "no_gain", "kind": "seam", "strain": 0.149, "wires": [0]}, {}, {}),
    ("no_proposal", {"reason": "no_room", "kind": "dart"}, {}, {}),
]


def example_sentence(library: ModuleType, sentences: ModuleType, example: Example) -> str:
    """Return the add-on's sentence for an example. sentences: the add-on's module solve.error_sentences."""
    code, arguments, facts, elements = example
    error = library.FlattenError(code, "", **elements, arguments=arguments)
    counts = [facts.get(name, 0) for name in ("faces", "flipped", "overlapping")]
    units = library.report.LengthText("mm", 1000.0)
    return sentences.error_sentence(sentences.ErrorFacts(error, *counts, WIRES, units))
