# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts on pieces: their content, their places, and their letters."""
