# SPDX-License-Identifier: GPL-3.0-or-later
"""What the buttons of the report have in common."""

import bpy

from ..issues import ObjectError, object_error
from ..owners import model_or_self
from ..report_store import last_report


class ReportOperator:
    """Acts on a report of the active model, or of the model of active flat pieces. Subclasses say how."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        """Of the chosen item; "" where there is no choice, for Blender to show the class's own sentence."""
        what = properties.rna_type.properties.get("what")
        return what.enum_items[properties.what].description if what else ""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def report_of(self, source: bpy.types.Object) -> dict | None:
        """The one that is shown."""
        return last_report(source)

    def execute(self, context: bpy.types.Context) -> set[str]:
        source = model_or_self(context.active_object)
        report = self.report_of(source)
        try:
            if report is None:
                raise object_error("not_flattened", f'"{source.name}" has not been flattened yet: press Flatten first.')
            return self.act(context, source, report)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
