# SPDX-License-Identifier: GPL-3.0-or-later
"""The overlay computes nothing while nothing changes, and is removed with the add-on."""

from types import SimpleNamespace

import bpy
import pytest
from flattening import flatten_fails
from surfaces import bump, flat_of, grid, mark, new_object, on_line, select_edges
from view_context import view_context

SEAM, RIGID, ELASTIC, FREE = on_line(0, 0.0), on_line(1, 0.0), on_line(1, 0.5), on_line(1, -0.5)


@pytest.fixture
def source():
    """Return a flattened model of two pieces with one wire of each kind."""
    target = grid("Bump", bump, seam=SEAM, wire=RIGID)
    mark(target, ELASTIC, kind="ELASTIC", tolerance=0.05)
    mark(target, FREE, kind="SUPER_ELASTIC")
    bpy.ops.object.wirewarp_flatten()
    return target


def drawn(addon):
    """Return the drawings, keyed by their objects."""
    bpy.context.view_layer.update()
    return {drawing.target: drawing for drawing in addon.overlay.shown.drawings(view_context())}


def rigid_edges(lines):
    return len(lines.places["rigid"]) // 2


def test_nothing_is_built_again_until_something_changes(addon, source, at_once):
    first, again = drawn(addon), drawn(addon)
    for target in (source, flat_of(source)):
        assert first[target].lines is again[target].lines
    source.location.x += 1
    assert drawn(addon)[source].lines is first[source].lines
    mark(source, on_line(1, 0.25))
    changed = drawn(addon)
    assert rigid_edges(changed[source].lines) == 2 * rigid_edges(first[source].lines)
    assert changed[flat_of(source)].lines is first[flat_of(source)].lines


def test_allowances_are_computed_again_only_if_they_change(addon, source, at_once, monkeypatch):
    shown, laid = addon.overlay.shown, []
    cut_lines = shown.cut_lines
    monkeypatch.setattr(shown, "cut_lines", lambda *given, **more: laid.append(given) or cut_lines(*given, **more))

    def times_laid():
        drawn(addon)
        return len(laid)

    assert times_laid() == 1
    mark(source, on_line(1, 0.25))
    assert times_laid() == 1
    select_edges(source, SEAM)
    assert times_laid() == 1
    bpy.ops.mesh.wirewarp_allowance(kind="HEM")
    assert times_laid() == 2


def test_in_edit_mode_marks_are_seen_at_once_and_a_selection_builds_nothing_new(addon, source, at_once):
    select_edges(source, on_line(1, 0.25))
    seen = drawn(addon)[source].lines
    bpy.ops.mesh.wirewarp_mark()
    first = drawn(addon)[source].lines
    assert rigid_edges(first) == 8 + rigid_edges(seen) == 16
    select_edges(source, on_line(1, 0.25), on_line(1, -0.25))
    assert drawn(addon)[source].lines is first
    bpy.ops.mesh.select_all(action="SELECT")
    marked = drawn(addon)[source].lines
    assert all(marked.places[kind] is first.places[kind] for kind in set(first.places) - {"selected"})
    assert len(marked.places["selected"]) > len(first.places["selected"])
    bpy.ops.transform.translate(value=(0, 0, 0.1))
    assert drawn(addon)[source].lines is not first


class Gpu:
    """Replaces the module gpu, which cannot draw without a window. Counts the batches that are sent and drawn."""

    def __init__(self):
        self.sent, self.drawn = [], 0
        self.shader = SimpleNamespace(from_builtin=lambda _: SimpleNamespace(uniform_float=lambda *_: None))
        self.state = SimpleNamespace(viewport_get=lambda: (0, 0, 800, 600))

    def batch_for_shader(self, _shader, primitive, content):
        self.sent.append((primitive, len(content["pos"])))
        return SimpleNamespace(draw=self.draw)

    def draw(self, _shader):
        self.drawn += 1


def test_batches_are_sent_once_until_marks_change(addon, source, at_once, monkeypatch):
    gpu, batches = Gpu(), addon.overlay.batches
    monkeypatch.setattr(batches, "gpu", gpu)
    monkeypatch.setattr(batches, "batch_for_shader", gpu.batch_for_shader)

    def redraw():
        gpu.sent.clear()
        for drawing in drawn(addon).values():
            batches.draw_lines(drawing.target, "", drawing.lines, drawing.failures, 1.0, batches.Layer.LINES)
        return len(gpu.sent)

    # The model and the pieces have five kinds of lines each. Two of these kinds are dashed, and dashes need a second
    # batch. The pieces also have arrows and cutting lines.
    sent = 2 * (5 + 2) + 2
    assert redraw() == sent
    before = gpu.drawn
    assert redraw() == 0
    assert gpu.drawn == 2 * before == 2 * sent
    mark(source, on_line(1, 0.25))
    assert redraw() == 1


class Timers:
    """Replaces bpy.app.timers, because a real timer would keep the module bpy from closing."""

    def __init__(self):
        self.running = {}

    def register(self, function, first_interval):
        self.running[function] = first_interval

    def unregister(self, function):
        del self.running[function]

    def is_registered(self, function):
        return function in self.running


@pytest.fixture
def timers(addon, monkeypatch):
    fake = Timers()
    app = SimpleNamespace(timers=fake, handlers=bpy.app.handlers)
    monkeypatch.setattr(addon.state.drawings, "bpy", SimpleNamespace(app=app))
    return fake


@pytest.fixture
def clock(addon, monkeypatch):
    now = SimpleNamespace(now=100.0)
    monkeypatch.setattr(addon.state.drawings, "time", SimpleNamespace(monotonic=lambda: now.now))
    return now


