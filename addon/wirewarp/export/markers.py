# SPDX-License-Identifier: GPL-3.0-or-later
"""The marker of the last export, kept on the model: no search ends the same way twice."""

from dataclasses import asdict

import bpy

from ..blender.sealed import sealed, unsealed
from ..core import pattern
from ..names import MARKER
from .pattern_parts import Cloth, KeptMarker


def keep_marker(source: bpy.types.Object, kept: KeptMarker) -> None:
    source[MARKER] = sealed({"cloth": asdict(kept.cloth), "marker": kept.marker.to_dict()})


def marker_text(source: bpy.types.Object) -> str:
    """As it is stored; empty where there is none."""
    stored = source.get(MARKER)
    return stored if isinstance(stored, str) else ""


def kept_marker(text: str) -> KeptMarker | None:
    """Of a text of marker_text; None where that was not written by keep_marker of this version."""
    stored = unsealed(text)
    if stored is None:
        return None
    try:
        return KeptMarker(Cloth(**stored["cloth"]), pattern.Marker.from_dict(stored["marker"]))
    except (KeyError, TypeError):  # another version keeps other things
        return None
