# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels, operators and functions that mark seams, wires, eases and allowances.

May import: ui, state, solve, blender, properties, core, issues, names.
"""

from . import ease_operator, mark_operators, panel, side_panel, wire_list

MODULES = (mark_operators, ease_operator, wire_list, panel, side_panel)
