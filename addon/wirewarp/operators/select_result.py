# SPDX-License-Identifier: GPL-3.0-or-later
import bpy
import numpy as np
from bpy.props import EnumProperty, IntProperty

from ..foreach import read
from ..issues import ObjectError, object_error
from ..report_store import last_report
from ..selection import check_indices, select_elements
from ..write_flat_object import find_flat_object


class MESH_OT_wirewarp_select_result(bpy.types.Operator):
    """Select this part of the report in Edit Mode"""

    bl_idname = "mesh.wirewarp_select_result"
    bl_label = "Select in Report"
    bl_options = {"REGISTER", "UNDO"}

    what: EnumProperty(
        name="What",
        description="What to select",
        items=[
            ("SEAM", "Seam", "The seam: on the model, or both its sides on the flat pieces if these are active"),
            ("PIECE", "Piece", "The piece, among the flat pieces"),
        ],
        options={"HIDDEN"},
    )
    index: IntProperty(name="Index", description="Its place in the report, from 0", min=0, options={"HIDDEN"})

    @classmethod
    def description(cls, _context: bpy.types.Context, properties: bpy.types.OperatorProperties) -> str:
        item = cls.bl_rna.properties["what"].enum_items[properties.what]
        return f"Select in Edit Mode. {item.description}"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        active = context.active_object
        return active is not None and active.type == "MESH" and context.mode in {"OBJECT", "EDIT_MESH"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        if context.mode == "EDIT_MESH":
            bpy.ops.object.mode_set(mode="OBJECT")
        active = context.active_object
        try:
            self._select(context, active.wirewarp_source or active, on_flat=active.wirewarp_source is not None)
        except ObjectError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _select(self, context: bpy.types.Context, source: bpy.types.Object, on_flat: bool) -> None:
        report = last_report(source)
        listed = report[f"{self.what.lower()}s"] if report else []
        if self.index >= len(listed):
            raise object_error("not_in_report", f'The report of "{source.name}" has no such {self.what.lower()}.')
        if self.what == "SEAM" and not on_flat:
            check_indices(source, report)
            select_elements(context, source, edges=listed[self.index]["edges"])
            return
        flat = find_flat_object(source)
        if (
            flat is None
            or "flat_object" not in report
            or not {"piece", "source_vertex"} <= set(flat.data.attributes.keys())
        ):
            raise object_error(
                "no_flat_pieces", f'There are no flat pieces to this report: flatten "{source.name}" again.'
            )
        if self.what == "PIECE":
            pieces = read(flat.data.attributes["piece"].data, "value", np.int32)
            select_elements(context, flat, faces=np.flatnonzero(pieces == self.index))
        else:
            select_elements(context, flat, edges=_flat_edges(flat.data, listed[self.index]["edges"]))


def _flat_edges(mesh: bpy.types.Mesh, source_edges: list) -> np.ndarray:
    """The edges (k,2) of flat pieces that come from these vertex pairs of the model."""
    edges = read(mesh.edges, "vertices", np.int32, 2)
    sources = np.sort(read(mesh.attributes["source_vertex"].data, "value", np.int32)[edges], axis=1)
    wanted = {tuple(sorted(pair)) for pair in source_edges}
    return edges[[tuple(pair) in wanted for pair in sources.tolist()]]
