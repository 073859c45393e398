# SPDX-License-Identifier: GPL-3.0-or-later
"""Choose Fabric: the fabrics that can do what the verdict says."""

import bpy

from ..core import Cloth
from ..solve.report import ObjectReport
from ..state.settings import fabric_label
from ..ui.shown import shown_report

OTHER_SHAPE = 1.5  # leather must stretch 11% in the fitted top, of which woven cotton must stretch 7.6%
ICON = "MATCLOTH"
NONE_CAN = "No fabric in the list surely stretches far enough"


def fabrics_that_can(report: ObjectReport) -> list[str]:
    """The presets that stretch far enough for all pieces, whatever their grain; the least stretching first.

    Each fabric makes other shapes: what is needed after a flatten for one is no more than a measure for others.
    """
    needed = max((piece.needed * (OTHER_SHAPE if piece.threads else 1) for piece in report.pieces), default=0.0)
    limits = {name: min(Cloth.preset(name).limits) for name in Cloth.presets()}
    return sorted((name for name, limit in limits.items() if limit >= needed), key=limits.__getitem__)


class VIEW3D_MT_wirewarp_fabrics(bpy.types.Menu):
    """Choose a fabric that stretches far enough, and flatten for it"""

    bl_label = "Choose Fabric"

    def draw(self, context: bpy.types.Context) -> None:
        report, layout = shown_report(context), self.layout
        layout.operator_context = "INVOKE_DEFAULT"
        names = fabrics_that_can(report) if report else []
        for name in names:
            button = layout.operator("object.wirewarp_mend", text=fabric_label(name))
            button.what, button.cloth = "FABRIC", name.upper()
        if not names:
            layout.label(text=NONE_CAN, icon="INFO")


CLASSES = (VIEW3D_MT_wirewarp_fabrics,)
