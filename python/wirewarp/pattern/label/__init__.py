# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts on pieces: what they say, where they have room, and the letters they are drawn with."""
