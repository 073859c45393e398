# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern on paper, and the plane geometry it is made with: chains of edges, outlines, notches, texts, SVG.

No Blender in here, no files. May import: issues.
"""
