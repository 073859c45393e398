# SPDX-License-Identifier: GPL-3.0-or-later
"""Names for formats that know no other letters than ASCII."""

import re
import unicodedata


def plain_text(text: str) -> str:
    """Accents left off, other letters as question marks."""
    letters = unicodedata.normalize("NFKD", text.replace("ß", "ss"))
    kept = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return re.sub(r"[^\x20-\x7e]", "?", kept)


def block_names(names: list[str], longest: int) -> list[str]:
    """Of capitals, figures and underscores, none twice, none longer; PIECE_3 where nothing is left of the third."""
    found: list[str] = []
    for number, name in enumerate(names, start=1):
        plain = re.sub(r"[^A-Z0-9]+", "_", plain_text(name).upper()).strip("_")[:longest] or f"PIECE_{number}"
        free, again = plain, 2
        while free in found:
            free, again = f"{plain[: longest - 1 - len(str(again))]}_{again}", again + 1
        found.append(free)
    return found
