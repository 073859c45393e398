# SPDX-License-Identifier: GPL-3.0-or-later
"""All of a model that its flat pieces depend on, in short: by it a report sees that the model has changed since."""

import hashlib

import bmesh
import bpy
import numpy as np

from ..blender.cache import Take, kept
from ..blender.mesh import corner_vertices, face_sizes, read, read_seams
from ..blender.objects import metric
from ..issues import ObjectError
from ..pattern.chains import EdgeMarks
from ..solve.arrays import MeshArrays
from .attributes import read_edit_marks, read_marks

MODIFIED = "modified"  # of reports with modifiers
UNKNOWN = {"faces": "?"}  # unlike any mesh
EDIT_LIMIT = 20_000  # vertices; larger meshes are not compared while in Edit Mode, where reading them is slow
BLOCKS = 64  # of vertices: one number for each of them and each axis
MOVED = 1e-6  # rounding of coordinates in single precision that went through matrices, by their size
UNMOVED = 1.2e-7  # of the last digit


def model_state(source: bpy.types.Object, base: MeshArrays | None) -> dict:
    """For the report. Of a model in Object Mode; base: its base mesh as read, None if modifiers were applied to it."""
    shape, marks = _gather(source.data, base)
    state = {"shape": _digest(shape), "marks": _digest(marks), "metric": metric(source).tolist()}
    return state if base else state | {MODIFIED: _modified(source)}


def present_state(source: bpy.types.Object, with_modifiers: bool) -> dict | None:
    """As model_state, in Edit Mode too; None where that would be slow or cannot be compared."""
    if source.data.is_editmode and not _comparable_in_edit_mode(source.data):
        return None
    try:
        state = kept(source.data, "digests", _digests) | {"metric": metric(source).tolist()}
        return state | {MODIFIED: _modified(source) or UNKNOWN} if with_modifiers else state
    except ObjectError:  # an attribute of our name that is none
        return None


def has_changed(source: bpy.types.Object, report: dict, take: Take = kept) -> bool:
    """Whether geometry, seams, wires or scale are other than when the report was made; take: kept, or read_anew.

    Of a report with modifiers, also whether these make another mesh; not where that cannot be seen: see shows_modified.
    """
    state, mesh = report.get("model_state"), source.data
    if state is None:
        return False
    if _is_scaled(source, state):
        return True
    if mesh.is_editmode and not _comparable_in_edit_mode(mesh):
        return False
    try:
        if any(state.get(part) != digest for part, digest in take(mesh, "digests", _digests).items()):
            return True
        then, now = state.get(MODIFIED), _modified(source, take)
        return None not in (then, now) and not _is_same(then, now)
    except ObjectError:  # an attribute of our name that was none when the report was made
        return True


def shows_modified(source: bpy.types.Object) -> bool:
    """Whether what modifiers make can be seen: Blender makes nothing of hidden objects, and less in Edit Mode."""
    return source.mode == "OBJECT" and source.visible_get()


def _modified(source: bpy.types.Object, take: Take = kept) -> dict | None:
    """Of the mesh as modifiers and shape keys leave it; None where that cannot be seen."""
    return take(source, MODIFIED, _modified_state) if shows_modified(source) else None


def _modified_state(source: bpy.types.Object) -> dict:
    """From what Blender has made already: evaluated_mesh would make it once more, for layers that are not asked for."""
    evaluated = source.evaluated_get(bpy.context.view_layer.depsgraph)
    try:
        (points, *faces), marks = _gather(evaluated.to_mesh())
        return {
            "faces": _digest(faces + marks),
            "points": _digest([points]),
            "matrix": [value for row in source.matrix_world for value in row],
            "sums": place_sums(points),
            "rounding": rounding_of_sums(points, MOVED, source.matrix_world.translation.length),
            "last_digits": rounding_of_sums(points, UNMOVED),
        }
    finally:
        evaluated.to_mesh_clear()


def _is_same(then: dict, now: dict) -> bool:
    """But for rounding, which is more where the object was moved: see place_sums."""
    if then["faces"] != now["faces"]:
        return False
    is_unmoved = then["matrix"] == now["matrix"]
    rounding = 2 * now["last_digits"] if is_unmoved else then["rounding"] + now["rounding"]
    return then["points"] == now["points"] or are_same_places(then["sums"], now["sums"], rounding)


