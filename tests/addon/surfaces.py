# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes small surfaces to flatten, and selects and marks their edges."""

import math
import sys
from collections.abc import Callable, Sequence
from types import ModuleType

import bmesh
import bpy
import numpy as np

# The legacy add-on and the extension have different module names.
MODULE_NAMES = ("wirewarp_addon", "bl_ext.user_default.wirewarp")


def addon_module() -> ModuleType:
    return next(sys.modules[name] for name in MODULE_NAMES if name in sys.modules)


def new_object(name: str, data: bpy.types.ID | None = None) -> bpy.types.Object:
    """Return a new object in the scene. Without data, it is an empty."""
    target = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(target)
    return target


def make_object(name: str, vertices: list, faces: list, edges: Sequence = ()) -> bpy.types.Object:
    """Return a new mesh object in the scene, active and the only one selected."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, edges, faces)
    target = new_object(name, mesh)
    select_only(target)
    return target


def select_only(*targets: bpy.types.Object) -> None:
    bpy.context.view_layer.update()  # before this update, a new object cannot be selected
    for other in bpy.context.view_layer.objects:
        other.select_set(other in targets)
    bpy.context.view_layer.objects.active = targets[0]
    bpy.context.view_layer.update()


def grid(name: str, shape: Callable, size: int = 8, faces: str = "quads", **marked: Callable) -> bpy.types.Object:
    """Return a grid of size by size cells. Its vertices are shape(x, y), for x and y from -1 to 1.

    faces: "quads", "triangles", or "ngons" of two cells, for which no three neighbors on the outline may be collinear
    marked: `seam` or `wire`, each a function of an edge's ends that returns whether the edge is marked
    """
    steps = [2 * i / size - 1 for i in range(size + 1)]
    vertices = [shape(x, y) for y in steps for x in steps]
    row = size + 1
    cells = {
        "quads": lambda i: [[i, i + 1, i + row + 1, i + row]],
        "triangles": lambda i: [[i, i + 1, i + row + 1], [i, i + row + 1, i + row]],
        "ngons": lambda i: [[i, i + 1, i + 2, i + row + 2, i + row + 1, i + row]] if i % row % 2 == 0 else [],
    }[faces]
    polygons = [face for y in range(size) for x in range(size) for face in cells(y * row + x)]
    target = make_object(name, vertices, polygons)
    for kind, line in marked.items():
        {"seam": mark_seam, "wire": mark}[kind](target, line)
    return target


def join_cube(target: bpy.types.Object) -> None:
    """Join a cube to the model. The cube cannot be flattened, because it is closed. Its faces come last."""
    bpy.ops.mesh.primitive_cube_add(location=(4, 0, 0))
    select_only(target, bpy.context.object)
    bpy.ops.object.join()


def bump(x: float, y: float) -> tuple[float, float, float]:
    """Return a point of a shallow dome over the square from -1 to 1."""
    return (x, y, 0.4 * (1 - x * x) * (1 - y * y))


def round_bump(x: float, y: float) -> tuple[float, float, float]:
    """Return a point of a dome over a square with bulging sides, so that no three outline vertices are collinear."""
    return (x * (1.3 - 0.3 * y * y), y * (1.3 - 0.3 * x * x), 0.4 * (1 - x * x) * (1 - y * y))


def half_cylinder(x: float, y: float) -> tuple[float, float, float]:
    """Return a point of a developable half cylinder of radius 1 with its axis along y."""
    angle = math.pi * x / 2
    return (math.sin(angle), y, math.cos(angle))


def on_line(axis: int, value: float) -> Callable:
    """Return a function that returns whether both ends of an edge have this value on this axis."""
    return lambda a, b: abs(a[axis] - value) < 1e-6 and abs(b[axis] - value) < 1e-6


def select_edges(target: bpy.types.Object, *lines: Callable) -> None:
    """Enter Edit Mode, and select the edges for which a function of `lines` returns True."""
    select_only(target)
    if target.mode != "EDIT":
        bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    edit = bmesh.from_edit_mesh(target.data)
    for edge in edit.edges:
        if any(line(*(vertex.co for vertex in edge.verts)) for line in lines):
            edge.select_set(True)
    bmesh.update_edit_mesh(target.data)


def everywhere(*_: object) -> bool:
    return True


def on_edges(target: bpy.types.Object, operator: Callable, *lines: Callable, **settings: object) -> set[str]:
    """Select the edges on these lines, call an operator that stays in Edit Mode, and return to Object Mode.

    Return the result of the operator.
    """
    select_edges(target, *lines)
    result = operator(**settings)
    assert target.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    return result


def mark(target: bpy.types.Object, *lines: Callable, **settings: object) -> None:
    """Mark the edges on these lines as wires, and return to Object Mode."""
    on_edges(target, bpy.ops.mesh.wirewarp_mark, *lines, **settings)


def mark_seam(target: bpy.types.Object, line: Callable) -> None:
    on_edges(target, bpy.ops.mesh.mark_seam, line, clear=False)


def flat_of(source: bpy.types.Object) -> bpy.types.Object:
    return bpy.data.objects[f"{source.name} Flat"]


def read(collection: object, name: str, dtype: type, columns: int = 1) -> np.ndarray:
    """Return a property of all items of one of Blender's collections."""
    values = np.empty(len(collection) * columns, dtype=dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values


def tube(name="Tube", sides=16, rows=6, place=0.0, length=3.0):
    """Return a tube of quads with diameter 1, open at both ends."""
    angles = [2 * math.pi * k / sides for k in range(sides)]
    vertices = [
        (place + 0.5 * math.cos(a), 0.5 * math.sin(a), length * z / rows) for z in range(rows + 1) for a in angles
    ]
    faces = [
        (z * sides + k, z * sides + (k + 1) % sides, (z + 1) * sides + (k + 1) % sides, (z + 1) * sides + k)
        for z in range(rows)
        for k in range(sides)
    ]
    return make_object(name, vertices, faces)
