# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the texts on pieces: their content, their places, and their letters."""
