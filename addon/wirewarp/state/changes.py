# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the state of a model: a summary of everything that its flat pieces depend on, to detect later changes."""

import hashlib

import bpy
import numpy as np

from ..blender.objects import metric
from ..issues import ObjectError
from .marked_mesh import MarkedMesh, marked_mesh, read_marked
from .memory import Take, kept, read_anew

SHAPE, FACES, MARKS, SCALE = "shape", "faces", "marks", "metric"
MATRIX, LENGTHS = "matrix", "lengths"  # keys to recognize an applied transformation
MODIFIED = "modified"  # key of the state with modifiers
# Number of blocks of vertices. The coordinates of each block are summed. With more blocks, sums have smaller rounding
# errors, but the file stores more numbers.
BLOCKS = 64
ROUNDING = 1e-6  # relative rounding error of single-precision coordinates after transformations


def model_state(source: bpy.types.Object, base: MarkedMesh, with_modifiers: bool) -> dict:
    """Return the state of the model that a report stores. base: the object's base mesh."""
    state = _state(source, _digests(base), with_modifiers, read_anew)
    return state | {LENGTHS: _length_sums(base, _linear(source))}


def present_state(source: bpy.types.Object, with_modifiers: bool, take: Take = read_anew) -> dict:
    """Return the present state like model_state, but without lengths. Works in Edit Mode, too.

    take: read_anew or kept
    Raises ObjectError if an attribute of another add-on has one of our names.
    """
    digests = take(source.data, "digests", lambda _: _digests(marked_mesh(source, take)))
    return _state(source, digests, with_modifiers, take)


def _state(source: bpy.types.Object, digests: dict, with_modifiers: bool, take: Take) -> dict:
    matrix = np.array(source.matrix_world, dtype=np.float64)
    state = digests | {SCALE: metric(source).tolist(), MATRIX: matrix.ravel().tolist()}
    if with_modifiers:  # the value is None if Blender does not evaluate the modifiers
        state[MODIFIED] = take(source, MODIFIED, _modified_state) if shows_modified(source) else None
    return state


def has_changed(source: bpy.types.Object, state: dict | None, take: Take = kept) -> bool:
    """Return whether geometry, marks or scale differ from a report's model_state. For a report with modifiers, also
    compare their result, if Blender evaluates them: see shows_modified. take: kept or read_anew."""
    return state is not None and bool(_changes(source, state, take))


def has_moved(source: bpy.types.Object, state: dict | None) -> bool:
    """Return whether geometry or scale differ from the report's state. Changes of seams and wires do not count. Return
    True for a report without a state."""
    return state is None or bool(_changes(source, state, read_anew) & {SHAPE, SCALE})


def shows_modified(source: bpy.types.Object) -> bool:
    """Return whether Blender evaluates the modifiers. It skips modifiers of hidden objects, and some in Edit Mode."""
    return source.mode == "OBJECT" and source.visible_get()


def _changes(source: bpy.types.Object, then: dict, take: Take) -> set[str]:
    """Return the kinds of differences from the state `then`: SHAPE, MARKS, SCALE and MODIFIED."""
    if source.data.is_editmode and source.data.shape_keys:  # Edit Mode shows the active shape key, not the base mesh
        return {SCALE} if _is_scaled(source, then) else set()
    try:
        now = present_state(source, MODIFIED in then, take)
    except ObjectError:  # after the state `then`, an attribute with one of our names was made
        return {SHAPE, MARKS}
    changes = {part for part in (SHAPE, MARKS) if then.get(part) != now[part]}
    if _is_scaled(source, then):
        changes.add(SCALE)
    is_applied = SHAPE in changes and _is_applied(source, then, now, take)
    if is_applied:
        changes -= {SHAPE, SCALE}
    if now.get(MODIFIED) and not _is_same(then[MODIFIED], now[MODIFIED], is_applied):
        changes.add(MODIFIED)
    return changes


def _is_applied(source: bpy.types.Object, then: dict, now: dict, take: Take) -> bool:
    """Return whether the user has applied a transformation: vertices and matrix have changed, but no length."""
    # If the matrix is the same, even the smallest change of a vertex counts as a change.
    if LENGTHS not in then or then[MATRIX] == now[MATRIX] or then[FACES] != now[FACES]:
        return False
    if (then[SCALE][-1] < 0) != (now[SCALE][-1] < 0):  # mirrored
        return False
    return _are_close(then[LENGTHS], _length_sums(marked_mesh(source, take), _linear(source)))


def _linear(source: bpy.types.Object) -> np.ndarray:
    return np.array(source.matrix_world, dtype=np.float64)[:3, :3]


def _is_scaled(source: bpy.types.Object, then: dict) -> bool:
    was = np.array(then[SCALE])
    return not np.allclose(metric(source), was, rtol=1e-5, atol=1e-5 * np.abs(was).max())


