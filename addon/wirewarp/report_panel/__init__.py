# SPDX-License-Identifier: GPL-3.0-or-later
"""The result of a run and the next steps: the panels Flatten, Export, Pieces and Report, and their buttons.

May import: suggest, flatten, marks, overlay, ui, state, solve, blender, properties, core, issues.
"""

from . import export_panel, fix, flatten_panel, next_step, operators, panel, piece_list

MODULES = (operators, fix, next_step, flatten_panel, export_panel, piece_list, panel)
