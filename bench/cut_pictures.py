# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws proposed seams of closed models, and prints their table:

PYTHONPATH=results:blend_samples python bench/cut_pictures.py FOLDER [NAME or MESH.obj...]

NAME: a toy of toys.py, by default all
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import wirewarp
from arrange import arrange
from cut_sets import ALLOWANCE, HEAD, Cut, best_cut, row, scale_of
from matplotlib.collections import LineCollection, PolyCollection
from mesh_files import Mesh, read_obj
from model_view import draw_model, frame
from palette import CLOTH, INK, use_style
from save_picture import save
from shapes import Shape
from tables import table
from toys import toys
from wirewarp.pattern import has_room

VIEWS = ((30, 15), (210, 15))  # degrees of both views: rotation of the model to the left, and tilt toward the viewer
SIZE = (7.2, 2.4)  # width and height of a picture in inches
TOO_NARROW = "#e3b9a0"


def draw(path: Path, mesh: Mesh, cut: Cut) -> None:
    vertices, faces = cut.mesh
    flat = wirewarp.flatten(vertices, faces, seams=cut.seams)
    shape = Shape(path.stem, vertices, [tuple(face) for face in faces.tolist()], cut.seams)
    figure, panels = plt.subplots(1, 3, figsize=SIZE, width_ratios=(1, 1, 1.6), layout="constrained")
    for axes, view in zip(panels, VIEWS, strict=False):
        draw_model(axes, shape, *view)
    arrangement = arrange(vertices, [flat], aspect=1.6)
    for piece, uv in zip(flat.pieces, arrangement.positions(0), strict=True):
        color = CLOTH if has_room(piece, ALLOWANCE / scale_of(mesh)) else TOO_NARROW
        panels[2].add_collection(PolyCollection(uv[piece.faces], facecolors=color, edgecolors=color, linewidths=0.3))
        panels[2].add_collection(LineCollection(uv[outline_sides(piece)], colors=INK, linewidths=0.8, capstyle="round"))
    frame(panels[2], np.zeros(2), arrangement.size)
    save(figure, path)


def outline_sides(piece: wirewarp.Piece) -> np.ndarray:
    sides = np.sort(np.concatenate([piece.faces[:, [k, k - 1]] for k in range(3)]), axis=1)
    edges, count = np.unique(sides, axis=0, return_counts=True)
    return edges[count == 1]


def main() -> None:
    use_style()
    folder, names = Path(sys.argv[1]), sys.argv[2:]
    folder.mkdir(parents=True, exist_ok=True)
    made = toys()
    meshes = {Path(name).stem: made[name] if name in made else read_obj(Path(name)) for name in names} or made
    rows = []
    for name, mesh in meshes.items():
        cut = best_cut(mesh, smooth=True)
        rows.append(row(name, mesh, cut))
        print(" ".join(rows[-1]), flush=True)
        draw(folder / f"{name}.png", mesh, cut)
    print("\n".join(table(HEAD, rows)))


if __name__ == "__main__":
    main()
