# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads exported SVG patterns. This module does not import bpy, because tests/bindings uses it without Blender."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np

SVG, LABEL = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}label"


class Drawing:
    def __init__(self, path):
        self.root = ElementTree.parse(path).getroot()
        self.pieces = {group.find(f"{SVG}title").text: group for group in self.root.findall(f"{SVG}g") if titled(group)}

    def layer(self, piece, label):
        return next(group for group in self.pieces[piece].findall(f"{SVG}g") if group.get(LABEL) == label)

    def lines(self, piece, label):
        """Return the lines of a layer as points (n,2). The list is empty if the piece has no such layer."""
        layers = [group for group in self.pieces[piece].findall(f"{SVG}g") if group.get(LABEL) == label]
        return [points_of(path) for layer in layers for path in layer.findall(f"{SVG}path")]

    def outlines(self):
        return [line for piece in self.pieces for line in self.lines(piece, "Cut")]


def titled(group):
    return group.find(f"{SVG}title") is not None


def points_of(path):
    numbers = np.array([float(number) for number in re.findall(r"-?[\d.]+", path.get("d"))]).reshape(-1, 2)
    return np.concatenate([numbers, numbers[:1]]) if path.get("d").endswith("Z") else numbers


def steps(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1)
