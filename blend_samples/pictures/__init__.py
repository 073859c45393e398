# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of flattened samples: the model with its lines beside the flat pieces, colored by stretch."""
