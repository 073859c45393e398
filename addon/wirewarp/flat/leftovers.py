# SPDX-License-Identifier: GPL-3.0-or-later
"""What earlier versions wrote into files and this one does not: it goes when the model is flattened again."""

import bpy

from ..blender.objects import remove_object

MODEL_MAPS = {
    **dict.fromkeys(("wirewarp_arap_energy", "wirewarp_aspect_ratio", "wirewarp_stretch"), ("FLOAT", "FACE")),
    "wirewarp_length_variation": ("FLOAT", "EDGE"),
    **dict.fromkeys(
        (
            "wirewarp_aspect_ratio_color",
            "wirewarp_stretch_color",
            "wirewarp_length_variation_color",
            "wirewarp_arap_energy_color",
        ),
        ("FLOAT_COLOR", "CORNER"),
    ),
}


def remove_leftovers(source: bpy.types.Object, flat: bpy.types.Object) -> None:
    """Texts on the pieces, objects of helper wires, the report of a failure."""
    for name in ("wirewarp_failure", "wirewarp_failure_seal"):
        if name in source:
            del source[name]
    for target in [each for each in bpy.data.objects if each.library is None]:
        if _is_text(target, flat) or _is_helper_wires(target, source) or _is_helper_wires(target, flat):
            remove_object(target)


def remove_model_maps(mesh: bpy.types.Mesh) -> None:
    """What only has the name of one stays: it is not ours."""
    for name, kind in MODEL_MAPS.items():
        attribute = mesh.attributes.get(name)
        if attribute and (attribute.data_type, attribute.domain) == kind:
            mesh.attributes.remove(attribute)


def _is_text(target: bpy.types.Object, flat: bpy.types.Object) -> bool:
    return target.type == "FONT" and target.parent == flat and isinstance(target.get("wirewarp_piece"), int)


def _is_helper_wires(target: bpy.types.Object, owner: bpy.types.Object) -> bool:
    """Edges alone, with the attribute that numbered them. A surface is the user's."""
    if target.type != "MESH" or target.parent != owner or target.data.polygons:
        return False
    return "helper_wire" in target.data.attributes
