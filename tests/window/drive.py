# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives Blender's window through tours, which are generator functions.

Usage: blender --enable-event-simulate --python-expr "import drive; drive.main()" -- SCRIPT FUNCTION...

Each tour starts in Blender's startup file, and Blender exits with 1 if a tour fails.
"""

import importlib
import os
import sys
import time
import traceback
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from types import ModuleType

import bpy

if "COVERAGE_PROCESS_START" in os.environ:  # set by tools/addon_coverage.py
    import coverage

TICK = 0.02  # seconds
PATIENCE = 120.0  # seconds to wait for a condition; machines without a graphics card are slow
Tour = Iterator[Callable[[], bool]]  # yields conditions; the tour continues when its last condition is true
_replaced: list[tuple[object, str, object]] = []


def install(path: str) -> None:
    """Install the zip as an add-on or as an extension. Scripts import both as wirewarp_addon."""
    if "legacy" in Path(path).name:
        bpy.ops.preferences.addon_install(filepath=path, overwrite=True)
        bpy.ops.preferences.addon_enable(module="wirewarp_addon")
    else:
        bpy.ops.extensions.package_install_files(repo="user_default", filepath=path, enable_on_install=True)
        sys.modules["wirewarp_addon"] = sys.modules["bl_ext.user_default.wirewarp"]


def view_area() -> bpy.types.Area:
    return next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == "VIEW_3D")


def region(kind: str) -> bpy.types.Region:
    """Return a region of the 3D view. kind: WINDOW, UI (the sidebar) or HEADER."""
    return next(each for each in view_area().regions if each.type == kind)


def in_view() -> object:
    """Return a context for `with`, in which operators run as if called in the 3D view."""
    window = bpy.context.window_manager.windows[0]
    return bpy.context.temp_override(window=window, area=view_area(), region=region("WINDOW"))


def middle(of: bpy.types.Region) -> tuple[int, int]:
    return of.x + of.width // 2, of.y + of.height // 2


def send(kind: str, value: str = "PRESS", at: tuple[int, int] | None = None, **modifiers: bool) -> None:
    """Send an event. at: place of the mouse, by default the middle of the 3D view."""
    x, y = at or middle(region("WINDOW"))
    bpy.context.window_manager.windows[0].event_simulate(type=kind, value=value, x=x, y=y, **modifiers)


def press(kind: str, at: tuple[int, int] | None = None, **modifiers: bool) -> Tour:
    """Move the mouse to this place, then press and release a key or mouse button."""
    for kind_now, value in (("MOUSEMOVE", "NOTHING"), (kind, "PRESS"), (kind, "RELEASE")):
        send(kind_now, value, at, **modifiers)
        yield from ticks(2)


def type_text(text: str) -> Tour:
    """Type lower-case letters and spaces into the field that has the cursor."""
    x, y = middle(region("WINDOW"))
    for letter in text:
        kind = "SPACE" if letter == " " else letter.upper()
        window = window_manager().windows[0]
        window.event_simulate(type=kind, value="PRESS", unicode=letter, x=x, y=y)
        window.event_simulate(type=kind, value="RELEASE", x=x, y=y)
        yield from ticks(1)


def move_mouse_until(condition: Callable[[], bool]) -> Tour:
    """Move the mouse right and left over the 3D view, at least once each, until the condition is true."""
    x, y = middle(region("WINDOW"))
    for step in range(60):
        if step > 1 and condition():
            return
        send("MOUSEMOVE", "NOTHING", (x + 10 * (step % 2), y))
        yield from ticks(2)
    raise AssertionError("the condition never became true while the mouse moved")


def ticks(count: int) -> Tour:
    """Let the window handle its events and redraw."""
    for _ in range(count):
        yield lambda: True


def open_tab(panel: type) -> Tour:
    """Show the sidebar with the tab of this panel: click the tabs from top to bottom until the panel is drawn."""
    drawn = []
    view_area().spaces.active.show_region_ui = True
    yield lambda: region("UI").width > 1
    panel.append(lambda _panel, _context: drawn.append(True))
    sidebar = region("UI")
    for y in range(sidebar.y + sidebar.height - 40, sidebar.y, -20):
        yield from press("LEFTMOUSE", (sidebar.x + sidebar.width - 12, y))
        if drawn:
            return
    raise AssertionError(f"no tab of the sidebar shows {panel.__name__}")


def command_at(place: tuple[int, int]) -> Generator[Callable[[], bool], None, str]:
    """Return the command of the sidebar's button at this place, or "" if there is no button."""
    window_manager().clipboard = ""  # otherwise, the command of another button could remain
    for at in ((place[0], place[1] + 1), place):
        send("MOUSEMOVE", "NOTHING", at)
    yield from ticks(2)
    with bpy.context.temp_override(window=window_manager().windows[0], area=view_area(), region=region("UI")):
        if bpy.ops.ui.copy_python_command_button.poll():
            bpy.ops.ui.copy_python_command_button()
    return window_manager().clipboard


