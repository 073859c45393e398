# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with what was given, in a sentence."""


class InputError(Exception):
    """str() is the sentence."""
