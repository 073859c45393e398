# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks seams, wires, eases and allowances: panel, operators and functions.

May import: ui, state, solve, blender, properties, core, issues, names.
"""

from . import ease_operator, mark_operators, panel, side_panel, wire_list

MODULES = (mark_operators, ease_operator, wire_list, panel, side_panel)
