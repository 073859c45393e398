# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the last suggested cuts of each object, checks if they are current, and reads areas painted against cuts."""

from dataclasses import dataclass, replace
from typing import Literal

import bpy
import numpy as np

from ..blender.mesh import groups_of, read_attribute
from ..issues import ObjectError, object_error
from ..names import NO_SEAM
from ..solve.flatten import FlattenChoices
from ..solve.suggest import Cut, NoSeam, Target
from .changes import has_changed
from .memory import Take, kept, note, state_of

NUMBERS = ("BOOLEAN", "INT8", "INT", "FLOAT")
OTHER_KIND = (
    'The attribute "{}" of mesh "{}" is not of type BOOLEAN, INT8, INT or FLOAT on faces. '
    "Rename or delete it under Object Data > Attributes."
)


def read_no_seam(source: bpy.types.Object, modified: bpy.types.Mesh | None = None) -> NoSeam:
    """Return the painted areas of the object's own mesh in Object Mode, or of the mesh with modifiers. Raises
    ObjectError if the attribute has another type or domain."""
    mesh = modified or source.data
    group = source.vertex_groups.get(NO_SEAM)
    found = (read_attribute(mesh, NO_SEAM, kind, "FACE") for kind in NUMBERS)
    values = next((each for each in found if each is not None), None)
    if values is None:
        if NO_SEAM in mesh.attributes:
            raise object_error("attribute_type", OTHER_KIND.format(NO_SEAM, mesh.name))
        values = np.zeros(len(mesh.polygons))
    vertices = np.zeros(len(mesh.vertices), dtype=bool)
    if group is not None:
        vertices[:] = [group.index in groups_of(vertex) for vertex in mesh.vertices]
    return NoSeam(values > 0, vertices)


Place = Literal["FLATTEN", "PIECES"]  # panel with the button that was pressed, where the list appears


@dataclass(frozen=True)
class Suggestions:
    kind: str  # DARTS, SEAMS or FEWER
    cuts: list[Cut]  # with a target, each cut includes all earlier cuts
    target: Target | None
    names: list[str]  # name of the piece that contains each cut
    choices: FlattenChoices  # settings of the search
    grain_wire: int  # id of the grain wire on the mesh; 0 for none
    wire_ids: set[int]  # ids of the wires during the search
    state: dict  # state of the model during the search, see model_state
    no_seam: NoSeam  # painted faces and vertices of the model's own mesh
    chosen: int
    with_modifiers: bool = False  # whether the cuts are on the mesh with modifiers, which marking a cut applies
    place: Place = "FLATTEN"
    other_pieces: int = 0  # number of pieces, without the piece that a cut set divides

    def pieces_after(self, cut: Cut) -> int:
        return cut.num_pieces + (0 if cut.cleared else self.other_pieces)


def keep(source: bpy.types.Object, suggestions: Suggestions) -> None:
    note(source)
    state_of(source).suggestions = suggestions


def choose(source: bpy.types.Object, index: int) -> None:
    """Choose which cut is drawn and can be marked. If there is no suggestion with this index, do nothing."""
    found = suggestions_of(source)
    if found and index < len(found.cuts):
        keep(source, replace(found, chosen=index))


def drop(source: bpy.types.Object) -> None:
    state_of(source).suggestions = None


def suggestions_of(source: bpy.types.Object) -> Suggestions | None:
    """Return the last suggestions, even if the model has changed."""
    return state_of(source).suggestions


def current_suggestions(source: bpy.types.Object, take: Take = kept) -> Suggestions | None:
    """Return the last suggestions if the model is unchanged, otherwise None. take: kept or read_anew."""
    found = suggestions_of(source)
    return found if found and are_current(source, found, take) else None


def are_current(source: bpy.types.Object, found: Suggestions, take: Take = kept) -> bool:
    """Return whether the model and its painted areas are unchanged. In Edit Mode, painted areas are not checked."""
    if has_changed(source, found.state, take):
        return False
    if source.data.is_editmode:
        return True
    try:
        return found.no_seam.is_same(take(source, "no seam", read_no_seam))
    except ObjectError:  # the attribute has changed since the search, which could read it
        return False
