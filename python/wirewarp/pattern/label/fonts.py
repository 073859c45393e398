# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds a font on this computer that has a given letter. Fonts in WOFF2, as in Blender, need fonttools."""

import io
import os
import sys
from collections.abc import Iterator, Sequence
from functools import cache, cached_property
from pathlib import Path

import numpy as np
import uharfbuzz

Part = tuple[str, np.ndarray]  # the operator "m", "l", "c" or "h" of PDF, and its points (k,2)


class GlyphPen:
    """A pen, as fonttools defines it, that records outlines as commands of PDF. PDF has only cubic curves."""

    def __init__(self) -> None:
        self.parts: list[Part] = []
        self._at = np.zeros(2)

    def moveTo(self, point: Sequence[float]) -> None:  # noqa: N802
        self._add("m", point)

    def lineTo(self, point: Sequence[float]) -> None:  # noqa: N802
        self._add("l", point)

    def qCurveTo(self, control: Sequence[float], end: Sequence[float]) -> None:  # noqa: N802
        middle, last = np.array(control, dtype=float), np.array(end, dtype=float)
        self._add("c", (self._at + 2 * middle) / 3, (last + 2 * middle) / 3, last)

    def curveTo(self, *points: Sequence[float]) -> None:  # noqa: N802
        self._add("c", *points)

    def closePath(self) -> None:  # noqa: N802
        self.parts.append(("h", np.empty((0, 2))))

    def _add(self, operator: str, *points: Sequence[float] | np.ndarray) -> None:
        self.parts.append((operator, np.array(points, dtype=float)))
        self._at = self.parts[-1][1][-1]


SUFFIXES = (".ttf", ".otf", ".ttc", ".woff2")
NO_TEXT = ("lastresort", "adobeblank")  # parts of the names of fonts that draw every letter as a box, or draw nothing
# Fonts with these words in their names are tried last.
STYLES = ("bold", "italic", "oblique", "mono", "serif", "light", "thin", "black", "condensed")
_folders: list[Path] = []


def add_font_folder(folder: str | Path) -> None:
    """Add a folder whose fonts are tried before the fonts of the system, for example the folder of Blender's fonts."""
    if Path(folder) not in _folders:
        _folders.append(Path(folder))
        _files.cache_clear()
        font_with.cache_clear()


class Font:
    def __init__(self, path: Path, index: int = 0) -> None:
        """Open the font. Raises errors of the libraries if the file is not a font."""
        self._path, self._index = path, index
        self._outlines: dict[int, list[Part]] = {}
        if path.suffix.lower() == ".woff2":
            from fontTools.ttLib import TTFont

            # Only the list of letters is loaded, because loading all glyphs takes ten times as long.
            with TTFont(path, lazy=True) as quick:
                self._letters = set(quick.getBestCmap() or {})
        else:
            blob = uharfbuzz.Blob.from_file_path(str(path))
            self._letters = set(uharfbuzz.Face(blob, index).unicodes)

    def has(self, letter: str) -> bool:
        """Return whether the font has an outline for the letter. Emoji fonts may have pictures instead."""
        if letter.isspace() or ord(letter) not in self._letters:
            return ord(letter) in self._letters
        glyph = self.shapes.get_nominal_glyph(ord(letter))
        return glyph is not None and bool(self.outline(glyph))

    def outline(self, glyph: int) -> list[Part]:
        """Return the outline of the glyph with this index, in units of the font."""
        if glyph not in self._outlines:
            pen = GlyphPen()
            self.shapes.draw_glyph_with_pen(glyph, pen)
            self._outlines[glyph] = pen.parts
        return self._outlines[glyph]

    @cached_property
    def shapes(self) -> uharfbuzz.Font:
        if self._path.suffix.lower() == ".woff2":
            from fontTools.ttLib import woff2

            unpacked = io.BytesIO()
            woff2.decompress(str(self._path), unpacked)
            return uharfbuzz.Font(uharfbuzz.Face(unpacked.getvalue()))
        return uharfbuzz.Font(uharfbuzz.Face(uharfbuzz.Blob.from_file_path(str(self._path)), self._index))


@cache
def font_with(letter: str) -> Font | None:
    """Return the first font that has the letter; None if there is none."""
    return next((font for font in map(_font, _files()) if font and font.has(letter)), None)


@cache
def _font(path: Path) -> Font | None:
    try:
        return Font(path)
    except Exception:  # raised for a damaged file, or for WOFF2 without fonttools; other fonts are tried next
        return None


@cache
def _files() -> list[Path]:
    """Return the font files in the order in which they are tried. Plain styles come first. Of equal styles, small files
    come before large files, because small files open faster."""
    files = [path for folder in (*_folders, *_system_folders()) for path in _in(folder)]
    return sorted(files, key=lambda path: (any(s in path.name.lower() for s in STYLES), path.stat().st_size, path.name))


def _in(folder: Path) -> Iterator[Path]:
    for path in folder.rglob("*"):
        is_font = path.suffix.lower() in SUFFIXES and not any(word in path.name.lower() for word in NO_TEXT)
        if is_font and path.is_file():  # is_file() is false for a broken link
            yield path


def _system_folders() -> list[Path]:
    if sys.platform == "win32":
        local = Path(os.environ.get("LOCALAPPDATA", Path.home())) / "Microsoft/Windows/Fonts"
        return [Path(os.environ.get("WINDIR", "C:/Windows")) / "Fonts", local]
    if sys.platform == "darwin":
        return [Path("/System/Library/Fonts"), Path("/Library/Fonts"), Path.home() / "Library/Fonts"]
    return [Path("/usr/share/fonts"), Path("/usr/local/share/fonts"), Path.home() / ".local/share/fonts"]
