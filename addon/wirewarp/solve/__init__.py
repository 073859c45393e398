# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes arrays of a mesh to the core library, and makes named pieces, a flat mesh and colors from the result.

Does not use Blender. May import: core, issues, names.
"""
