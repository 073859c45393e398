# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures proposed seams of closed models, and prints a table with a row for each model:

python bench/cut_sets.py [--smooth] [--strain 0.08] MESH.obj...
"""

import argparse
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import wirewarp
from mesh_files import Mesh, read_obj
from tables import table
from wirewarp.pattern import has_room, piece_width

SOFT = 0.2  # maximum stretch of plush and stable knits
HEIGHT = 300  # mm of the finished toy, along its largest side
ALLOWANCE = 6  # mm: 5 mm, the usual allowance of plush, and 1 mm for turning the toy right side out
BEND = 30  # degrees; a sharper turn of an outline counts as a bend
SAME_PLACE = 1e-4  # share of the largest side; a vertex about this close to a mirrored vertex is its mirror image
HEAD = ["mesh", "triangles", "pieces", "with room", "strain", "length", "narrowest, mm", "bends", "symmetric", "s"]


def mirror_images(vertices: np.ndarray) -> list[int] | None:
    """Return the mirror image of each vertex; None if the model is not symmetric across its middle in x, y or z."""
    size, low = float(np.ptp(vertices, axis=0).max()), vertices.min(axis=0)
    near = np.array(np.meshgrid(*[[0, 1, -1]] * 3)).reshape(3, -1).T
    places = {tuple(place): v for v, place in enumerate(np.rint((vertices - low) / size / SAME_PLACE).astype(int))}
    for axis in range(3):
        mirrored = vertices.copy()
        mirrored[:, axis] = vertices[:, axis].min() + vertices[:, axis].max() - vertices[:, axis]
        images = []
        for place in np.rint((mirrored - low) / size / SAME_PLACE).astype(int):
            found = next((places[tuple(each)] for each in place + near if tuple(each) in places), None)
            if found is None:
                break
            images.append(found)
        if len(images) == len(vertices):
            return images
    return None


def is_symmetric(edges: np.ndarray, images: list[int]) -> bool:
    mirrored = {frozenset((images[a], images[b])) for a, b in edges.tolist()}
    return mirrored == {frozenset(pair) for pair in edges.tolist()}


def num_bends(pieces: list[wirewarp.Piece], edges: np.ndarray) -> int:
    """Return the number of inner vertices of seams at which an outline of a flat piece turns by more than BEND."""
    inside = np.flatnonzero(np.bincount(edges.ravel()) == 2)
    bent: set[int] = set()
    for piece in pieces:
        corners = np.array([angles(piece.vertices[np.roll(piece.faces, -k, axis=1)]) for k in range(3)])
        total = np.bincount(piece.faces.T.ravel(), corners.ravel(), minlength=len(piece.vertices))
        turns = np.abs(np.pi - total) > np.radians(BEND)
        bent |= set(piece.source_vertex[turns].tolist())
    return len(bent.intersection(inside.tolist()))


def angles(triangles: np.ndarray) -> np.ndarray:
    """Return the angle at the first corner of each triangle, in radians. triangles: (m, 3, 2)."""
    a, b = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    return np.arctan2(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]), (a * b).sum(axis=1))


def scale_of(mesh: Mesh) -> float:
    """Return millimeters per unit of the mesh."""
    return HEIGHT / float(np.ptp(mesh[0], axis=0).max())


@dataclass(frozen=True)
class Cut:
    proposal: wirewarp.DartProposal
    seconds: float  # processor time of the search
    mesh: Mesh  # the cut model, with new vertices if smooth seams cross triangles
    seams: np.ndarray  # (k, 2) edges of `mesh`


def best_cut(mesh: Mesh, smooth: bool = False, strain: float | None = None) -> Cut:
    """Return the set with the fewest pieces and at most this strain, or else the set with the least strain.

    strain: requested strain; None: SOFT, without a request
    """
    begin = time.process_time()
    sets = wirewarp.propose_seams(*mesh, strain=strain, narrowest=2 * ALLOWANCE / scale_of(mesh), smooth=smooth)
    seconds = time.process_time() - begin
    allowed = [each for each in sets if each.strain <= (SOFT if strain is None else strain)]
    best = min(allowed, key=lambda each: each.num_pieces) if allowed else min(sets, key=lambda each: each.strain)
    if len(best.edges):
        return Cut(best, seconds, mesh, best.edges)
    vertices, faces, seams, _ = wirewarp.cut_mesh(*mesh, best.paths)
    return Cut(best, seconds, (vertices, faces), seams)


def row(name: str, mesh: Mesh, cut: Cut) -> list[str]:
    points = mesh[0][mesh[1]]
    area = np.linalg.norm(np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1).sum() / 2
    vertices, faces = cut.mesh
    pieces = wirewarp.flatten(vertices, faces, seams=cut.seams).pieces
    scale = scale_of(mesh)
    width = min(map(piece_width, pieces)) * scale
    images = mirror_images(vertices)
    return [
        name,
        f"{len(mesh[1]):,}",
        str(cut.proposal.num_pieces),
        str(sum(has_room(piece, ALLOWANCE / scale) for piece in pieces)),
        f"{100 * cut.proposal.strain:.1f}%",
        f"{cut.proposal.length / np.sqrt(area):.2f}",
        f"{width:.1f}",
        str(num_bends(pieces, cut.seams)),
        "–" if images is None else "yes" if is_symmetric(cut.seams, images) else "no",
        f"{cut.seconds:.0f}",
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--smooth", action="store_true", help="propose smooth seams")
    parser.add_argument("--strain", type=float, help=f"requested strain; default: at most {SOFT}, without a request")
    parser.add_argument("meshes", nargs="+", type=Path, metavar="MESH.obj")
    arguments = parser.parse_args()
    rows = []
    for path in arguments.meshes:
        mesh = read_obj(path)
        rows.append(row(path.stem, mesh, best_cut(mesh, arguments.smooth, arguments.strain)))
        print(" ".join(rows[-1]), flush=True)
    print("\n".join(table(HEAD, rows)))


if __name__ == "__main__":
    main()
