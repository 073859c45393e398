# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's sentences as they are said where pieces have names and lengths have units. No Blender in here."""

import re

from .length_units import LengthText

NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"


def plain_sentence(sentence: str, units: LengthText) -> str:
    """Of an error of a piece: its place is its name, which stands before the sentence, and a button shows it."""
    sentence = re.sub(r"\b([Tt]he piece) around face \d+(?: \(\d+ (?:face|triangle)s?\))?", r"\1", sentence)
    sentence = re.sub(rf" \(a distortion of at least {NUMBER}\)", "", sentence)
    return re.sub(rf"\b{NUMBER} long\b", lambda match: f"{units.rough(float(match[1]))} long", sentence)
