# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads, compares and names data that is stored on models, on flat pieces and in memory.

May import: solve, blender, core, issues, names.
"""
