# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of Flatten: read the models, solve them step by step, write the pieces; automatic updates.

May import: export, ui, state, solve, blender, properties, core, issues, names.
"""

from . import auto_update, operators

MODULES = (operators, auto_update)
