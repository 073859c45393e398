# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run asks for: the settings of the scene and of the operator, as the solver takes them."""

import math

from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..solve.flatten import ClothChoice, FlattenChoices

METHODS = [
    (
        "REFINED",
        "Refined: least distortion",
        "Lay out lines and cloth together, with the least distortion that these lengths allow. Elastic wires stay "
        "within their tolerance; free wires get the best length. Use this one",
    ),
    (
        "WIREWARP_PLUS_PLUS",
        "WireWarping++: lines first",
        "The paper's method: lay out the lines first, bent as on the model, and let the cloth follow. More distortion, "
        "and faces may flip. Elastic wires stay within their tolerance; free wires get the best length",
    ),
    (
        "WIREWARPING",
        "WireWarping: all wires rigid",
        "Like WireWarping++, but every wire keeps exactly its length, whatever its tolerance",
    ),
]
LIBRARY_METHODS = {"REFINED": "refined", "WIREWARP_PLUS_PLUS": "wirewarp++", "WIREWARPING": "wirewarping"}


class FlattenSettings:
    """What Flatten asks for: shared by the scene's settings and the operator."""

    method: EnumProperty(
        name="Method",
        description="How the flat shape is found. Seams and outlines keep exactly the lengths asked for",
        items=METHODS,
        default="REFINED",
    )
    fairness: FloatProperty(
        name="Smooth Outlines",
        description="Smooth wiggles shorter than this share of the piece. Lengths stay exact. More: smoother lines; "
        "less: less distortion of the cloth, but lines may come out wavy",
        min=0.001,
        max=10.0,
        soft_min=0.02,
        soft_max=0.5,
        default=0.05,
        precision=3,
        step=1,
    )
    node_weight: EnumProperty(
        name="Angles",
        description="For the methods that lay out the lines first: where a line cannot keep all its bends, which of "
        "them count more",
        items=[
            (
                "LENGTH",
                "By Length",
                "Every stretch of a line counts by its length, however fine its mesh is. Best for most models",
            ),
            (
                "UNIFORM",
                "By Vertex",
                "Every vertex counts the same, so finely meshed stretches of a line count more",
            ),
        ],
        default="LENGTH",
    )
    cloth: EnumProperty(
        name="Cloth",
        description="What the pieces are cut from. Lengths stay as exact with every cloth",
        items=[
            ("NONE", "Any", "Stretching costs the same in all directions"),
            ("WOVEN", "Woven", "Gives little along its threads and shears between them: shirting, linen, canvas"),
            ("DENIM", "Denim", "A woven that gives more across than along"),
            ("JERSEY", "Jersey", "A knit that gives in all directions, across most"),
            ("SWIM", "Swimwear", "A knit with elastane, across three times as soft as along"),
            ("LEATHER", "Leather", "Alike in all directions; hardly takes any ease"),
            ("NEOPRENE", "Neoprene", "Alike in all directions; takes little ease"),
            ("CUSTOM", "Custom", "By its stiffness across, along and against shear"),
        ],
        default="NONE",
    )
    cloth_across: FloatProperty(
        name="Stiff Across",
        description="Of a custom cloth: how hard it is to stretch across the grain. Only ratios of the three count",
        min=0.001,
        max=1000.0,
        default=1.0,
        precision=3,
    )
    cloth_along: FloatProperty(
        name="Stiff Along",
        description="Of a custom cloth: how hard it is to stretch along the grain",
        min=0.001,
        max=1000.0,
        default=1.0,
        precision=3,
    )
    cloth_shear: FloatProperty(
        name="Stiff Shear",
        description="Of a custom cloth: how hard it is to shear, to turn the threads to one another; small for wovens",
        min=0.001,
        max=1000.0,
        default=0.5,
        precision=3,
    )
    gives_across: FloatProperty(
        name="Gives Across",
        subtype="PERCENTAGE",
        description="By how much the cloth can be stretched across the grain. The report tells which pieces need more. "
        "0: not known",
        min=0.0,
        soft_max=50.0,
        max=300.0,
        precision=1,
        step=100,
    )
    gives_along: FloatProperty(
        name="Gives Along",
        subtype="PERCENTAGE",
        description="By how much the cloth can be stretched along the grain. 0: not known",
        min=0.0,
        soft_max=50.0,
        max=300.0,
        precision=1,
        step=100,
    )
    worn_across: FloatProperty(
        name="Worn Across",
        description="By how much the cloth is stretched across the grain when it is worn: swimwear, compression. The "
        "pieces are cut so much smaller, both sides of seams alike; below 0 loose",
        subtype="PERCENTAGE",
        min=-50.0,
        soft_min=0.0,
        soft_max=50.0,
        max=100.0,
        precision=1,
    )
    worn_along: FloatProperty(
        name="Worn Along",
        description="By how much the cloth is stretched along the grain when it is worn",
        subtype="PERCENTAGE",
        min=-50.0,
        soft_min=0.0,
        soft_max=50.0,
        max=100.0,
        precision=1,
    )
    thickness: FloatProperty(
        name="Thickness",
        description="Of foam, neoprene or leather, in millimeters: what bends keeps its length in the middle of its "
        "thickness, so that is what is flattened, and lengths on the model are those of its middle",
        min=0.0,
        soft_max=20.0,
        max=1000.0,
        precision=2,
        step=10,
    )
    surface: EnumProperty(
        name="Model Is",
        description="Which surface of the material the model is",
        items=[
            ("INSIDE", "Inside", "The model is the body that the material lies on"),
            ("MIDDLE", "Middle", "The material lies half on either side of the model"),
            ("OUTSIDE", "Outside", "The model is what is seen of the material"),
        ],
        default="INSIDE",
    )
    layout_kind: EnumProperty(
        name="Layout",
        description="How the pieces lie beside each other",
        items=[
            ("PACKED", "Packed", "Close together in about a square"),
            ("ROW", "One Row", "Side by side from left to right, standing on one line"),
        ],
        default="PACKED",
    )
    orientation: EnumProperty(
        name="Upright",
        description="What stands upright in each flat piece",
        items=[
            (
                "WIRE",
                "Grain Wire",
                "The wire with the arrow in the list of wires; in pieces that it does not cross their first wire. "
                "While no wire has the arrow, as World Up",
            ),
            (
                "BEST",
                "Best for the Cloth",
                "Each piece is turned so that its cloth is strained least. Needs a cloth",
            ),
            ("BOUNDARY", "Longest Straight Edge", "The longest straight stretch of the outline"),
            ("UP", "World Up", "What points up on the model, along Z; in level pieces their first wire"),
        ],
        default="WIRE",
    )
    grain_angle: FloatProperty(
        name="Grain Angle",
        description="How far the grain wire is turned from upright, counterclockwise: 45° cuts the cloth on the bias. "
        "Only of pieces that stand by a grain wire",
        subtype="ANGLE",
        min=-math.pi,
        max=math.pi,
    )
    spacing: FloatProperty(
        name="Gap",
        description="Space in millimeters between the lines to cut of pieces as they are laid out. It counts from the "
        "widest allowance there is; other allowances later move no piece until you lay out again",
        min=0.0,
        soft_max=200.0,
        default=10.0,  # for the scissors
        precision=1,
        step=100,
    )
    keep_places: BoolProperty(
        name="Keep Places",
        description="Pieces stay where they lie in the flat object, moved or turned as you have left them; new pieces "
        "go beside them. Another Layout, Upright, grain wire, Gap or Mirrored moves them all; a model that was turned "
        "does not. Off: all pieces are laid out again",
        default=True,
    )
    mirror: BoolProperty(
        name="Mirrored",
        description="Draw the pieces as seen from inside, from behind the faces, instead of from outside",
        default=False,
    )
    use_modifiers: BoolProperty(
        name="Modifiers",
        description="Flatten the mesh as modifiers and shape keys leave it. This makes flat pieces, but no UV map on "
        "the model. Later changes of the modifiers are noticed in Object Mode only",
        default=False,
    )


def choices_of(settings: FlattenSettings, meters: float) -> FlattenChoices:
    """Of the scene's settings, or of an operator's. meters: in a Blender unit."""
    return FlattenChoices(
        method=LIBRARY_METHODS[settings.method],
        fairness=settings.fairness,
        node_weight=settings.node_weight.lower(),
        layout=settings.layout_kind.lower(),
        orientation=settings.orientation.lower(),
        grain_angle=settings.grain_angle,
        spacing=settings.spacing / (1000 * meters),
        mirror=settings.mirror,
        cloth=_cloth_of(settings),
        thickness=settings.thickness / (1000 * meters),
        surface=settings.surface.lower(),
    )


def _cloth_of(settings: FlattenSettings) -> ClothChoice | None:
    if settings.cloth == "NONE":
        return None
    shares = {
        name: getattr(settings, name) / 100 for name in ("gives_across", "gives_along", "worn_across", "worn_along")
    }
    if settings.cloth == "CUSTOM":
        stiffness = {"weft": settings.cloth_across, "warp": settings.cloth_along, "shear": settings.cloth_shear}
        return ClothChoice("custom", **shares, **stiffness)
    return ClothChoice(settings.cloth.lower(), **shares)
