# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators: thin, each over its work module.

May import: ui, run, flat, model, blender, solve, properties, core, issues, words.
"""

from . import ease, export, flatten, mark, mend, report, sewing, smooth, suggest, unit, update, view, wire

MODULES = (mark, ease, wire, smooth, report, flatten, mend, suggest, view, export, sewing, unit, update)
CLASSES = tuple(cls for module in MODULES for cls in module.CLASSES)
