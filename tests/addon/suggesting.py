# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared parts of tests of suggested cuts."""

import bpy
import numpy as np

SUGGEST = {"DARTS": bpy.ops.object.wirewarp_suggest_darts, "SEAMS": bpy.ops.object.wirewarp_suggest_seams}


def found(addon, source):
    return addon.state.suggestions.current_suggestions(source)


def pairs(edges):
    return {(min(edge), max(edge)) for edge in np.asarray(edges).tolist()}
