# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender without its stumbling blocks: meshes as arrays, modes, selection, units, files, views.

Knows nothing of wires and pieces. May import: solve, issues, names, words.
"""
