# SPDX-License-Identifier: GPL-3.0-or-later
"""Helper wires of deleted models and pieces go when the file is saved: they point to these, which would stay in it."""

import bpy
from bpy.app.handlers import persistent

from .owners import is_helper
from .remove_object import remove_object


@persistent
def _drop(*_: object) -> None:
    for target in [each for each in bpy.data.objects if is_helper(each) and _is_gone(each.wirewarp_helpers_of)]:
        if target.library is None:
            remove_object(target)


def _is_gone(owner: bpy.types.Object) -> bool:
    return not (owner.users_collection or owner.use_fake_user)


def attach() -> None:
    bpy.app.handlers.save_pre.append(_drop)


def detach() -> None:
    bpy.app.handlers.save_pre.remove(_drop)
