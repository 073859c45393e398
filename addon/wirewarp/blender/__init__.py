# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrappers around awkward parts of the Blender API: meshes as arrays, modes, selection, units, files, views.

These modules do not depend on wires and pieces. May import: solve, core, issues, names.
"""
