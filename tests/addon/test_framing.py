# SPDX-License-Identifier: GPL-3.0-or-later
"""WireWarp moves the view so that the model and its pieces fill it."""

from types import SimpleNamespace

import numpy as np
import pytest


@pytest.fixture
def cloud():
    """Return points of a long box far from the origin, and the axes of a rotated view."""
    rng = np.random.default_rng(3)
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return np.array([50, -20, 10]) + rng.uniform(-1, 1, (200, 3)) * [8, 2, 1], axes


def on_screen(points, axes, middle, distance, across, upward, is_perspective):
    """Return the positions of points on the screen, across and upward, from -1 to 1 inside the view."""
    x, y, z = ((points - middle) @ axes).T
    depth = distance - z if is_perspective else distance
    assert np.all(depth > 0)
    return across * x / depth, upward * y / depth


@pytest.mark.parametrize("is_perspective", [True, False])
@pytest.mark.parametrize(("across", "upward"), [(1.4, 2.3), (3.0, 0.8)])
@pytest.mark.parametrize(("covered", "above"), [(0.0, 0.0), (0.3, 0.2)])
def test_the_points_fill_one_direction_and_are_central_in_both(
    addon, cloud, is_perspective, across, upward, covered, above
):
    points, axes = cloud
    framing = addon.blender.views
    middle, distance = framing.fit(points, framing.Projection(axes, across, upward, is_perspective, covered, above))
    x, y = on_screen(points, axes, middle, distance, across, upward, is_perspective)
    x, y = (x + covered) / (1 - covered), (y + above) / (1 - above)  # from -1 to 1 in the visible part
    assert max(x.max(), y.max()) == pytest.approx(1 / framing.MARGIN)
    longer = x if np.ptp(x) > np.ptp(y) else y
    assert (longer.min(), longer.max()) == pytest.approx((-1 / framing.MARGIN, 1 / framing.MARGIN))
    if not is_perspective:
        assert (x.min() + x.max(), y.min() + y.max()) == pytest.approx((0, 0))


@pytest.mark.parametrize(("legend", "covered"), [(90.0, 2 * 180), (600.0, 600)])
def test_places_are_shown_beside_the_legend_and_the_sidebar(addon, monkeypatch, legend, covered):
    """The legend covers the width with which it was last drawn, and at least 180 pixels at interface scale 1."""
    views = addon.blender.views
    monkeypatch.setattr(views, "_legend_width", 0.0)
    views.note_legend(legend)
    system = SimpleNamespace(ui_scale=2.0, use_region_overlap=True)
    context = SimpleNamespace(preferences=SimpleNamespace(system=system))
    area = SimpleNamespace(regions=[SimpleNamespace(type="UI", width=230)])
    assert views._covered(context, area) == covered + 230


@pytest.mark.parametrize(("overlaps", "headers"), [(True, 26 + 30), (False, 0)])
def test_places_are_shown_below_headers_and_texts(addon, overlaps, headers):
    """The texts cover 50 pixels at interface scale 1. Only headers at the top count."""
    system = SimpleNamespace(ui_scale=2.0, use_region_overlap=overlaps)
    context = SimpleNamespace(preferences=SimpleNamespace(system=system))
    heights = [("HEADER", "TOP", 26), ("TOOL_HEADER", "TOP", 30), ("HEADER", "BOTTOM", 26), ("UI", "RIGHT", 700)]
    regions = [SimpleNamespace(type=kind, alignment=side, height=height) for kind, side, height in heights]
    assert addon.blender.views.covered_above(context, SimpleNamespace(regions=regions)) == 2 * 50 + headers
