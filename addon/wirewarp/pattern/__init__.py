# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane geometry: chains of edges, outlines of flat pieces, and which of these overlap.

No Blender in here, no files. May import: nothing.
"""
