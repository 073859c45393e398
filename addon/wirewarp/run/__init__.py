# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of Flatten: read the models, solve them in a thread, write the results; and when to do so by itself.

May import: flat, model, blender, report, solve, core, names, issues, words.
"""
