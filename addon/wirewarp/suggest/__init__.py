# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators and panels that suggest cuts, and operators that cut lines into the mesh.

May import: flatten, marks, ui, state, solve, blender, properties, core, issues, names.
"""

from . import operators, smooth

MODULES = (operators, smooth)
