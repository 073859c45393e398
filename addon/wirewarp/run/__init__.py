# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of Flatten: read the models, solve them step by step, write the results; when to do so by itself; exports.

May import: flat, model, blender, solve, pattern, core, names, issues, words.
"""
