# SPDX-License-Identifier: GPL-3.0-or-later
"""What is stored of models and flat pieces, and kept in memory: read, compared with what was, and named.

May import: solve, blender, core, issues, names, words.
"""
