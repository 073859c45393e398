# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared parts of the rooms' panels and operators: layout, settings, progress and runs in the window; and the menus.

May import: state, solve, blender, properties, core, issues.
"""

from . import layout, menus

MODULES = (menus,)
__all__ = ["MODULES", "layout", "menus"]
