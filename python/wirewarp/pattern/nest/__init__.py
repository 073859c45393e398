# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds markers, which are the places of the pieces on the fabric."""
