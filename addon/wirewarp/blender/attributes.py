# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes the add-on's mesh attributes, checks that their names are free, and seals data as text."""

import hashlib
import json
from typing import Any

import bmesh
import bpy
import numpy as np

from ..issues import object_error
from ..names import Attribute
from .mesh import read_attribute

DIGITS = 24  # hexadecimal digits of the digest that seals a text: 96 bits, which never agree by chance


def sealed(data: dict[str, Any]) -> str:
    text = json.dumps(data)
    return digest(text) + text


def unsealed(stored: object) -> dict[str, Any] | None:
    """Returns the data in a text made by sealed(), or None for other values."""
    if not isinstance(stored, str) or stored[:DIGITS] != digest(stored[DIGITS:]):
        return None
    return json.loads(stored[DIGITS:])


def stored_text(owner: bpy.types.ID, name: str) -> str:
    """Return the text of a custom property; "" if it is missing or not a string."""
    stored = owner.get(name)
    return stored if isinstance(stored, str) else ""


def digest(text: str) -> str:
    return hashlib.blake2b(text.encode(errors="replace"), digest_size=DIGITS // 2).hexdigest()


_ZEROS = {"INT": np.int32, "FLOAT": np.float32}
_ELEMENTS = {"POINT": "vertices", "EDGE": "edges", "FACE": "polygons", "CORNER": "loops"}
_PLURALS = {"POINT": "vertices", "EDGE": "edges", "FACE": "faces", "CORNER": "face corners"}


def find_values(mesh: bpy.types.Mesh, attribute: Attribute) -> np.ndarray | None:
    """Returns the values (k,), int32 or float32; None if no attribute has this name, type and domain. The mesh must
    not be in Edit Mode."""
    return read_attribute(mesh, attribute.name, attribute.data_type, attribute.domain)


def read_values(mesh: bpy.types.Mesh, attribute: Attribute) -> np.ndarray:
    """Returns the values like find_values, or zeros if there is no such attribute."""
    found = find_values(mesh, attribute)
    if found is not None:
        return found
    return np.zeros(len(getattr(mesh, _ELEMENTS[attribute.domain])), dtype=_ZEROS[attribute.data_type])


def has_attributes(mesh: bpy.types.Mesh, *attributes: Attribute) -> bool:
    found = [mesh.attributes.get(each.name) for each in attributes]
    return all(
        each and (each.data_type, each.domain) == (ours.data_type, ours.domain)
        for each, ours in zip(found, attributes, strict=True)
    )


def write_values(mesh: bpy.types.Mesh, attribute: Attribute, values: np.ndarray) -> None:
    """Writes (k,) values in Object Mode or Edit Mode, and creates the attribute if it is missing."""
    if mesh.is_editmode:
        _write_edited(mesh, attribute, values)
        return
    found = mesh.attributes.get(attribute.name)
    if found is None:
        found = mesh.attributes.new(attribute.name, attribute.data_type, attribute.domain)
    found.data.foreach_set("value", values)


def _write_edited(mesh: bpy.types.Mesh, attribute: Attribute, values: np.ndarray) -> None:
    edit = bmesh.from_edit_mesh(mesh)
    elements = {"EDGE": edit.edges, "FACE": edit.faces}[attribute.domain]
    layers = {"INT": elements.layers.int, "FLOAT": elements.layers.float}[attribute.data_type]
    layer = layers.get(attribute.name) or layers.new(attribute.name)
    for element, value in zip(elements, values.tolist(), strict=True):
        element[layer] = value
    bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def write_marked(mesh: bpy.types.Mesh, attribute: Attribute, values: np.ndarray) -> None:
    """Writes the values as write_values does, but creates no attribute if all values are zero."""
    if attribute.name in mesh.attributes or values.any():
        write_values(mesh, attribute, values)


def check_attribute(mesh: bpy.types.Mesh, attribute: Attribute) -> None:
    """Raises ObjectError if an attribute of this name has another type or domain."""
    found = mesh.attributes.get(attribute.name)
    if found and (found.domain, found.data_type) != (attribute.domain, attribute.data_type):
        raise object_error(
            "attribute_type",
            f'The attribute "{attribute.name}" of mesh "{mesh.name}" is not of type {attribute.data_type} on '
            f"{_PLURALS[attribute.domain]}. Rename or delete it under Object Data > Attributes.",
        )


def check_room(target: bpy.types.Object, attribute: Attribute, what: str) -> None:
    """Raises ObjectError if the object's mesh cannot have this attribute. what: the feature that needs it."""
    check_attribute(target.data, attribute)
    if attribute.name not in target.data.attributes:
        check_free(target, attribute.name, what)


def check_free(target: bpy.types.Object, name: str, what: str) -> None:
    """Raises ObjectError if an attribute, UV map or vertex group has this name. what: the feature that needs it."""
    # The four kinds of data below share one set of names. If a name is taken, Blender renames the new item or does not
    # create it.
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
                f'"{target.name}" has something called "{name}" under Object Data > {place}. Rename it, because {what} '
                "needs this name.",
            )
