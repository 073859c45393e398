# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat object and what else a run leaves in the file: written, and read back whatever users did to it.

May import: model, blender, solve, pattern, core, names, issues.
"""
