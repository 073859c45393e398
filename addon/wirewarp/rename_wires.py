# SPDX-License-Identifier: GPL-3.0-or-later
"""A report follows the names of its wires, which the user may change after the run. No Blender in here."""

import re
from collections.abc import Mapping
from itertools import chain


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
