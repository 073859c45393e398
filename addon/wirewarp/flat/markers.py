# SPDX-License-Identifier: GPL-3.0-or-later
"""The marker of the last export, kept on the model: no search ends the same way twice."""

import hashlib
import json
from dataclasses import asdict

import bpy

from ..core import pattern
from ..names import MARKER
from ..solve.pattern_parts import Cloth, KeptMarker

DIGEST = 64  # characters that come before the text


def keep_marker(source: bpy.types.Object, kept: KeptMarker) -> None:
    text = json.dumps({"cloth": asdict(kept.cloth), "marker": kept.marker.to_dict()})
    source[MARKER] = _digest(text) + text


def marker_text(source: bpy.types.Object) -> str:
    """As it is stored; empty where there is none."""
    stored = source.get(MARKER)
    return stored if isinstance(stored, str) else ""


def kept_marker(text: str) -> KeptMarker | None:
    """Of a text of marker_text; None where that was not written by keep_marker of this version."""
    if text[:DIGEST] != _digest(text[DIGEST:]):
        return None
    stored = json.loads(text[DIGEST:])
    try:
        return KeptMarker(Cloth(**stored["cloth"]), pattern.Marker.from_dict(stored["marker"]))
    except (KeyError, TypeError):  # another version keeps other things
        return None


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
