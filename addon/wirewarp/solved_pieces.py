# SPDX-License-Identifier: GPL-3.0-or-later
"""For each object the pieces of its last run, in the core's memory: only those that changed are solved again."""

from typing import Any

import bpy
from bpy.app.handlers import persistent

from . import core

_caches: dict[str, Any] = {}  # wirewarp.Cache by the object's full name


def solved_pieces(source: bpy.types.Object) -> Any:  # noqa: ANN401
    """The object's wirewarp.Cache. It may be used in a thread; what does not fit is not taken from it."""
    gone = _caches.keys() - {each.name_full for each in bpy.data.objects}
    for name in gone:
        del _caches[name]
    return _caches.setdefault(source.name_full, core.library().Cache())


@persistent
def _forget(*_: object) -> None:
    _caches.clear()


def attach() -> None:
    bpy.app.handlers.load_post.append(_forget)


def detach() -> None:
    bpy.app.handlers.load_post.remove(_forget)
    _forget()
