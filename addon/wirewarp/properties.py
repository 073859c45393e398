# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the add-on's preferences, settings of the scene, and stored data.

Names of wires are stored on the mesh; names of pieces and seams, and the model of flat pieces, on the object.
"""

from collections.abc import Callable

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from .blender.views import redraw_views
from .core import Cloth, pattern
from .state.memory import note_change
from .state.settings import FlattenSettings, TargetSettings, number


def _redraw(_settings: bpy.types.PropertyGroup, _context: bpy.types.Context) -> None:
    redraw_views()


LEAST_EASE = -0.99  # smallest ease, so that a line keeps some length


class EaseAmount:
    """Settings of an ease, which changes a line's length. The scene's settings and the operator share them."""

    ease_unit: EnumProperty(
        name="Unit",
        description="Unit in which an ease is entered",
        items=[
            ("PERCENT", "%", "Percent of the length of each line"),
            ("LENGTH", "mm", "Millimeters added to each line"),
        ],
    )
    ease_percent: number(
        "Ease (%)",
        "How much longer to cut the lines, in percent of their length. Below 0: shorter",
        (100 * LEAST_EASE, 5.0, 100.0, 1000.0),  # 5% is usual for a sleeve head
        soft_min=-50.0,
        precision=2,
        step=100,
    )
    ease_length: FloatProperty(
        name="Ease (mm)",
        description="How many millimeters longer to cut each line. Below 0: shorter",
        soft_min=-100.0,
        soft_max=500.0,
        default=10.0,
        precision=2,
        step=100,
    )


OTHER_ROLL = 8  # number stored in files for ROLL; the library's papers have the numbers before and after it


class PatternSettings:
    """Settings of Export and of the preview of pages. The scene's settings and the operator share them."""

    allowance: number(
        "Allowance",
        "Seam allowance in millimeters around every piece, except along edges marked with another allowance",
        (0.0, 10.0, 50.0, 1000.0),
        step=100,
        update=_redraw,
    )
    pairs: BoolProperty(
        name="Equal Pieces",
        description="Draw pieces of the same or mirrored shape only once, with the number of copies to cut",
        update=_redraw,
    )
    on_fold: BoolProperty(
        name="On the Fold",
        description="Draw half of each symmetric piece, to be cut on the fold of the fabric",
        update=_redraw,
    )
    darts: EnumProperty(
        name="Darts",
        description="How darts are cut",
        items=[
            (
                "CLOSE",
                "Closed",
                "Keep the fabric of the dart, and shape its open end so that the folded dart continues the outline. "
                "Notches mark its legs, and a drill hole is before its tip. Darts wider than 50 mm are cut out",
            ),
            ("CUT", "Cut Out", "Cut the dart out, with seam allowance on its legs"),
            ("SLIT", "Slit", "Cut along the legs"),
        ],
        update=_redraw,
    )
    arrangement: EnumProperty(
        name="Pieces",
        description="How the pieces are arranged on paper or fabric",
        items=[
            ("IN_ROWS", "In Rows", "Side by side to save paper, without rotation"),
            (
                "MARKER",
                "Marker",
                "One copy of the pattern, nested as closely as possible on fabric. Fabric Width sets the width",
            ),
            ("AS_LAID_OUT", "As Laid Out", "In their places and directions in the flat object"),
        ],
        update=_redraw,
    )
    cloth_width: number(
        "Fabric Width",
        "Usable width of the fabric for the marker, in millimeters",
        (10.0, 1400.0, 5000.0, 5000.0),
        precision=0,
        step=1000,
        update=_redraw,
    )
    gap: number(
        "Gap",
        "Space between the pieces of the marker, in millimeters",
        (0.0, 5.0, 100.0, 100.0),
        step=100,
        update=_redraw,
    )
    grain: EnumProperty(
        name="Grain",
        description="Allowed rotation of the pieces in the marker",
        items=[
            ("ONE_WAY", "One Way", "No rotation, for fabric with a nap, or with a print that has a top"),
            ("BOTH_WAYS", "Both Ways", "Rotation by half a turn, for most woven fabric"),
            ("FREE", "Free", "Rotation by any angle, for leather, foam and felt"),
        ],
        update=_redraw,
    )
    paper: EnumProperty(
        name="Paper",
        description="Paper that the PDF is printed on",
        items=[
            *(
                (name.upper().replace("-", "_"), paper.label, "", number + (number >= OTHER_ROLL))
                for number, (name, paper) in enumerate(pattern.PAPERS.items())
            ),
            ("ROLL", "Roll of Another Width", "", OTHER_ROLL),
        ],
        default="A4",
        update=_redraw,
    )
    roll_width: number(
        "Roll Width",
        "Width of the roll in millimeters, including margins of 10 mm",
        (100.0, 1500.0, 5000.0, 5000.0),
        precision=0,
        update=_redraw,
    )


def take_settings(operator: bpy.types.Operator, settings: "WIREWARP_PG_settings", kind: type = FlattenSettings) -> None:
    """Copy the scene's settings to the operator, except those that the caller has set. Reset unknown values first: see
    reset_unknown. kind: FlattenSettings, PatternSettings or EaseAmount."""
    reset_unknown(settings, kind)
    for name in kind.__annotations__:
        if not operator.properties.is_property_set(name):
            setattr(operator, name, getattr(settings, name))


def reset_unknown(settings: "WIREWARP_PG_settings", kind: type = FlattenSettings) -> None:
    """Set enums to their defaults if this version of the add-on does not know their stored values."""
    for name in kind.__annotations__:
        if getattr(settings, name) == "":
            settings.property_unset(name)


