# SPDX-License-Identifier: GPL-3.0-or-later
"""What would make good pieces better: how cloth is strained, and where."""

import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from surfaces import bump, flatten, grid, half_cylinder, join_cube, mark, mark_seam, on_line


def flattened(addon, target, **settings):
    flatten(target, **settings)
    return addon.flat.reports.last_report(target)


def triangle_metrics(addon, flat):
    """Of a flat triangle whose model is the right angle with sides of 1, upright, so the flat one lies elsewhere."""
    vertices, faces = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]]), np.array([[0, 1, 2]])
    (piece,) = addon.core.library().measure(vertices, faces, np.array([flat], float)).pieces
    return piece.metrics


@pytest.mark.parametrize(
    ("flat", "stretch", "ease"),
    [
        ([[0, 0], [1, 0], [0, 1]], 0, 0),
        ([[5, 5], [5, 6], [4, 5]], 0, 0),  # moved and turned
        ([[0, 0], [0.8, 0], [0, 1]], 0.25, 0),  # cloth of 0.8 has to cover 1
        ([[0, 0], [1.25, 0], [0, 1]], 0, 0.2),  # cloth of 1.25 has to go into 1
        ([[0, 0], [0.8, 0], [0, 1.25]], 0.25, 0.2),
        # Sheared by k, (1, 0) and (k, 1): singular values s and 1/s with s - 1/s = k; for k = 1.5 that is s = 2.
        ([[0, 0], [1, 0], [1.5, 1]], 1.0, 0.5),
        ([[0, 0], [1, 0], [2, 0]], math.inf, 0),
    ],
)
def test_stretch_and_ease_are_the_principal_ones_of_flat_cloth(addon, flat, stretch, ease):
    strain = addon.report.cloth.piece_strain(triangle_metrics(addon, flat))
    assert strain.stretch == pytest.approx([stretch], abs=1e-12)
    assert strain.ease == pytest.approx([ease], abs=1e-12)


def test_regions_hang_together_by_edges(addon):
    size = 6
    row = size + 1
    corners = [y * row + x for y in range(size) for x in range(size)]
    faces = np.array([f for i in corners for f in ([i, i + 1, i + row + 1], [i, i + row + 1, i + row])])
    piece = SimpleNamespace(faces=faces, vertices=np.zeros((row * row, 2)))
    cells = np.zeros((size, size), dtype=bool)
    cells[0, :] = cells[:, 0] = True  # an L,
    cells[4, 4] = cells[5, 5] = True  # and two cells that touch at a corner only
    members = np.repeat(cells.ravel(), 2)
    regions = addon.report.cloth.connected_regions(piece, members)
    assert sorted(len(region) for region in regions) == [2, 2, 22]
    assert sorted(np.concatenate(regions)) == np.flatnonzero(members).tolist()
    assert addon.report.cloth.connected_regions(piece, np.zeros(len(faces), dtype=bool)) == []


def test_a_winding_region_is_one(addon):
    count = 300
    order = np.random.default_rng(1).permutation(count)  # neighbors far apart in number
    strip = np.array([[k, k + 1, k + 2] for k in range(count)])
    piece = SimpleNamespace(faces=strip[order], vertices=np.zeros((count + 2, 2)))
    (region,) = addon.report.cloth.connected_regions(piece, np.ones(count, dtype=bool))
    assert len(region) == count


def two_bumps(x, y):
    """Flat but for two domes, the one on the right higher."""
    height = sum(h * math.exp(-((x - c) ** 2 + y * y) / 0.05) for c, h in ((-0.5, 0.22), (0.5, 0.32)))
    return (x, y, height)


def test_the_places_of_most_strain_are_named_largest_first(addon):
    target = grid("Two Bumps", two_bumps, size=32)
    report = flattened(addon, target)
    hints = [hint for hint in report["hints"] if hint["code"] == "strained"]
    assert 2 <= len(hints) <= 4
    centers = np.array([polygon.center for polygon in target.data.polygons])
    places = [centers[hint["faces"]].mean(axis=0) for hint in hints[:2]]
    assert np.hypot(places[0][0] - 0.5, places[0][1]) < 0.2
    assert hints[0]["sentence"].endswith("near here. Add a dart or seam here.")
    assert f"{report['pieces'][0]['stretch_max'] * 100:.0f}%" in hints[0]["sentence"]
    for hint in hints:
        assert 0 < len(hint["faces"]) < len(target.data.polygons) / 2


