# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds markers: places of the pieces on the fabric."""
