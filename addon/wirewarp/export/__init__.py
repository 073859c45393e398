# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pattern of flat pieces, and the object for sewing simulations.

May import: ui, state, solve, blender, properties, core, issues, names.
"""

from . import operators, sewing

MODULES = (operators, sewing)
