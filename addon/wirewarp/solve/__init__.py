# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes arrays of a mesh to the core library, and makes named pieces, a flat mesh and colors of the result.

No Blender in here. May import: core, issues, names.
"""
