# SPDX-License-Identifier: GPL-3.0-or-later
"""Everybody can distinguish the colors of the overlay. The texts of the legend and the names do not overlap."""

from itertools import combinations

import numpy as np
import pytest

# Matrices that change linear RGB to colors as seen by people who lack one kind of cone (Machado, Oliveira, Fernandes
# 2009, severity 1).
VISIONS = {
    "normal": np.eye(3),
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
}
TO_XYZ = np.array([[0.41246, 0.35758, 0.18044], [0.21267, 0.71515, 0.07218], [0.01933, 0.11919, 0.95030]])
LETTER = 7.0  # width in pixels at interface scale 1
WHITE = TO_XYZ.sum(axis=1)


def lab(srgb, vision):
    """Return CIE L*a*b* (D65) of a screen color as seen with this kind of vision."""
    srgb = np.array(srgb)
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    x, y, z = (TO_XYZ @ np.clip(np.array(VISIONS[vision]) @ linear, 0, 1)) / WHITE
    fx, fy, fz = (np.cbrt(t) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116 for t in (x, y, z))
    return np.array([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)])


@pytest.mark.parametrize("vision", list(VISIONS))
def test_everybody_distinguishes_the_lines(addon, vision):
    styles = addon.overlay.lines.STYLES
    for (first, a), (second, b) in combinations(styles.items(), 2):
        if "grain" in first + second or {"page", "ease"} & {first, second}:
            continue  # Grain and ease have arrows, and pages have names in their corners.
        if {first, second} == {"cut", "allowance"}:
            continue  # Cutting lines are on flat pieces only, and marked allowances on models only.
        distance = np.linalg.norm(lab(a.color, vision) - lab(b.color, vision))
        assert distance > 30, (first, second)  # For colors side by side, 2.3 would suffice.


def test_kinds_of_wires_are_distinguished_without_color(addon):
    styles = addon.overlay.lines.STYLES
    rigid, elastic, free = (styles[kind] for kind in ("rigid", "elastic", "free"))
    assert rigid.dash is None
    assert elastic.dash[0] > 2 * free.dash[0]
    assert styles["seam"].width > 1.5 * rigid.width


def dash_lengths(addon, points, dash, gap):
    """Return the lengths of the dashes on a line through these points. Dashes that touch count as one."""
    ends = np.array([points[:-1], points[1:]], dtype=np.float32).transpose(1, 0, 2)
    offsets = np.concatenate([[0], np.cumsum(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))[:-1]])
    pieces = addon.overlay.lines.cut_into_dashes(ends, offsets, dash, gap).reshape(-1, 2, 3)
    lengths = []
    for k, (a, b) in enumerate(pieces):
        if k and np.allclose(pieces[k - 1, 1], a, atol=1e-6):
            lengths[-1] += np.linalg.norm(b - a)
        else:
            lengths.append(np.linalg.norm(b - a))
    return lengths


@pytest.mark.parametrize("count", [1, 3, 1000])
def test_dashes_are_equally_long_for_all_edges(addon, count):
    line = [(x, 0, 0) for x in np.linspace(0, 10, count + 1)]
    assert dash_lengths(addon, line, 2, 1) == pytest.approx([2, 2, 2, 1], abs=1e-4)


@pytest.mark.parametrize("vision", list(VISIONS))
def test_lines_and_their_rims_differ(addon, vision):
    for style in addon.overlay.lines.STYLES.values():
        assert abs(lab(style.color, vision)[0] - lab(style.rim, vision)[0]) > 40


@pytest.mark.parametrize("vision", list(VISIONS))
def test_equal_steps_of_a_map_are_distinguished_and_in_order(addon, vision):
    surfaces, maps = addon.overlay.gather, addon.solve.maps
    for color_map in maps.COLOR_MAPS:
        steps = color_map.colors(np.linspace(color_map.low, color_map.high, 9))
        seen = np.array([lab(color[:3], vision) for color in surfaces.screen_colors(steps)])
        assert np.linalg.norm(np.diff(seen, axis=0), axis=1).min() > 5
        lightness = seen[:, 0] if color_map.low >= 0 else seen[4:, 0]  # of values from 0 upward
        assert np.all(np.diff(lightness) < 0)
        if color_map.low < 0:
            assert np.all(np.diff(seen[:5, 0]) > 0)
            cold, warm = seen[1, 2], seen[-2, 2]
            assert warm - cold > 40 or vision == "tritanopia"


