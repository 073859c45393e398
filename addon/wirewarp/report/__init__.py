# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a result: every length, the verdict, hints, and the rows and tables that show it.

No Blender in here. May import: solve, pattern, core, issues, words.
"""
