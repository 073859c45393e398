# SPDX-License-Identifier: GPL-3.0-or-later
"""All that the add-on hooks into Blender, in one place: classes, properties, menus, drawing, handlers."""

from collections.abc import Callable
from contextlib import ExitStack

import bpy

from . import operators, overlay, properties, ui
from .blender import memory
from .flat import reports
from .model import wire_names
from .operators import update
from .overlay import cache as drawings
from .run import auto_update, window_run
from .solve import flatten

CLASSES = (*properties.CLASSES, *operators.CLASSES, *ui.CLASSES)
PARTS = (properties, overlay, ui.layout, ui.menus, auto_update)  # attach() of each returns what takes it back
HANDLERS: dict[str, tuple[Callable, ...]] = {  # by Blender's list of them
    "depsgraph_update_post": (memory.note_updates, auto_update.note_update),
    "frame_change_post": (memory.drop_changed,),
    "undo_post": (memory.drop_gathered, reports.forget_incomparable, auto_update.note_undo),
    "redo_post": (memory.drop_gathered, reports.forget_incomparable, auto_update.note_undo),
    "save_pre": (wire_names.write_brought_names,),
    "load_pre": (window_run.stop, flatten.drop_jobs),
    "load_post": (drawings.forget, memory.forget),
}
FORGET = (*HANDLERS["load_pre"], *HANDLERS["load_post"])  # what is in memory goes with the add-on as with the file


def register() -> Callable[[], None]:
    """Returns what takes everything back, each thing even if another fails; as is done when registering fails."""
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
        undo.callback(update.forget_joining)
        for forget in reversed(FORGET):  # what is registered last goes first
            undo.callback(forget)
        return undo.pop_all().close


def _remove_handler(name: str, function: Callable) -> None:
    """Another add-on may have cleared the list."""
    if function in getattr(bpy.app.handlers, name):
        getattr(bpy.app.handlers, name).remove(function)
