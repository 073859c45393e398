# SPDX-License-Identifier: GPL-3.0-or-later
"""Suffixes of model files."""

BLEND = ".blend"
READ_BY_TRIMESH = (".obj", ".ply", ".stl", ".gltf", ".glb")
SUFFIXES = (*READ_BY_TRIMESH, BLEND)
