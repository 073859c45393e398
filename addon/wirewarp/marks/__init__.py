# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking seams, wires, eases and allowances: panel, operators and what they do.

May import: ui, state, solve, blender, properties, issues, names, words.
"""

from . import ease_operator, mark_operators, panel, wire_list

MODULES = (
    mark_operators,
    ease_operator,
    wire_list,
    panel,
)
