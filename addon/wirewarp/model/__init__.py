# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh that the user works on: its wires and seams, their names, its state, and which flat object is its own.

May import: blender, solve, pattern, core, names, issues, words.
"""
