# SPDX-License-Identifier: GPL-3.0-or-later
"""Replaces the add-on if the core library does not work. The sidebar and the operator Flatten show the reason."""

import textwrap
from collections.abc import Callable

import bpy

# These are the width of a letter and the space beside the sentence, in approximate pixels at interface scale 1.
LETTER, MARGIN = 7, 60


def register(problem: str) -> Callable[[], None]:
    """Register the panel and the operator, and return the function that unregisters them. problem: sentence that says
    why the library does not work."""

    class OBJECT_OT_wirewarp_flatten(bpy.types.Operator):
        """Show why WireWarp cannot flatten"""

        bl_idname = "object.wirewarp_flatten"
        bl_label = "Flatten"

        def execute(self, _context: bpy.types.Context) -> set[str]:
            self.report({"ERROR"}, problem)
            return {"CANCELLED"}

    class VIEW3D_PT_wirewarp_problem(bpy.types.Panel):
        bl_label = "WireWarp"
        bl_space_type = "VIEW_3D"
        bl_region_type = "UI"
        bl_category = "WireWarp"

        def draw(self, context: bpy.types.Context) -> None:
            column = self.layout.column(align=True)
            letters = int((context.region.width / context.preferences.system.ui_scale - MARGIN) / LETTER)
            for number, line in enumerate(textwrap.wrap(problem, max(letters, 12))):
                column.label(text=line, icon="BLANK1" if number else "ERROR")

    classes = (OBJECT_OT_wirewarp_flatten, VIEW3D_PT_wirewarp_problem)
    for cls in classes:
        bpy.utils.register_class(cls)

    def unregister() -> None:
        for cls in classes:
            bpy.utils.unregister_class(cls)

    return unregister
