# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws patterns: papers, their content, and the look of lines in every format."""
