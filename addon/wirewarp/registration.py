# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers the add-on's classes, properties, menus, drawing and handlers in Blender."""

from collections.abc import Callable
from contextlib import ExitStack
from types import ModuleType

import bpy

from . import export, flatten, marks, overlay, properties, report_panel, suggest, ui
from .flatten import auto_update
from .solve.flatten import drop_jobs
from .state import drawings, identities, memory, reports
from .ui import window_run

ROOMS = (ui, marks, flatten, suggest, export, report_panel, overlay)
SIDEBAR = (  # Blender shows panels in the order in which they are registered
    marks.panel,
    report_panel.flatten_panel,
    report_panel.export_panel,
    report_panel.piece_list,
    marks.wire_list,
    report_panel.panel,
    marks.side_panel,
    overlay.panel,
)
OTHERS = tuple(module for room in ROOMS for module in room.MODULES if module not in SIDEBAR)
REGISTERED = (
    bpy.types.AddonPreferences,
    bpy.types.PropertyGroup,
    bpy.types.Operator,
    bpy.types.Menu,
    bpy.types.UIList,
    bpy.types.Panel,
)


def classes_of(module: ModuleType) -> list[type]:
    """Return the module's classes for Blender, in their order in the file."""
    own = [each for each in vars(module).values() if isinstance(each, type) and each.__module__ == module.__name__]
    return [cls for cls in own if issubclass(cls, REGISTERED)]


CLASSES = [cls for module in (properties, *OTHERS, *SIDEBAR) for cls in classes_of(module)]
# Each part has attach(), which returns the function that detaches the part.
PARTS = (properties, overlay, ui.layout, ui.menus, auto_update)
HANDLERS: dict[str, tuple[Callable, ...]] = {  # keys: names of Blender's lists of handlers
    "depsgraph_update_post": (memory.note_updates, auto_update.note_update),
    "frame_change_post": (memory.drop_changed,),
    "undo_post": (memory.drop_gathered, reports.forget_incomparable, auto_update.note_undo),
    "redo_post": (memory.drop_gathered, reports.forget_incomparable, auto_update.note_undo),
    "save_pre": (identities.write_brought_names,),
    "load_pre": (window_run.stop, drop_jobs),
    "load_post": (drawings.forget, memory.forget),
}
# These functions clear the memory when the add-on is disabled or another file is opened.
FORGET = (*HANDLERS["load_pre"], *HANDLERS["load_post"])


def register() -> Callable[[], None]:
    """Register everything. Return a function that removes everything, even if removing some items fails. If the
    registration fails, items that were already registered are removed, too."""
    with ExitStack() as undo:
        for cls in CLASSES:
            bpy.utils.register_class(cls)
            undo.callback(bpy.utils.unregister_class, cls)
        for part in PARTS:
            undo.callback(part.attach())
        for name, functions in HANDLERS.items():
            for function in functions:
                getattr(bpy.app.handlers, name).append(bpy.app.handlers.persistent(function))
                undo.callback(_remove_handler, name, function)
        undo.callback(auto_update.forget_joining)
        for forget in reversed(FORGET):  # reversed, because `undo` calls the last function first
            undo.callback(forget)
        return undo.pop_all().close


def _remove_handler(name: str, function: Callable) -> None:
    """Remove a handler, unless another add-on has cleared the list."""
    if function in getattr(bpy.app.handlers, name):
        getattr(bpy.app.handlers, name).remove(function)
