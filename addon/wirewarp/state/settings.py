# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the settings of a run and of a search, and converts them to the library's options."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from ..core import Cloth
from ..solve.flatten import ClothChoice, FlattenChoices
from ..solve.suggest import Target


def number(name: str, description: str, values: tuple[float, ...], **others: Any) -> Any:  # noqa: ANN401
    """Return a property for a number with one decimal. values: minimum, default, end of the slider, and maximum if
    any."""
    known = dict(zip(("min", "default", "soft_max", "max"), values, strict=False))
    return FloatProperty(**{"name": name, "description": description, "precision": 1} | known | others)


def in_percent(field: str) -> dict[str, Any]:
    """Return the arguments of a property that shows the property `field` in percent. `field` is a fraction."""
    return {
        "subtype": "PERCENTAGE",
        "precision": 2,
        "get": lambda operator: 100 * getattr(operator, field),
        "set": lambda operator, percent: setattr(operator, field, percent / 100),
        "options": {"SKIP_SAVE"},
    }


METHODS = [
    (
        "REFINED",
        "Refined: least distortion",
        "Lay out lines and fabric together, with the least distortion that the lengths of lines allow. Elastic wires "
        "stay within their tolerance, and free wires get the best length. Recommended",
    ),
    (
        "WIREWARP_PLUS_PLUS",
        "WireWarping++: lines first",
        "The paper's method: lay out the lines first, bent as on the model, and let the fabric follow. More "
        "distortion, and faces may flip. Elastic wires stay within their tolerance, and free wires get the best length",
    ),
    (
        "WIREWARPING",
        "WireWarping: all wires rigid",
        "Like WireWarping++, but every wire keeps its exact length. Tolerances have no effect",
    ),
]
LIBRARY_METHODS = {"REFINED": "refined", "WIREWARP_PLUS_PLUS": "wirewarp++", "WIREWARPING": "wirewarping"}
LIBRARY_ORIENTATIONS = {"WIRE": "grain", "BEST": "best", "BOUNDARY": "boundary", "UP": "up"}


MARK_AND_PULL = "mark 10 cm on it and pull until it resists: 12 cm is 20%"
MEASURE = f"The percentage is the maximum stretch. To measure your fabric, {MARK_AND_PULL}"
CUSTOM = 1000  # number of Custom Fabric in files, above the numbers of present and future presets of the library


STRETCHES = "gives_across", "gives_along"


def fabric_label(name: str) -> str:
    """Return the text of a preset, such as "Jersey, 50 / 25%", with the maximum stretch across and along the grain."""
    limits = dict.fromkeys(f"{100 * limit:.0f}" for limit in Cloth.preset(name).limits)
    return f"{Cloth.about(name)['label']}, {' / '.join(limits)}%"


def usual_stretch(settings: "FlattenSettings") -> dict[str, float]:
    """Return the maximum stretches of the chosen preset by the names of their settings; empty for other fabrics."""
    name = settings.cloth.lower()
    return dict(zip(STRETCHES, Cloth.preset(name).limits, strict=True)) if name in Cloth.presets() else {}