def has_moved(source: bpy.types.Object, report: dict) -> bool:
    """Whether geometry or scale are other than when the report was made, whatever its seams and wires are now.

    Of a model in Object Mode; a report that cannot tell counts as one of another model. Raises ObjectError.
    """
    state = report.get("model_state")
    return state is None or _is_scaled(source, state) or _digests(source.data)["shape"] != state.get("shape")


def _is_scaled(source: bpy.types.Object, state: dict) -> bool:
    now, then = metric(source), np.array(state["metric"])
    return not np.allclose(now, then, rtol=1e-5, atol=1e-5 * np.abs(then).max())


def _comparable_in_edit_mode(mesh: bpy.types.Mesh) -> bool:
    """Edit Mode shows the active shape key and not the base mesh."""
    return mesh.shape_keys is None and len(bmesh.from_edit_mesh(mesh).verts) <= EDIT_LIMIT


def _digests(mesh: bpy.types.Mesh) -> dict[str, str]:
    shape, marks = _gather_edit(mesh) if mesh.is_editmode else _gather(mesh)
    return {"shape": _digest(shape), "marks": _digest(marks)}


def _digest(arrays: list[np.ndarray]) -> str:
    digest = hashlib.blake2b(digest_size=12)
    for values in arrays:
        digest.update(np.ascontiguousarray(values).data)
    return digest.hexdigest()


def _gather(mesh: bpy.types.Mesh, base: MeshArrays | None = None) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Coordinates and corners; seams and wires; the same as _gather_edit finds."""
    return [
        read(mesh.vertices, "co", np.float32, 3),
        base.loop_vertices if base else corner_vertices(mesh),
        base.polygon_sizes if base else face_sizes(mesh),
    ], [np.flatnonzero(read_seams(mesh)).astype(np.int32), *_wires(read_marks(mesh))]


def _gather_edit(mesh: bpy.types.Mesh) -> tuple[list[np.ndarray], list[np.ndarray]]:
    edit = bmesh.from_edit_mesh(mesh)
    edit.verts.index_update()
    return [
        np.array([vertex.co[:] for vertex in edit.verts], dtype=np.float32),
        np.array([vertex.index for face in edit.faces for vertex in face.verts], dtype=np.int32),
        np.array([len(face.verts) for face in edit.faces], dtype=np.int32),
    ], [
        np.array([number for number, edge in enumerate(edit.edges) if edge.seam], dtype=np.int32),
        *_wires(read_edit_marks(edit)),
    ]


def _wires(marks: EdgeMarks) -> tuple[np.ndarray, ...]:
    wires = marks.take(marks.rows)
    return marks.rows.astype(np.int32), wires.wire_ids, wires.tolerances


def place_sums(points: np.ndarray) -> list[float]:
    """Of points (n,3)."""
    numbers = np.arange(len(points))
    blocks = numbers * BLOCKS // max(len(points), 1)
    wave = np.cos(2.4 * numbers)
    weights = (wave + np.sign(wave)) / 2  # none near 0, and together near 0: what rounding does to all alike cancels
    sums = [np.bincount(blocks, weights * column, minlength=BLOCKS) for column in _finite(points).T]
    return np.concatenate(sums).tolist()


def rounding_of_sums(points: np.ndarray, share: float, distance: float = 0.0) -> float:
    """How far rounding of the points (n,3) may take their sums. share: UNMOVED or MOVED, then with the distance of the
    object from the world's origin.
    """
    size = float(np.abs(_finite(points)).max(initial=0)) + distance
    return share * size * float(np.sqrt(max(len(points) / BLOCKS, 1)))


def are_same_places(first: list[float], second: list[float], rounding: float) -> bool:
    """Sums of meshes with the same vertices and faces; rounding: of both together."""
    return bool(np.allclose(first, second, rtol=0, atol=rounding))


def _finite(points: np.ndarray) -> np.ndarray:
    return np.nan_to_num(points.astype(np.float64), posinf=0, neginf=0)
