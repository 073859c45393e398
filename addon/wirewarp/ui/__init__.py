# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared parts of panels and operators: layout, settings, progress, runs in the window, and menus.

May import: state, solve, blender, properties, core, issues.
"""

from . import layout, menus

MODULES = (menus,)
__all__ = ["MODULES", "layout", "menus"]
