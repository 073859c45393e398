# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels and operators of the rooms share: layout, settings, progress, runs in the window; and the menus.

May import: state, solve, blender, properties, core, issues.
"""

from . import layout, menus

MODULES = (menus,)
__all__ = ["MODULES", "layout", "menus"]
