# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a name of ours is free on a mesh: attributes, UV maps, color attributes and vertex groups share one room.

Where a name is taken, Blender gives what is new another one, or makes nothing at all.
"""

import bpy

from ..issues import object_error


def check_attribute(mesh: bpy.types.Mesh, name: str, data_type: str, domain: str) -> None:
    """Raises ObjectError if an attribute of our name has another type or domain."""
    attribute = mesh.attributes.get(name)
    if attribute and (attribute.domain, attribute.data_type) != (domain, data_type):
        plural = {"EDGE": "edges", "FACE": "faces", "CORNER": "face corners"}[domain]
        raise object_error(
            "attribute_type",
            f'The attribute "{name}" of mesh "{mesh.name}" is not of type {data_type} on {plural}: '
            "rename or delete it under Object Data > Attributes.",
        )


def check_room(target: bpy.types.Object, name: str, data_type: str, domain: str, what: str) -> None:
    """Raises ObjectError if the object's mesh can have no attribute of ours of this name; what: that needs it."""
    check_attribute(target.data, name, data_type, domain)
    if name not in target.data.attributes:
        check_free(target, name, what)


def check_free(target: bpy.types.Object, name: str, what: str) -> None:
    """Raises ObjectError if something else has the name; what: that needs it, of which there is none yet."""
    holders = {
        "Vertex Groups": target.vertex_groups,
        "Attributes": target.data.attributes,
        "Color Attributes": target.data.color_attributes,
        "UV Maps": target.data.uv_layers,
    }
    for place, holder in holders.items():
        if name in holder:
            raise object_error(
                "name_taken",
                f'"{target.name}" has something called "{name}" under Object Data > {place}, and {what} needs the '
                "name: rename it.",
            )
