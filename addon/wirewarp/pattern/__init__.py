# SPDX-License-Identifier: GPL-3.0-or-later
"""Chains of edges of a mesh, and outlines of flat pieces.

No Blender in here, no files. May import: nothing.
"""
