# SPDX-License-Identifier: GPL-3.0-or-later
"""What the entries of a report are called, in the panel, in sentences and in tables."""

import re
from collections.abc import Mapping
from itertools import chain
from typing import Any


def piece_name(report: dict, index: int) -> str:
    return report["pieces"][index]["name"]


def piece_names(report: dict, indices: list[int]) -> str:
    """Each piece once: "Front, Back"."""
    return ", ".join(piece_name(report, index) for index in dict.fromkeys(indices))


def joined_pieces(report: dict, seam: dict) -> str:
    """What a seam joins: "Front – Back"."""
    return " – ".join(piece_name(report, index) for index in dict.fromkeys(seam["pieces"]))


def seam_name(report: dict, seam: dict) -> str:
    """ "Seam 3: Front – Back", "Dart 4: Front"."""
    return f"{seam['name']}: {joined_pieces(report, seam)}"


def side_names(report: dict, seam: dict) -> list[str]:
    """One for each side of a seam."""
    pieces = seam["pieces"]
    if len(set(pieces)) == len(pieces):
        return [piece_name(report, piece) for piece in pieces]
    return [f"Side {number}" for number in range(1, len(pieces) + 1)]


def pieces_of_wires(report: dict) -> dict[int, list[int]]:
    """The pieces that each wire lies in."""
    pieces: dict[int, list[int]] = {wire["wire"]: [] for wire in report["wires"]}
    for piece in report["pieces"]:
        for part in piece["wires"]:
            pieces[part["wire"]].append(piece["index"])
    return pieces


def open_edges(report: dict) -> list[tuple[str, int, dict]]:
    """(name, piece, chain) of every stretch of outline that is no seam's side: hems, necklines, armholes."""
    found = []
    for piece in report["pieces"]:
        free = [chain for chain in piece["outline"] if chain["seam"] is None]
        name = f"{piece_name(report, piece['index'])}, open edge"
        found += [
            (f"{name} {number}" if len(free) > 1 else name, piece["index"], chain)
            for number, chain in enumerate(free, start=1)
        ]
    return found


def with_piece(report: dict, entry: dict[str, Any], part: str = "sentence") -> str:
    """A text of an issue or a hint, with the piece it is about in front."""
    return entry[part] if entry["piece"] is None else f"{piece_name(report, entry['piece'])}: {entry[part]}"


def rename_wires(report: dict, names: Mapping[int, str]) -> None:
    """Gives the wires these names, by their ids, wherever they stand in the report; in sentences they are quoted."""
    wires = report["wires"]
    renamed = {wire["name"]: names[wire["wire_id"]] for wire in wires}
    if all(old == new for old, new in renamed.items()):
        return
    name_of = {wire["wire"]: names[wire["wire_id"]] for wire in wires}
    for wire in chain(wires, *(piece["wires"] for piece in report["pieces"])):
        wire["name"] = name_of[wire["wire"]]
    for entry in report["issues"] + report["hints"] + report["notes"]:
        for part in {"sentence", "short", "text"} & entry.keys():
            entry[part] = _renamed(entry[part], renamed)
        for wire in entry.get("proposed_tolerances", ()):
            wire["name"] = renamed.get(wire["name"], wire["name"])


def _renamed(sentence: str, renamed: Mapping[str, str]) -> str:
    quoted = "|".join(re.escape(name) for name in renamed)
    return re.sub(f'"({quoted})"', lambda match: f'"{renamed[match[1]]}"', sentence)