def _look_for_changes(settings: bpy.types.PropertyGroup, _context: bpy.types.Context) -> None:
    if settings.auto_update:
        note_change(settings.id_data)


def _aim_at_fabric(settings: bpy.types.PropertyGroup, _context: bpy.types.Context) -> None:
    """Set the target of suggested cuts to the maximum stretch of the fabric, in the direction that stretches less."""
    if settings.cloth not in {"NONE", "CUSTOM"}:
        settings.aim_stretch = 100 * min(Cloth.preset(settings.cloth.lower()).limits)


class WIREWARP_PG_settings(FlattenSettings, PatternSettings, TargetSettings, EaseAmount, bpy.types.PropertyGroup):
    cloth: EnumProperty(**FlattenSettings.__annotations__["cloth"].keywords, update=_aim_at_fabric)
    auto_update: BoolProperty(
        name="Auto",
        description="Flatten again automatically when seams, wires, shape or scale change, as soon as no tool is "
        "running. With Modifiers, also flatten again when their result changes. Models of more than 20,000 vertices "
        "wait until you leave Edit Mode",
        update=_look_for_changes,
    )
    tolerance_percent: number(
        "Tolerance ±%",
        "How much an elastic wire may become longer or shorter, in percent of its length. Each section between "
        "seams may change that much, evenly along its length",
        (0.01, 3.0, 20.0, 99.0),
        subtype="PERCENTAGE",
        precision=2,
    )
    show_pages: BoolProperty(
        name="Show Pages",
        description="Draw the pages of a PDF over the flat pieces, or below them if the PDF arranges them differently",
        update=_redraw,
    )
    show_lines: BoolProperty(
        name="Lines",
        description="Draw outlines, seams, wires and failed areas over models and flat pieces, and over "
        "the map in the UV editor",
        default=True,
        update=_redraw,
    )
    show_names: BoolProperty(
        name="Names", description="Show the names of wires, seams and pieces", default=True, update=_redraw
    )
    shown_map: EnumProperty(
        name="Map",
        description="Measure that the colors of models and flat pieces show in Object Mode",
        items=[
            ("NONE", "No Map", "Faces keep their usual look"),
            (
                "WEFT_STRAIN_COLOR",
                "Across",
                "With a fabric: how much the threads across the grain (weft) are stretched, in percent",
            ),
            (
                "WARP_STRAIN_COLOR",
                "Along",
                "With a fabric: how much the threads along the grain (warp) are stretched, in percent",
            ),
            (
                "SHEAR_ANGLE_COLOR",
                "Shear",
                "With a fabric: how far the threads are from crossing at a right angle, in degrees",
            ),
            (
                "STRETCH_COLOR",
                "Stretch",
                "How much the flat fabric must stretch to fit the model, in percent, as the mean of all directions",
            ),
            (
                "LENGTH_VARIATION_COLOR",
                "Change of Length",
                "How much the lengths of edges in the flat pieces differ from their target lengths, in percent",
            ),
            (
                "ASPECT_RATIO_COLOR",
                "Worst Direction",
                "Stretch or compression in the worst direction, as a factor. 1: none",
            ),
            (
                "ARAP_ENERGY_COLOR",
                "Distortion",
                "Stretch and compression of all directions together (ARAP energy per area). 0: none",
            ),
        ],
        update=_redraw,
    )
    show_all: BoolProperty(name="Show All", description="Show all rows of the report's tables, not only the worst rows")


class WIREWARP_preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    moves_view: BoolProperty(
        name="Show New Pieces",
        description="Move the view to show model and pieces after the first Flatten, and whenever pieces had to move",
        default=True,
    )

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.prop(self, "moves_view")


def preferences(context: bpy.types.Context) -> WIREWARP_preferences:
    return context.preferences.addons[__package__].preferences


class WIREWARP_PG_wire_name(bpy.types.PropertyGroup):
    """The name (PropertyGroup.name) of the wire with this id."""

    wire_id: IntProperty(name="Wire Id", options={"HIDDEN"})


class WIREWARP_PG_piece(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", description="Name of the piece", update=_redraw)
    piece_id: IntProperty(name="Piece Id", options={"HIDDEN"})


class WIREWARP_PG_seam(bpy.types.PropertyGroup):
    name: StringProperty(name="Name", description="Name of the seam", update=_redraw)
    seam_id: IntProperty(name="Seam Id", options={"HIDDEN"})


def attach() -> Callable[[], None]:
    grain = "Id of the wire that is upright in the flat pieces that it crosses, 0 for none"
    source = "Model from which these flat pieces were made"
    added = {
        (bpy.types.Scene, "wirewarp"): PointerProperty(type=WIREWARP_PG_settings),
        (bpy.types.Mesh, "wirewarp_names"): CollectionProperty(type=WIREWARP_PG_wire_name),
        (bpy.types.Mesh, "wirewarp_grain"): IntProperty(name="Grain Wire", description=grain),
        (bpy.types.Mesh, "wirewarp_active_wire"): IntProperty(name="Active Wire", min=0),
        (bpy.types.Object, "wirewarp_pieces"): CollectionProperty(type=WIREWARP_PG_piece),
        (bpy.types.Object, "wirewarp_seams"): CollectionProperty(type=WIREWARP_PG_seam),
        (bpy.types.Object, "wirewarp_active_piece"): IntProperty(name="Active Piece"),
        (bpy.types.Object, "wirewarp_source"): PointerProperty(
            name="Flattened From", description=source, type=bpy.types.Object
        ),
    }
    for (owner, name), value in added.items():
        setattr(owner, name, value)

    def detach() -> None:
        for owner, name in added:
            delattr(owner, name)

    return detach