def _digests(mesh: MarkedMesh) -> dict[str, str]:
    places = mesh.places + np.float32(0)  # -0 becomes 0, because Apply Scale changes -0 to 0, too
    faces = _digest(_faces(mesh))
    return {SHAPE: _digest([places, *_faces(mesh)]), FACES: faces, MARKS: _digest(_marks(mesh))}


def _length_sums(mesh: MarkedMesh, linear: np.ndarray) -> dict:
    """Return sums of the lengths of edges and diagonals of faces in the world, and their rounding error.

    The shapes of pieces depend only on these lengths. linear (3,3): from the mesh to the world
    """
    points = _finite(mesh.places) @ linear.T
    corners, sizes = mesh.corner_vertices, np.repeat(mesh.face_sizes, mesh.face_sizes)
    begins = np.repeat(np.cumsum(mesh.face_sizes) - mesh.face_sizes, mesh.face_sizes)
    at = np.arange(len(corners)) - begins
    ends = [corners[begins + (at + step) % sizes] for step in (1, 2)]
    lengths = np.concatenate([np.linalg.norm(points[end] - points[corners], axis=1) for end in ends])
    return {"sums": place_sums(lengths[:, None]), "rounding": _rounding(np.abs(points).max(initial=0), len(lengths))}


def _modified_state(source: bpy.types.Object) -> dict:
    """Return the state of the existing evaluated mesh."""
    # evaluated_mesh() is not used, because it would evaluate the object again to get more layers.
    evaluated = source.evaluated_get(bpy.context.view_layer.depsgraph)
    try:
        mesh = read_marked(evaluated.to_mesh())
        # Coordinates are summed and not hashed, because their rounding varies. Moving the object and the object of a
        # modifier together changes the rounding. Up to Blender 3.6, threads also sum normals in varying order.
        rounding = rounding_of_sums(mesh.places, source.matrix_world.translation.length)
        state = {FACES: _digest(_faces(mesh) + _marks(mesh)), "sums": place_sums(mesh.places), "rounding": rounding}
        return state | {LENGTHS: _length_sums(mesh, _linear(source))}
    finally:
        evaluated.to_mesh_clear()


def _is_same(then: dict | None, now: dict, is_applied: bool) -> bool:
    """Return whether two states of meshes with modifiers are equal except for rounding. is_applied: whether the user
    has applied a transformation in between, so that equal lengths suffice."""
    if then is None or then[FACES] != now[FACES]:
        return False
    return _are_close(then, now) or (is_applied and LENGTHS in then and _are_close(then[LENGTHS], now[LENGTHS]))


def _are_close(then: dict, now: dict) -> bool:
    return np.allclose(then["sums"], now["sums"], rtol=0, atol=then["rounding"] + now["rounding"])


def _digest(arrays: list[np.ndarray]) -> str:
    digest = hashlib.blake2b(digest_size=12)
    for values in arrays:
        digest.update(np.ascontiguousarray(values).data)
    return digest.hexdigest()


def _faces(mesh: MarkedMesh) -> list[np.ndarray]:
    return [mesh.corner_vertices, mesh.face_sizes]


def _marks(mesh: MarkedMesh) -> list[np.ndarray]:
    seams, rows, eased = (np.flatnonzero(each) for each in (mesh.seams, mesh.marks.wire_ids, mesh.side_eases))
    wires = mesh.marks.take(rows)
    numbers = (each.astype(np.int32) for each in (seams, rows, eased))
    return [*numbers, wires.wire_ids, wires.tolerances, wires.eases, mesh.side_eases[eased]]


def place_sums(points: np.ndarray) -> list[float]:
    """Return weighted sums of the points (n,3). If a single point moves, the sums change by at least half as much."""
    numbers = np.arange(len(points))
    blocks = numbers * BLOCKS // max(len(points), 1)
    wave = np.cos(2.4 * numbers)
    # No weight is near 0. The sum of the weights is near 0, so that a rounding error common to all points cancels.
    weights = (wave + np.sign(wave)) / 2
    sums = [np.bincount(blocks, weights * column, minlength=BLOCKS) for column in _finite(points).T]
    return np.concatenate(sums).tolist()


def rounding_of_sums(points: np.ndarray, distance: float) -> float:
    """Return the largest change of place_sums of points (n,3) that rounding can cause. distance: distance of the object
    from the world's origin."""
    return _rounding(float(np.abs(_finite(points)).max(initial=0)) + distance, len(points))


def _rounding(size: float, count: int) -> float:
    """Return the largest change of place_sums that rounding can cause. size: largest coordinate; count: number of
    points."""
    return float(ROUNDING * size * np.sqrt(max(count / BLOCKS, 1)))


def _finite(points: np.ndarray) -> np.ndarray:
    return np.nan_to_num(points.astype(np.float64), posinf=0, neginf=0)
