# SPDX-License-Identifier: GPL-3.0-or-later
"""Encodes and measures Latin texts in Helvetica. Every PDF reader has this font, so files do not contain it."""

import unicodedata

ENCODING = "cp1252"  # WinAnsiEncoding in PDF
# These are Adobe's widths of the characters from space to tilde, in thousandths of the height.
WIDTHS = (
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556,
    556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667,
    556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556,
    556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722,
    500, 500, 500, 334, 260, 334, 584,
)  # fmt: skip
OTHER = 556  # width of all other characters, in thousandths of the height


def encoded(text: str) -> bytes | None:
    """Return the text in the encoding of the font, if necessary without accents; None for other scripts."""
    for form in (
        text,
        "".join(letter for letter in unicodedata.normalize("NFKD", text) if not unicodedata.combining(letter)),
    ):
        try:
            return form.encode(ENCODING)
        except UnicodeEncodeError:
            continue
    return None


def width(letters: bytes, height: float) -> float:
    """Return the width of encoded letters in the unit of the height. Accents do not change the width."""
    plain = [unicodedata.normalize("NFD", letter)[0] for letter in letters.decode(ENCODING, errors="replace")]
    return height * sum(WIDTHS[ord(each) - 32] if " " <= each <= "~" else OTHER for each in plain) / 1000
