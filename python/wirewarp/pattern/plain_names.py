# SPDX-License-Identifier: GPL-3.0-or-later
"""Names for formats that know no other letters than ASCII."""

import re
import unicodedata


def plain_text(text: str) -> str:
    """Accents left off, other letters as question marks."""
    letters = unicodedata.normalize("NFKD", text.replace("ß", "ss"))
    kept = "".join(letter for letter in letters if not unicodedata.combining(letter))
    return re.sub(r"[^\x20-\x7e]", "?", kept)


def escaped_text(text: str) -> str:
    """As plain_text, but letters that have no ASCII as AutoCAD escapes them in files of its release 12: \\U+8896."""
    escaped = [f"\\U+{ord(letter):04X}" if ord(letter) < 0x10000 else "?" for letter in text]
    plain = [plain_text(letter) for letter in text]
    return "".join(
        code if "?" in kept and letter != "?" else kept for letter, kept, code in zip(text, plain, escaped, strict=True)
    )


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
