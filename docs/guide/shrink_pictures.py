# SPDX-License-Identifier: GPL-3.0-or-later
"""Crops pictures and reduces the size of their files: shrink_pictures.py FROM TO. Needs Pillow.

The file FROM/NAME.json has the part of FROM/NAME.png to keep: left, top, right, bottom, in pixels. Without this file,
the picture is not cropped.
"""

import json
import sys
from pathlib import Path

from PIL import Image

COLORS = 256


def shrink(source: Path, target: Path) -> None:
    picture = Image.open(source).convert("RGB")
    part = source.with_suffix(".json")
    if part.exists():
        picture = picture.crop(json.loads(part.read_text()))
    palette = picture.quantize(COLORS, method=Image.Quantize.MEDIANCUT, kmeans=4)
    # The picture is dithered, so that color scales remain smooth.
    few = picture.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)
    few.save(target, optimize=True)
    print(f"{target.name}: {few.width} x {few.height}, {target.stat().st_size / 1000:.0f} kB")


def main() -> None:
    source, target = map(Path, sys.argv[1:])
    target.mkdir(parents=True, exist_ok=True)
    for old in target.glob("*.png"):
        old.unlink()
    for file in sorted(source.glob("*.png")):
        shrink(file, target / file.name)


main()