def click_button(command: str, share: float = 0.4) -> Generator[Callable[[], bool], None, tuple[int, int]]:
    """Click the button of the sidebar whose command begins with this text, and return the button's place.

    share: horizontal place of the button, from 0 (left) to 1 (right).
    """
    sidebar = region("UI")
    for y in range(sidebar.y + sidebar.height - 20, sidebar.y, -12):
        place = (sidebar.x + int(share * sidebar.width), y)
        if (yield from command_at(place)).startswith(command):
            yield from press("LEFTMOUSE", place)
            return place
    raise AssertionError(f"no button of the sidebar runs {command}")


def operator_log() -> str:
    """Return the commands in the log of the Info editor."""
    window, area = window_manager().windows[0], window_manager().windows[0].screen.areas[-1]
    before, area.type = area.type, "INFO"
    with bpy.context.temp_override(window=window, area=area, region=area.regions[-1]):
        bpy.ops.info.select_all(action="SELECT")
        bpy.ops.info.report_copy()
    area.type = before
    return window_manager().clipboard


def window_manager() -> bpy.types.WindowManager:
    return bpy.context.window_manager


def screenshot(name: str) -> None:
    """Save a picture of the whole window as NAME.png in the folder WIREWARP_PICTURES."""
    window = window_manager().windows[0]
    with bpy.context.temp_override(window=window, area=window.screen.areas[0]):
        bpy.ops.screen.screenshot(filepath=str(Path(os.environ["WIREWARP_PICTURES"]) / f"{name}.png"))


def replace(owner: object, name: str, value: object) -> None:
    """Set an attribute until the end of the tour."""
    _replaced.append((owner, name, getattr(owner, name)))
    setattr(owner, name, value)


def start_anew() -> Tour:
    """Undo replacements and load Blender's startup file."""
    while _replaced:
        setattr(*_replaced.pop())
    send("MOUSEMOVE", "NOTHING")  # away from buttons, before the window closes
    yield from ticks(5)
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    yield from ticks(25)  # until the new window is drawn


def one_after_another(script: ModuleType, names: list[str]) -> Generator[Callable[[], bool], None, list[str]]:
    """Run the tours, and return the names of the tours that failed. Save a picture of the window at each failure."""
    failed = []
    for name in names:
        if name != names[0]:
            yield from start_anew()
        try:
            yield from getattr(script, name)()
        except Exception:
            print(f"the tour {name} failed", flush=True)
            traceback.print_exc()
            screenshot(f"{name} failed")
            failed.append(name)
    return failed


class Driver:
    """Steps through the tours, one step per tick of a timer."""

    def __init__(self, tours: Generator[Callable[[], bool], None, list[str]]) -> None:
        self._tours = tours
        self._condition: Callable[[], bool] = lambda: True
        self._deadline = 0.0

    def __call__(self) -> float:
        try:
            if self._condition():
                self._condition = next(self._tours)
                self._deadline = time.monotonic() + PATIENCE
            elif time.monotonic() > self._deadline:
                self._condition = self._tours.throw(TimeoutError(f"waited {PATIENCE:.0f} s"))
                self._deadline = time.monotonic() + PATIENCE
        except StopIteration as end:
            leave(1 if end.value else 0)
        except BaseException:
            traceback.print_exc()
            leave(1)
        return TICK


def leave(code: int) -> None:
    """Exit immediately, because Blender would ignore an exception in a timer, and would ask whether to save."""
    if "COVERAGE_PROCESS_START" in os.environ:
        measured = coverage.Coverage.current()
        measured.stop()
        measured.save()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def main() -> None:
    """Run the tours. This module must be imported, because Blender clears the names of scripts that it runs."""
    script, *names = sys.argv[sys.argv.index("--") + 1 :]
    sys.path.insert(0, str(Path(script).parent))
    if "COVERAGE_PROCESS_START" in os.environ:
        coverage.process_startup()
    install(os.environ["WIREWARP_ZIP"])
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.system.viewport_aa = os.environ.get("WIREWARP_VIEWPORT_AA", "8")
    tours = one_after_another(importlib.import_module(Path(script).stem), names)
    bpy.app.timers.register(Driver(tours), first_interval=0.5, persistent=True)
