# SPDX-License-Identifier: GPL-3.0-or-later
"""Data stored on models and flat pieces and in memory: read, compared with earlier data, and named.

May import: solve, blender, core, issues, names, words.
"""
