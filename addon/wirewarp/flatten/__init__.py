# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of Flatten, which read the models, solve them step by step and write the pieces, and automatic updates.

May import: export, ui, state, solve, blender, properties, core, issues, names.
"""

from . import auto_update, operators

MODULES = (operators, auto_update)
