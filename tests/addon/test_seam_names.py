# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams keep their numbers even if other edges are marked, because people write these numbers on fabric."""

from copy import copy
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from everything import draw_panels
from flattening import flatten, flatten_fails, flattened
from surfaces import bump, everywhere, flat_of, mark_seam, on_edges, on_line, read, select_only, tube
from view_context import marked_lines

DOWN = on_line(0, 0.0)


def at(x):
    return on_line(0, x)


@pytest.fixture
def source():
    return flattened("Bump", bump, seam=at(0.5))


def seams(addon, target):
    """Return the mean position (x, y) of each seam of the last report, keyed by name."""
    report = addon.state.reports.last_report(target)
    places = read(target.data.vertices, "co", np.float32, 3)
    return {seam.name: places[seam.edges].mean(axis=(0, 1))[:2].round(2).tolist() for seam in report.seams}


def test_a_new_seam_changes_no_other_number_and_numbers_are_not_reused(addon, source):
    assert seams(addon, source) == {"Seam 1": [0.5, 0.0]}
    mark_seam(source, at(-0.5))
    flatten(source)
    assert seams(addon, source) == {"Seam 1": [0.5, 0.0], "Seam 2": [-0.5, 0.0]}
    for edge in source.data.edges:
        edge.use_seam = False
    mark_seam(source, at(0.5))
    flatten(source)
    mark_seam(source, DOWN)
    flatten(source)
    assert seams(addon, source) == {"Seam 1": [0.5, 0.0], "Seam 3": [0.0, 0.0]}
    mark_seam(source, at(-0.5))
    flatten(source)
    assert seams(addon, source)["Seam 2"] == [-0.5, 0.0]


def test_a_seam_keeps_its_name_through_edits(addon, source, tmp_path):
    source.wirewarp_seams[0].name = "Side"
    mark_seam(source, DOWN)
    on_edges(source, bpy.ops.mesh.subdivide, everywhere)
    flatten(source)
    assert seams(addon, source) == {"Side": [0.5, 0.0], "Seam 2": [0.0, 0.0]}
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    assert set(seams(addon, bpy.data.objects["Bump"])) == {"Side", "Seam 2"}


def test_the_longer_part_of_a_divided_seam_keeps_the_name(addon, source):
    mark_seam(source, lambda a, b: on_line(1, 0.5)(a, b) and min(a[0], b[0]) > 0.4)
    flatten(source)
    found = seams(addon, source)
    assert found["Seam 1"] == [0.5, -0.25] and sorted(found) == ["Seam 1", "Seam 2", "Seam 3"]


def test_a_seam_that_ends_inside_is_a_dart_and_one_that_opens_a_tube_is_not(addon):
    target = flattened("Bump", bump, seam=lambda a, b: DOWN(a, b) and max(a[1], b[1]) < 0.1)
    assert list(seams(addon, target)) == ["Dart 1"]
    assert addon.state.reports.last_report(target).tables.seams[0].note == "Bump"
    mark_seam(target, DOWN)  # The seam now divides the piece.
    flatten(target)
    assert list(seams(addon, target)) == ["Seam 1"]
    opened = tube()
    mark_seam(opened, on_line(0, 0.5))
    flatten(opened)
    assert list(seams(addon, opened)) == ["Seam 1"]


def test_darts_are_numbered_on_their_own(addon, source):
    mark_seam(source, lambda a, b: DOWN(a, b) and max(a[1], b[1]) < 0.1)
    mark_seam(source, at(-0.5))
    flatten(source)
    assert sorted(seams(addon, source)) == ["Dart 1", "Seam 1", "Seam 2"]


def test_seams_keep_their_numbers_with_modifiers(addon, source):
    source.modifiers.new("Twice", "SUBSURF")
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    mark_seam(source, DOWN)
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    before = {entry.seam_id: entry.name for entry in source.wirewarp_seams}
    assert list(before.values()) == ["Seam 1", "Seam 2"]
    bpy.ops.object.wirewarp_flatten(use_modifiers=True)
    assert {entry.seam_id: entry.name for entry in source.wirewarp_seams} == before
    flat = flat_of(source).data
    assert set(read(flat.attributes["wirewarp_seam"].data, "value", np.int32)) == {0, *before}


def test_a_seam_without_a_name_gets_a_new_name_that_stays_when_a_run_is_refused(addon, source):
    source.wirewarp_seams[0].name = ""
    flatten(source)
    assert list(seams(addon, source)) == ["Seam 2"]  # The number 1 is not used again.
    names = [piece.name for piece in addon.state.reports.last_report(source).pieces]
    assert " – ".join(names) in draw_panels(addon)
    source.scale.x = 0.0
    select_only(source)
    flatten_fails("scaled to zero")
    assert [name.texts for name in marked_lines(addon, source).names] == [("Seam 2",)]


class MovingEntries(list):
    """Behaves like Blender's collections: add() may move all entries, which makes earlier references invalid."""

    def add(self):
        self[:] = [*map(copy, self), SimpleNamespace(seam_id=0, name="")]
        return self[-1]


def test_names_are_written_to_the_right_entries_after_new_entries_moved_them(addon):
    source = SimpleNamespace(wirewarp_seams=MovingEntries([SimpleNamespace(seam_id=1, name="Seam 1")]))
    names = {2: "Seam 2", 1: "Seam 3"}
    identities = [addon.solve.identity.SeamIdentity(seam_id, name, is_dart=False) for seam_id, name in names.items()]
    addon.state.identities.write_seams(source, None, identities, on_model=False)
    assert addon.state.identities.seam_names(source) == names