class FlattenSettings:
    """Settings of Flatten: shared by the scene's settings and the operator."""

    method: EnumProperty(
        name="Method",
        description="How the flat shape is found. Seams and outlines keep exactly the requested lengths",
        items=METHODS,
    )
    fairness: number(
        "Smooth Outlines",
        "Smooth out wiggles shorter than this fraction of the piece's size. Lengths stay exact. Higher values make "
        "smoother lines. Lower values distort the fabric less, but lines may be wavy",
        (0.001, 0.05, 0.5, 10.0),
        soft_min=0.02,
        precision=3,
        step=1,
    )
    node_weight: EnumProperty(
        name="Angles",
        description="For the methods that lay out lines first: which angles count more if a line cannot keep them all",
        items=[
            (
                "LENGTH",
                "By Length",
                "Every section of a line counts by its length, however fine its mesh is. Best for most models",
            ),
            ("UNIFORM", "By Vertex", "Every vertex counts the same, so finely meshed sections of a line count more"),
        ],
    )
    cloth: EnumProperty(
        name="Fabric",
        description="Material that the pieces are cut from, with its maximum stretch across and along the grain. "
        f"Lengths are exact with every fabric. To measure your fabric, {MARK_AND_PULL}",
        items=[
            ("NONE", "Fabric Not Chosen", "WireWarp says how far the fabric must stretch, in the worst direction", 0),
            *(
                (name.upper(), fabric_label(name), f"{Cloth.about(name)['description']}. {MEASURE}", number)
                for number, name in enumerate(Cloth.presets(), start=1)
            ),
            ("CUSTOM", "Custom Fabric", f"Enter the maximum stretch of your fabric. {MEASURE}", CUSTOM),
        ],
    )
    cloth_across: number(
        "Stiffness Across",
        "Resistance to stretch across the grain. Only the ratios of the three stiffness values matter",
        (0.001, 1.0, 1000.0, 1000.0),
        precision=3,
    )
    cloth_along: number(
        "Stiffness Along", "Resistance to stretch along the grain", (0.001, 1.0, 1000.0, 1000.0), precision=3
    )
    cloth_shear: number(
        "Shear Stiffness",
        "Resistance to shear, which turns the threads away from a right angle. It is small for woven fabrics",
        (0.001, 0.5, 1000.0, 1000.0),
        precision=3,
    )
    gives_across: number(
        "Max Stretch Across",
        f"How far the fabric can be stretched across the grain. To measure your fabric, {MARK_AND_PULL}. "
        "0: the usual value for this fabric",
        (0.0, 0.0, 50.0, 300.0),
        subtype="PERCENTAGE",
        step=100,
    )
    gives_along: number(
        "Max Stretch Along",
        "How far the fabric can be stretched along the grain. 0: the usual value for this fabric",
        (0.0, 0.0, 50.0, 300.0),
        subtype="PERCENTAGE",
        step=100,
    )
    worn_across: number(
        "Negative Ease Across",
        "How far the fabric is stretched across the grain when it is worn, as in swimwear. "
        "Pieces are cut smaller accordingly, with both sides of seams equally long. Below 0: larger, to fit loosely",
        (-50.0, 0.0, 50.0, 100.0),
        subtype="PERCENTAGE",
        soft_min=0.0,
    )
    worn_along: number(
        "Negative Ease Along",
        "How far the fabric is stretched along the grain when it is worn",
        (-50.0, 0.0, 50.0, 100.0),
        subtype="PERCENTAGE",
        soft_min=0.0,
    )
    thickness: number(
        "Thickness (mm)",
        "Thickness of foam, neoprene or leather. Bent material keeps its length in the "
        "middle of its thickness, so WireWarp flattens this middle surface and measures lengths on it",
        (0.0, 0.0, 20.0, 1000.0),
        precision=2,
        step=10,
    )
    surface: EnumProperty(
        name="Model Is",
        description="Which surface of the thick material was modeled",
        items=[
            ("INSIDE", "Inside", "The inner surface: the body or form that the material covers"),
            ("MIDDLE", "Middle", "The middle: half of the thickness is on each side of the model"),
            ("OUTSIDE", "Outside", "The outer surface, which is seen when the material is in place"),
        ],
    )
    layout_kind: EnumProperty(
        name="Layout",
        description="How the pieces are arranged",
        items=[
            ("PACKED", "Packed", "Close together in about a square"),
            ("ROW", "One Row", "Side by side from left to right, on one line"),
        ],
    )
    orientation: EnumProperty(
        name="Upright",
        description="Which direction is up in each flat piece",
        items=[
            (
                "WIRE",
                "Grain Wire",
                "The grain wire, which has an arrow in the list of wires. In pieces that it does not cross, and "
                "without a grain wire, the same as World Up",
            ),
            ("BEST", "Best for the Fabric", "Turn each piece so that the fabric must stretch least. Needs a fabric"),
            ("BOUNDARY", "Longest Straight Edge", "The longest straight section of the outline"),
            (
                "UP",
                "World Up",
                "Up (Z) on the model. In pieces that are level as a whole: the first wire, or else the longest outline "
                "section",
            ),
        ],
    )
    grain_angle: number(
        "Grain Angle",
        "Angle of the grain wire from upright, counterclockwise: 45° cuts the fabric on the bias. Used "
        "only for pieces in which a grain wire is upright",
        (-math.pi, 0.0, math.pi, math.pi),
        subtype="ANGLE",
        precision=2,
    )
    spacing: number(
        "Gap (mm)",
        "Space between the cutting lines of the pieces, if all edges have the widest allowance. "
        "If you change allowances later, pieces move only when you press Lay Out Again",
        (0.0, 10.0, 200.0),  # default: room for the scissors
        step=100,
    )
    keep_places: BoolProperty(
        name="Keep Places",
        description="Keep pieces where you have put them, until you change the grain wire or a setting of the layout",
        default=True,
    )
    mirror: BoolProperty(
        name="Mirrored",
        description="Show the pieces from inside (the wrong side of the fabric) instead of from outside",
    )
    use_modifiers: BoolProperty(
        name="Modifiers",
        description="Flatten the mesh with its modifiers and shape keys applied. This makes flat pieces, but no UV map "
        "on the model. Later changes of the modifiers are noticed in Object Mode only",
    )


