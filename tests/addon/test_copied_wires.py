# SPDX-License-Identifier: GPL-3.0-or-later
"""Wires that were copied, by hand or by a modifier, and share the id of their original."""

import xml.etree.ElementTree as ElementTree

import bpy
import pytest
from surfaces import flat_of, grid, mark, on_line, select_only

pytestmark = pytest.mark.api


@pytest.mark.parametrize("use_modifiers", [False, True])
def test_a_copy_of_a_wire_is_called_as_its_original_everywhere(addon, tmp_path, use_modifiers):
    """A wire that ends before the edge of a half, and its copy on the other half."""
    source = grid("Half", lambda x, y: (x + 1, y, 0.2 * x * x))
    mark(source, lambda a, b: on_line(1, 0.0)(a, b) and min(a.x, b.x) > 0.4)
    source.modifiers.new("Other Half", "MIRROR")
    if not use_modifiers:
        bpy.ops.object.modifier_apply(modifier="Other Half")
    bpy.ops.object.wirewarp_flatten(use_modifiers=use_modifiers)
    source.data.wirewarp_names[0].name = "Hip"
    both = ["Hip", "Hip (2)"]
    assert [wire.name for wire in addon.state.reports.last_report(source).wires] == both
    select_only(flat_of(source))
    drawn = addon.overlay.objects.marked_lines(flat_of(source), bpy.context.evaluated_depsgraph_get())
    assert sorted(name.texts[-1] for name in drawn.names) == ["Half", *both]
    path = tmp_path / "pattern.svg"
    bpy.ops.object.wirewarp_export_svg(filepath=str(path))
    titles = [each.text for each in ElementTree.parse(path).iter() if each.tag.endswith("title")]
    assert {"Hip", "Hip (2)"} <= set(titles) and "Wire 1 (2)" not in titles