def lay_out(addon, map_name="STRETCH", notes=(), unit=1.0, highest=None):
    styles = list(addon.overlay.lines.STYLES.values())
    color_map = getattr(addon.solve.maps, map_name) if map_name else None
    width = lambda text: LETTER * unit * len(text)  # noqa: E731
    return addon.overlay.screen.lay_out(styles, notes, color_map, highest, (900.0, 16.0), unit, width)


@pytest.mark.parametrize("unit", [1.0, 2.0])
@pytest.mark.parametrize("map_name", [None, "STRETCH", "LENGTH_VARIATION", "ASPECT_RATIO", "ARAP_ENERGY"])
def test_the_legend_is_in_its_box_and_nothing_covers_a_text(addon, map_name, unit):
    legend = lay_out(addon, map_name, ["Model changed: flatten again"], unit)
    ground = legend.boxes[0]
    assert (ground.right, ground.bottom) == (900.0, 16.0)
    texts = [
        (text.left, text.base, text.left + LETTER * unit * len(text.text), text.base + 9 * unit)
        for text in legend.texts
    ]
    for left, bottom, right, top in [*texts, *((box.left, box.bottom, box.right, box.top) for box in legend.boxes)]:
        assert ground.left <= left < right <= ground.right and ground.bottom <= bottom < top <= ground.top
    for a, b in combinations(texts, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def test_the_legend_says_what_the_colors_mean(addon):
    texts = [text.text for text in lay_out(addon).texts]
    assert {style.label for style in addon.overlay.lines.STYLES.values()} < set(texts)
    numbers = ["≤ -10%", "-5%", "0%", "+5%", "≥ +10%"]
    assert [text for text in texts if "%" in text] == numbers
    assert "Stretch, mean of all directions" in texts
    texts = [text.text for text in lay_out(addon, "ARAP_ENERGY", highest=0.1837).texts]
    assert [text for text in texts if text[-1].isdigit()] == [
        "Distortion: up to 0.184",
        *("0", "0.025", "0.05", "0.075", "≥ 0.1"),
    ]


def test_the_legend_is_in_the_first_corner_where_it_covers_no_line(addon):
    screen = addon.overlay.screen
    box, corners = screen.Box(-100, 0, 0, 50, ()), [(900.0, 16.0), (130.0, 60.0), (900.0, 500.0)]
    across, beside, upright = [(700, 40), (950, 20)], [(700, 40), (799, 16)], [(60, 0), (60, 900)]

    def place(*lines):
        return screen.free_corner(corners, box, np.array(lines, dtype=float).reshape(-1, 2, 2))

    assert place() == place(beside) == place(upright) == corners[0]
    assert place(across) == corners[1]  # This line crosses the box, although both of its ends are outside.
    assert place(across, upright) == corners[2]
    assert place(across, upright, [(850, 520), (851, 520)]) == corners[0]  # because no corner is free


def test_without_anything_to_say_there_is_no_legend(addon):
    legend = addon.overlay.screen.lay_out([], [], None, None, (900.0, 16.0), 1.0, len)
    assert (legend.boxes, legend.texts) == ([], [])


def test_names_stay_at_their_lines_and_do_not_cover_each_other(addon):
    rng = np.random.default_rng(1)
    points = [place + rng.uniform(-30, 30, (4, 2)) for place in rng.uniform(0, 300, (60, 2))]
    sizes = [(40.0 + 5 * (k % 5), 10.0) for k in range(60)]
    taken = addon.overlay.screen.Taken(np.empty((0, 4)))
    corners = [taken.place(own, size) for own, size in zip(points, sizes, strict=True)]
    placed = [(*each, *corner) for *each, corner in zip(points, sizes, corners, strict=True) if corner]
    assert len(placed) > 40
    assert corners[0] == (points[0][0, 0] - 20, points[0][0, 1] + 5)  # The first name is at its best place.
    for own, (width, height), x, y in placed:
        aside = np.abs(own - (x + width / 2, y + height / 2))
        assert np.any((aside[:, 0] < 1e-6) & (aside[:, 1] <= height + 1e-6))
    boxes = [(x, y, x + width, y + height) for _, (width, height), x, y in placed]
    for a, b in combinations(boxes, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
