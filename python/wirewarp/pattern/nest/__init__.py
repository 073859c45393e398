# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds markers: how the pieces lie on cloth."""