def slowly(addon, clock, owner, seconds, source=None):
    """Return a function that draws a version, and a list of the versions that were built.

    Building a version takes `seconds`. If a version is not built, the function returns an earlier version.
    """
    built = []

    def build(version):
        clock.now += seconds
        built.append(version)
        return version

    kept = addon.state.drawings.kept_drawing
    return lambda version: kept(owner, "test", (version,), lambda: build(version), source), built


def test_a_build_is_not_repeated_at_once(addon, source, timers, clock):
    drawing, _ = slowly(addon, clock, source, 0.05)
    assert drawing(1) == 1
    clock.now += 0.4
    assert drawing(2) == 1
    assert timers.running == {addon.blender.views.redraw_views: pytest.approx(0.05)}
    clock.now += 0.06
    assert drawing(2) == 2
    clock.now += 10
    timers.running.clear()
    assert drawing(3) == 2  # Building was slow, so the screen is first redrawn with version 2.
    assert timers.running == {addon.blender.views.redraw_views: pytest.approx(0.01)}
    clock.now += 0.01
    assert drawing(4) == 4  # Even if each redraw has a new version, some versions are built.


@pytest.mark.parametrize("of_pieces", [False, True])
def test_slow_drawings_wait_in_edit_mode_until_the_user_pauses(addon, source, timers, clock, of_pieces):
    drawing, built = slowly(addon, clock, flat_of(source) if of_pieces else source, 0.25, source)
    assert drawing(0) == 0
    clock.now += 10
    select_edges(source, RIGID)
    for version in range(1, 100):  # as if vertices were dragged
        assert drawing(version) == 0
        clock.now += 0.05
    clock.now += 0.16
    assert drawing(99) == 99
    assert built == [0, 99]


class Space:
    """Stores the functions that draw in it, like Blender's types of spaces."""

    def __init__(self):
        self.drawn = []

    def draw_handler_add(self, draw, _arguments, _region, _stage):
        self.drawn.append(draw)
        return draw

    def draw_handler_remove(self, draw, _region):
        self.drawn.remove(draw)


@pytest.mark.api
def test_drawing_functions_and_timers_are_removed_with_the_add_on(addon, timers, monkeypatch):
    """tests/addon/test_registration.py tests the other handlers."""
    space = Space()
    spaces, draws, stages = zip(*addon.overlay._HANDLERS, strict=True)
    assert list(spaces) == 2 * [bpy.types.SpaceView3D] + 2 * [bpy.types.SpaceImageEditor]
    addon.unregister()
    try:
        with monkeypatch.context() as patch:
            handlers = [(space, draw, stage) for draw, stage in zip(draws, stages, strict=True)]
            patch.setattr(addon.overlay, "_HANDLERS", handlers)
            addon.register()
            assert len(space.drawn) == len(spaces)
            addon.state.drawings._redraw_in(60.0)
            addon.unregister()
        assert space.drawn == [] and timers.running == {}
    finally:
        addon.register()


def test_data_of_removed_objects_is_freed(addon, source):
    drawn(addon)
    flat = flat_of(source)
    states = [addon.state.memory.state_of(each) for each in (source, source.data, flat, flat.data)]
    assert states[0].drawings and states[2].drawings
    source.name = "Sleeve"
    assert addon.state.memory.state_of(source) is states[0]
    mesh, flat_mesh = source.data, flat.data
    for each in (flat, source):
        bpy.data.objects.remove(each)
    for each in (mesh, flat_mesh):
        bpy.data.meshes.remove(each)
    bpy.context.view_layer.update()
    present = list(addon.state.memory.all_states())
    assert not any(state is each for state in states for each in present)


OTHERS = 300


@pytest.fixture
def among_others():
    """Return a model in a scene with many objects that WireWarp does not use."""
    target, mesh = grid("Bump", bump), bpy.data.meshes.new("Other")
    for number in range(OTHERS):
        new_object(f"Other {number}", mesh)
    bpy.context.view_layer.update()
    return target


@pytest.fixture
def asked(addon, monkeypatch):
    """Return a list that gets the name of each object that is checked for data of WireWarp."""
    names = []
    ask = addon.overlay.shown.concerns_us
    monkeypatch.setattr(addon.overlay.shown, "concerns_us", lambda each: names.append(each.name) or ask(each))
    addon.state.memory.forget()
    return names


def names_drawn(addon):
    return {target.name for target in drawn(addon)}


def test_objects_are_checked_again_only_when_they_change(addon, among_others, asked):
    assert names_drawn(addon) == set()
    assert len(asked) == OTHERS + 1
    asked.clear()
    assert names_drawn(addon) == set()
    assert asked == []
    bpy.data.objects["Other 7"].location.x = 1
    drawn(addon)
    assert asked == ["Other 7"]


def test_marking_flattening_renaming_and_removing_are_noticed(addon, among_others, asked):
    assert names_drawn(addon) == set()
    mark(among_others, on_line(1, 0.0))
    assert names_drawn(addon) == {"Bump"}
    bpy.ops.object.wirewarp_flatten()
    assert names_drawn(addon) == {"Bump", "Bump Flat"}
    among_others.name = "Sleeve"
    assert names_drawn(addon) == {"Sleeve", "Bump Flat"}
    bpy.data.objects.remove(bpy.data.objects["Bump Flat"])
    assert names_drawn(addon) == {"Sleeve"}
    source = grid("Bump", bump)
    assert names_drawn(addon) == {"Sleeve"}
    source.data.vertices[0].co.x = float("nan")
    flatten_fails("not numbers, or far")
    assert names_drawn(addon) == {"Sleeve", "Bump"}  # because the model now has a report
    bpy.data.objects.remove(among_others)
    source.hide_set(True)
    assert names_drawn(addon) == set()
    source.hide_set(False)
    bpy.context.scene.collection.objects.unlink(source)
    assert names_drawn(addon) == set()
