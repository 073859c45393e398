# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of the input, as sentences."""


class InputError(Exception):
    """A fault of the input. str() is the sentence."""
