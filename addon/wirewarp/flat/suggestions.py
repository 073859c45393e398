# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts that were suggested for each object, until it is other than it was then. They are in no file."""

from dataclasses import dataclass, replace

import bpy

from ..blender.memory import Take, kept, note, state_of
from ..issues import ObjectError
from ..model.no_seam import read_no_seam
from ..model.state import has_changed
from ..solve.flatten import FlattenChoices
from ..solve.suggest import Aim, Cut, NoSeam


@dataclass(frozen=True)
class Suggestions:
    kind: str  # DARTS or SEAMS
    cuts: list[Cut]  # to choose one from; towards an aim each with all before it
    aim: Aim | None
    names: list[str]  # of the piece that each of them cuts
    choices: FlattenChoices  # with which they were measured
    grain_wire: int  # the id that the mesh had for it; 0: none
    wire_ids: set[int]  # of the wires that there were
    state: dict  # of the model, see model_state
    no_seam: NoSeam  # along which none runs
    chosen: int  # of the cuts


def keep(source: bpy.types.Object, suggestions: Suggestions) -> None:
    note(source)
    state_of(source).suggestions = suggestions


def choose(source: bpy.types.Object, index: int) -> None:
    """Which cut is drawn and may be taken. Without suggestions, or with fewer, nothing happens."""
    found = suggestions_of(source)
    if found and index < len(found.cuts):
        keep(source, replace(found, chosen=index))


def drop(source: bpy.types.Object) -> None:
    state_of(source).suggestions = None


def chosen_cut(source: bpy.types.Object, take: Take = kept) -> Cut | None:
    """None where there are no current suggestions."""
    found = current_suggestions(source, take)
    return found.cuts[found.chosen] if found else None


def suggestions_of(source: bpy.types.Object) -> Suggestions | None:
    """The last ones, whatever has changed since."""
    return state_of(source).suggestions


def current_suggestions(source: bpy.types.Object, take: Take = kept) -> Suggestions | None:
    """The last ones, if the model is as it was; take: kept, or read_anew."""
    found = suggestions_of(source)
    return found if found and are_current(source, found, take) else None


def are_current(source: bpy.types.Object, found: Suggestions, take: Take = kept) -> bool:
    """Whether the model is as it was, and so is where no seam is wanted: in Edit Mode that is not seen."""
    if has_changed(source, found.state, take):
        return False
    if source.data.is_editmode:
        return True
    try:
        return found.no_seam.is_same(take(source, "no seam", read_no_seam))
    except ObjectError:  # it was readable then
        return False