def _cloth_of(settings: FlattenSettings, _meters: float) -> ClothChoice | None:
    if settings.cloth == "NONE":
        return None
    shares = {
        name: getattr(settings, name) / 100 for name in ("gives_across", "gives_along", "worn_across", "worn_along")
    }
    if settings.cloth == "CUSTOM":
        stiffness = {"weft": settings.cloth_across, "warp": settings.cloth_along, "shear": settings.cloth_shear}
        return ClothChoice("custom", **shares, **stiffness)
    return ClothChoice(settings.cloth.lower(), **shares)


@dataclass(frozen=True)
class Setting:
    """Data of a setting of Flatten, in addition to its property."""

    name: str  # name of the property
    choice: str = ""  # name of the field of FlattenChoices; "": no field
    # This function returns the value of the field, from all settings and the meters in a Blender unit.
    to_choice: Callable[[FlattenSettings, float], Any] | None = None
    is_advanced: bool = False  # whether the setting is rarely needed
    is_in_front: Callable[[FlattenSettings], bool] = lambda _: False  # whether the setting is above Flatten
    is_wide: bool = False  # whether the name is too long for half a narrow sidebar
    is_shown: Callable[[FlattenSettings], bool] = lambda _: True
    is_used: Callable[[FlattenSettings], bool] = lambda _: True  # whether it has an effect; otherwise, it is gray

    def part(self, settings: FlattenSettings) -> str:
        """Return the part of the panel, one of PARTS, in which the setting is drawn."""
        return "FRONT" if self.is_in_front(settings) else "ADVANCED" if self.is_advanced else "MAIN"

    @property
    def label(self) -> str:
        """Return the name of the setting in sentences, without its unit."""
        return self.full_label.removesuffix(" (mm)")

    @property
    def full_label(self) -> str:
        name: str = FlattenSettings.__annotations__[self.name].keywords["name"]
        return name


def _setting(name: str, choice: str = "", **others: Any) -> Setting:  # noqa: ANN401
    """Return a setting that passes its value to the library, texts in lower case. choice: see Setting; the default is
    the name."""
    as_it_is = lambda settings, _: value.lower() if isinstance(value := getattr(settings, name), str) else value  # noqa: E731
    return Setting(name, choice or name, **{"to_choice": as_it_is} | others)


