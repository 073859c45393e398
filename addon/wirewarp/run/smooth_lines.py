# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth lines beside edges of a model in Object Mode, cut into its mesh as seams."""

from itertools import pairwise

import bpy
import numpy as np

from .. import core
from ..issues import Issue, ObjectError
from ..model.change import clear_seams, mark_seams
from ..model.cut_lines import cut_line, unchanged_on_error
from ..model.marked_mesh import marked_mesh
from ..model.no_seam import read_no_seam
from ..model.read import object_to_arrays
from ..pattern.chains import split_into_chains
from ..solve.smooth_lines import smooth_line
from ..solve.suggest import Pairs


def cut_smooth_lines(source: bpy.types.Object, edges: Pairs) -> Pairs:
    """Each line of these edges becomes a smooth one with the same ends, which is a seam; what was one is none any more.

    Lines meet each other, other seams and wires where they did, and do not enter painted faces. Vertices keep their
    indices. Returns the edges of the smooth lines. Raises ObjectError, with no change.
    """
    mesh, seams = source.data, []
    places = object_to_arrays(source, marked_mesh(source), None).vertices
    paths = [chain.vertices for chain in split_into_chains(np.array(edges), places)]
    for path in paths:
        _check_ends(source, path)
    with unchanged_on_error(mesh):
        for index, path in enumerate(paths):
            clear_seams(mesh, list(pairwise(path)))  # before the line cuts some of these edges in two
            arrays = object_to_arrays(source, marked_mesh(source), None)
            kept = [pair for other in paths[index + 1 :] for pair in pairwise(other)]
            line = smooth_line(core.library(), arrays, path, kept, read_no_seam(source))
            cut = cut_line(mesh, line)
            mark_seams(mesh, cut)
            seams += cut
    return seams


def _check_ends(source: bpy.types.Object, path: list[int]) -> None:
    again = [vertex for index, vertex in enumerate(path) if vertex in path[:index]]
    if again:
        sentence = f'A line of "{source.name}" meets itself at vertex {again[0]}: smooth it in parts with two ends.'
        raise ObjectError(Issue("line_meets_itself", sentence, vertices=again))
