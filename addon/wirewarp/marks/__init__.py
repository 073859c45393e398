# SPDX-License-Identifier: GPL-3.0-or-later
"""Marking seams, wires, eases and allowances: panel, operators and what they do.

May import: ui, state, solve, blender, properties, issues, names, words.
"""

from . import ease_operator, mark_operators, panel, seam_operators, unit_operator, wire_list, wire_operators

MODULES = (
    mark_operators,
    seam_operators,
    ease_operator,
    wire_operators,
    unit_operator,
    panel,
    wire_list,
)
