# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's sentences as they are said where pieces have names and lengths have units. No Blender in here."""

import re

from .length_units import LengthText

NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"
# "vertex 3", "faces 1, 2 and 12 more", "edge 3-7"; all numbers but the last, the last, whether it counts others.
LISTED = r"\b([Vv]ert(?:ex|ices)|[Ee]dges?|[Ff]aces?) ((?:\d+(?:-\d+)?(?:, | and ))*)(\d+(?:-\d+)?)( more)?\b"
PLURALS = {"vertex": "vertices", "edge": "edges", "face": "faces"}


def plain_sentence(sentence: str, units: LengthText) -> str:
    """Of an issue: a piece's name stands before its sentence, and a button shows the elements, which are counted."""
    parts = re.split(r'("[^"]*")', sentence)
    return "".join(part if part.startswith('"') else _plain(part, units) for part in parts)  # names stay as they are


def _plain(sentence: str, units: LengthText) -> str:
    sentence = re.sub(r"\b([Tt]he piece) around face \d+(?: \(\d+ (?:face|triangle)s?\))?", r"\1", sentence)
    sentence = re.sub(rf" \(a distortion of at least {NUMBER}\)", "", sentence)
    sentence = re.sub(rf"such as (?:along )?{LISTED}", "such as the proposed one", sentence)
    sentence = re.sub(r"\blong at vertex \d+", "long", sentence)
    sentence = re.sub(rf"\b{NUMBER} (?:units )?long\b", lambda match: f"{units.rough(float(match[1]))} long", sentence)
    sentence = re.sub(rf" long(?=(?:,| and) {NUMBER} \S+ long\b)", "", sentence)
    too_short = rf"\b(outline(s?), .*,) can hold no more than {NUMBER} % of its area in the plane"
    sentence = re.sub(too_short, _short, sentence)
    sentence = sentence.replace("not all finite and below 1e60 in magnitude", "no numbers, or beyond all measure")
    return re.sub(LISTED, _counted, sentence)


def _short(match: re.Match) -> str:
    outlines, plural, _ = match.groups()
    return f"{outlines} {'are' if plural else 'is'} too short to lie around it"


def _counted(match: re.Match) -> str:
    noun, others, last, more = match.groups()
    singular = "vertex" if noun.lower() == "vertices" else noun.lower().removesuffix("s")
    count = len(re.findall(r", | and ", others)) + (int(last) if more else 1)
    text = f"{count} {PLURALS[singular]}" if count > 1 else f"one {singular}"
    return text[0].upper() + text[1:] if noun[0].isupper() else text
