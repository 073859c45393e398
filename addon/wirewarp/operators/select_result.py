# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
from bpy.props import EnumProperty, IntProperty

from ..flat_sources import flat_sources
from ..issues import object_error
from ..report_elements import Elements, elements_of, faces_of_piece, on_flat
from ..report_store import last_report, pieces_report
from ..selection import check_indices, select_elements
from ..targets import in_object_mode
from .report_operator import ReportOperator


class MESH_OT_wirewarp_select_result(ReportOperator, bpy.types.Operator):
    """Select this part of the report in Edit Mode and show it"""

    bl_idname = "mesh.wirewarp_select_result"
    bl_label = "Select in Report"

    what: EnumProperty(
        name="What",
        description="What to select",
        items=[
            ("SEAM", "Seam", "Select and show the seam: on the model, or all its sides if flat pieces are active"),
            ("WIRE", "Wire", "Select and show the wire: on the model, or on the flat pieces if these are active"),
            ("OUTLINE", "Open Edge", "Select and show this stretch of outline: on the model, or on active flat pieces"),
            ("PIECE", "Piece", "Select and show the piece: on the model, or on the flat pieces if these are active"),
            ("STRETCH", "Largest Stretch", "Select and show where the cloth of this piece must stretch most"),
            ("EASE", "Largest Ease", "Select and show where the cloth of this piece must be eased in most"),
            ("ISSUE", "Issue", "Select and show what the sentence is about"),
            ("HINT", "Hint", "Select and show the place: on the model, or on the flat pieces if these are active"),
        ],
        options={"HIDDEN"},
    )
    index: IntProperty(name="Index", description="Its place in the report, from 0", min=0, options={"HIDDEN"})

    def report_of(self, source: bpy.types.Object) -> dict | None:
        """Of the list of pieces, or of all else in the panel."""
        return (pieces_report if self.what in {"PIECE", "STRETCH", "EASE"} else last_report)(source)

    def act(self, context: bpy.types.Context, source: bpy.types.Object, report: dict) -> set[str]:
        elements = elements_of(report, self.what, self.index)
        if elements is None:
            sentence = f'The report of "{source.name}" has no line {self.index + 1} of this kind: choose another.'
            raise object_error("not_in_report", sentence)
        # The elements of a mesh with modifiers are to be had on the flat pieces only.
        wants_flat = context.active_object != source or report.get("with_modifiers")
        if wants_flat and self._lies_flat(report, elements):
            with in_object_mode(context):
                flat, sources = flat_sources(source, report)
            _select(context, flat, on_flat(elements, sources))
            return {"FINISHED"}
        check_indices(source, report)
        if elements.whole_piece:
            with in_object_mode(context):
                _, sources = flat_sources(source, report)
            elements = Elements(faces=faces_of_piece(elements.piece, sources))
        _select(context, source, elements)
        return {"FINISHED"}

    def _lies_flat(self, report: dict, elements: Elements) -> bool:
        """What failed may be about a piece, or a whole model, that has no flat shape."""
        if self.what != "ISSUE":
            return True
        return elements.piece is not None and report["pieces"][elements.piece]["has_layout"]


def _select(context: bpy.types.Context, target: bpy.types.Object, elements: Elements) -> None:
    select_elements(context, target, elements.vertices, elements.edges, elements.faces)
