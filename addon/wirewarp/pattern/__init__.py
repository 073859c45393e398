# SPDX-License-Identifier: GPL-3.0-or-later
"""The pattern on paper: pieces in millimeters with outlines, wires, notches and text, and its file formats.

No Blender in here.
"""