def _in_units(name: str) -> Callable[[FlattenSettings, float], float]:
    return lambda settings, meters: getattr(settings, name) / (1000 * meters)


def _is_custom(settings: FlattenSettings) -> bool:
    return settings.cloth == "CUSTOM"


def _has_cloth(settings: FlattenSettings) -> bool:
    return settings.cloth != "NONE"


PARTS = ("FRONT", "MAIN", "ADVANCED")  # above Flatten, under Settings, under Advanced
SETTINGS = (  # in the order of the panel
    _setting("method", to_choice=lambda settings, _: LIBRARY_METHODS[settings.method], is_advanced=True),
    _setting("fairness", is_wide=True, is_used=lambda settings: settings.method == "REFINED"),
    _setting("node_weight", is_advanced=True, is_used=lambda settings: settings.method != "REFINED"),
    _setting("cloth", to_choice=_cloth_of, is_in_front=lambda _: True),
    *(Setting(name, is_in_front=_is_custom, is_shown=_has_cloth, is_wide=True) for name in STRETCHES),
    *(Setting(name, is_shown=_is_custom, is_wide=True) for name in ("cloth_across", "cloth_along", "cloth_shear")),
    *(Setting(name, is_shown=_has_cloth, is_wide=True) for name in ("worn_across", "worn_along")),
    _setting("thickness", to_choice=_in_units("thickness"), is_advanced=True),
    _setting("surface", is_advanced=True, is_used=lambda settings: settings.thickness > 0),
    _setting("layout_kind", "layout"),
    _setting("orientation", to_choice=lambda settings, _: LIBRARY_ORIENTATIONS[settings.orientation]),
    _setting("grain_angle", is_used=lambda settings: settings.orientation == "WIRE"),
    _setting("spacing", to_choice=_in_units("spacing")),
    Setting("keep_places"),
    _setting("mirror"),
    Setting("use_modifiers"),
)


class TargetSettings:
    """Settings of Suggest Darts and Suggest Seams."""

    dart_lines: EnumProperty(
        name="Lines of Cuts",
        description="Where suggested darts and sets of seams run. Seams across one piece, and cuts up to a target, "
        "follow edges of the mesh",
        items=[
            ("SMOOTH", "Smooth", "Straight or gently curved lines across faces. Marking a cut adds vertices and edges"),
            ("EDGES", "Along Edges", "Along edges and diagonals of faces. Marking a cut adds no vertices"),
        ],
        default="SMOOTH",
    )
    suggest_together: BoolProperty(
        name="Up to a Target",
        description="Suggest cuts to mark together, until the fabric need not stretch more than the target. "
        "Off: alternatives to choose from",
    )
    aim_stretch: number(
        "Max Stretch",
        "Target: the stretch that 99% of a piece may have. A piece that meets the target gets no further cuts",
        (0.0, 5.0, 25.0, 100.0),  # the default of 5% is the library's
        subtype="PERCENTAGE",
    )
    aim_cuts: IntProperty(
        name="Max Cuts",
        description="Maximum number of cuts. A cut and its mirror image count as two, the first seams of a closed "
        "model as one",
        min=1,
        max=100,
        soft_max=10,
        default=4,  # default: one dart at the bust and one at the waist on each side
    )
    aim_length: FloatProperty(
        name="Max Length",
        description="Total length of all cuts on the model. 0: unlimited",
        subtype="DISTANCE",
        min=0.0,
        precision=3,
    )


def choices_of(settings: FlattenSettings, meters: float) -> FlattenChoices:
    """Return the choices from the settings of the scene or an operator. meters: meters in a Blender unit."""
    return FlattenChoices(**{each.choice: each.to_choice(settings, meters) for each in SETTINGS if each.choice})


def target_of(settings: TargetSettings) -> Target | None:
    """Return the target; None if cuts are suggested as alternatives."""
    if not settings.suggest_together:
        return None
    return Target(settings.aim_stretch / 100, settings.aim_cuts, settings.aim_length or None)
