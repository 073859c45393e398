# SPDX-License-Identifier: GPL-3.0-or-later
"""Kind and tolerance of a wire, as operators ask for them."""

import math

import bpy
from bpy.props import EnumProperty, FloatProperty

KINDS = [
    ("RIGID", "Rigid", "A rigid wire keeps exactly its length on the model"),
    ("ELASTIC", "Elastic", "An elastic wire may become longer or shorter, up to the tolerance"),
    ("SUPER_ELASTIC", "Free", "A free wire gets whatever length distorts the pieces least"),
]
DESCRIPTIONS = {identifier: description for identifier, _, description in KINDS}
NEEDS_TOLERANCE = "An elastic wire needs a tolerance above 0: set one, or make the wire rigid."


class WireKind:
    """Mixed into operators."""

    kind: EnumProperty(name="Kind", description="How strictly the wire keeps its length", items=KINDS, default="RIGID")
    tolerance: FloatProperty(
        name="Tolerance",
        description="Elastic wires: how much the total length may change, as a fraction (0.03 is 3 %)",
        min=0.0,
        soft_max=0.2,
        max=0.99,
        default=0.03,
        precision=4,
        step=1,
    )
    tolerance_percent: FloatProperty(
        name="Tolerance ±",
        description="Elastic wires: how much the total length may become longer or shorter, in percent",
        subtype="PERCENTAGE",
        min=0.0,
        soft_max=20.0,
        max=99.0,
        precision=2,
        get=lambda operator: 100 * operator.tolerance,
        set=lambda operator, percent: setattr(operator, "tolerance", percent / 100),
        options={"SKIP_SAVE"},
    )

    def is_tolerance_missing(self) -> bool:
        return self.kind == "ELASTIC" and not self.tolerance > 0  # nor is it a number in every script

    def chosen_tolerance(self) -> float:
        """As the edges carry it."""
        return {"RIGID": 0.0, "ELASTIC": self.tolerance, "SUPER_ELASTIC": math.inf}[self.kind]

    def draw_kind(self, layout: bpy.types.UILayout) -> None:
        layout.prop(self, "kind")
        if self.kind == "ELASTIC":
            layout.prop(self, "tolerance_percent")
