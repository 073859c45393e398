# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws pictures of flattened samples: the model with its lines beside the flat pieces, colored by stretch."""