def test_places_that_read_alike_are_one_line(addon):
    """Two equal domes, each as strained as the other."""
    target = grid("Domes", lambda x, y: (x, y, 0.3 * math.exp(-((abs(x) - 0.5) ** 2 + y * y) / 0.05)), size=32)
    (hint,) = flattened(addon, target)["hints"]
    assert hint["short"].endswith("%, at 2 places")
    centers = np.array([polygon.center for polygon in target.data.polygons])[hint["faces"]]
    assert centers[:, 0].min() < -0.4 and centers[:, 0].max() > 0.4
    assert np.abs(centers[:, 0]).min() > 0.1


def test_the_largest_figure_of_a_piece_is_among_its_hints(addon):
    """Though it is that of one small peak, beside places where a dart would do far more."""
    target = grid("Two Bumps", two_bumps, size=32)
    target.data.vertices[33 * 4 + 16].co.z = 0.07
    report = flattened(addon, target)
    (piece,) = report["pieces"]
    worst = max(piece["stretch_max"], piece["ease_max"])
    assert any(f"{100 * worst:.0f}%" in hint["short"] for hint in report["hints"])


def test_where_all_of_a_piece_is_strained_the_worst_is_pointed_at(addon):
    target = grid("Dome", lambda x, y: (x, y, 2.5 * (1 - x * x) * (1 - y * y)), size=16)
    report = flattened(addon, target)
    assert report["pieces"][0]["area_3d"] > 2 * 4  # on a square of 4: more than the limit is missing nearly everywhere
    pointed_at = [face for hint in report["hints"] for face in hint["faces"]]
    assert 0 < len(pointed_at) < 0.5 * len(target.data.polygons)
    assert set(report["pieces"][0]["stretch_faces"]) & set(pointed_at)


def test_developable_pieces_need_no_advice(addon):
    report = flattened(addon, grid("Half Cylinder", half_cylinder))
    assert report["hints"] == []
    assert report["pieces"][0]["stretch_max"] == pytest.approx(0, abs=1e-6)
    assert report["pieces"][0]["ease_max"] == pytest.approx(0, abs=1e-6)


def test_wires_at_their_limit_are_advised_longest_change_first(addon):
    target = grid("Bump", bump)
    mark(target, on_line(1, 0.0), kind="ELASTIC", tolerance=0.001)
    mark(target, on_line(0, 0.5), kind="ELASTIC", tolerance=0.002)
    report = flattened(addon, target)
    wires = [hint for hint in report["hints"] if hint["code"] == "wire_at_limit"]
    assert [hint["sentence"] for hint in wires] == [
        'Wire "Wire 2" is at its limit. A wider tolerance would lower the distortion.',
        'Wire "Wire 1" is at its limit. A wider tolerance would lower the distortion.',
    ]
    assert all(len(hint["edges"]) == 8 for hint in wires)


def test_what_failed_gets_no_advice(addon):
    source = grid("Bump", lambda x, y: (x, y, 1.5 * (1 - x * x) * (1 - y * y)))
    mark_seam(source, on_line(0, 0.0))
    join_cube(source)
    with pytest.raises(RuntimeError, match="is closed"):
        bpy.ops.object.wirewarp_flatten()
    report = addon.flat.reports.last_report(source)
    failed = [piece["index"] for piece in report["pieces"] if not piece["ok"]]
    assert report["hints"]
    assert not {hint["piece"] for hint in report["hints"]} & set(failed)
    assert [report["pieces"][index]["stretch_max"] for index in failed] == [None]


@pytest.mark.parametrize(
    ("stretch", "ease", "words", "figures"),
    [
        (0.12, 0.09, "stretch up to 12% and ease in up to 9.0%", "stretch 12%, ease 9.0%"),
        (0.12, 0.01, "stretch up to 12%", "stretch 12%"),
        (0.0, 0.34, "ease in up to 34%", "ease 34%"),
        (12.0, 0.1, "stretch more than any cloth can", "stretch over 100%"),
        (math.inf, 0.1, "stretch more than any cloth can", "stretch unlimited"),
    ],
)
def test_strain_in_words(addon, stretch, ease, words, figures):
    assert addon.report.cloth.strain_words(stretch, ease) == words
    assert addon.report.cloth.strain_figures(stretch, ease) == figures
