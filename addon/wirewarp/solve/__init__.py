# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of a mesh to the core library and back: named pieces in their places, one flat mesh, colors of its measures.

No Blender in here. May import: core, issues, names, words.
"""
