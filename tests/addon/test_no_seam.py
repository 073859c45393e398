# SPDX-License-Identifier: GPL-3.0-or-later
"""Where "wirewarp_no_seam" is painted, no cut is suggested: on faces, or as a vertex group."""

import bpy
import numpy as np
import pytest
from suggesting import SUGGEST, found, pairs
from surfaces import bump, grid

pytestmark = pytest.mark.api


def paint(source, data_type="BOOLEAN", domain="FACE"):
    """All that there is."""
    attribute = source.data.attributes.new("wirewarp_no_seam", data_type, domain)
    attribute.data.foreach_set("value", np.ones(len(attribute.data), dtype=np.int32))
    source.data.update()
    bpy.context.view_layer.update()


def test_cuts_go_when_their_way_is_painted(addon):
    source = grid("Bump", bump)
    SUGGEST["DARTS"]()
    source.vertex_groups.new(name="Keep Whole").add([0], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    assert found(addon, source)
    source.vertex_groups[0].name = "wirewarp_no_seam"
    bpy.context.view_layer.update()
    assert found(addon, source) is None
    with pytest.raises(RuntimeError, match="Nothing is suggested"):
        bpy.ops.object.wirewarp_mend(what="SUGGESTION")
    source.vertex_groups.clear()  # an attribute cannot have the name beside it
    source.update_tag()
    bpy.context.view_layer.update()
    SUGGEST["DARTS"]()
    assert found(addon, source)
    paint(source)
    assert found(addon, source) is None


def test_paint_during_the_search_is_noticed(addon):
    source = grid("Bump", bump)
    search = addon.suggest.operators.begin_search(bpy.context, source, "DARTS", None)
    cuts = addon.solve.steps.in_one_go(search.steps)
    paint(source)
    with pytest.raises(addon.issues.ObjectError, match='"Bump" changed during the search'):
        addon.suggest.operators.keep_found(search, cuts)


@pytest.mark.parametrize(("data_type", "domain"), [("BOOLEAN", "POINT"), ("INT", "EDGE"), ("FLOAT", "CORNER")])
def test_an_attribute_of_another_kind_is_refused(data_type, domain):
    source = grid("Bump", bump)
    paint(source, data_type, domain)
    with pytest.raises(RuntimeError, match='"wirewarp_no_seam" of mesh "Bump" is not of type BOOLEAN, INT8, INT or'):
        SUGGEST["DARTS"]()


@pytest.mark.parametrize("kind", ["FACES", "GROUP"])
def test_no_cut_runs_where_none_is_wanted(addon, kind):
    source = grid("Bump", bump, faces="triangles")
    SUGGEST["DARTS"]()
    cut = found(addon, source).cuts[0].edges
    mesh = source.data
    if kind == "FACES":
        attribute = mesh.attributes.new("wirewarp_no_seam", "BOOLEAN", "FACE")
        painted = [bool(set(face.vertices) & set(np.unique(cut).tolist())) for face in mesh.polygons]
        attribute.data.foreach_set("value", painted)
    else:
        source.vertex_groups.new(name="wirewarp_no_seam").add(np.unique(cut).tolist(), 1.0, "REPLACE")
    SUGGEST["DARTS"]()
    for other in found(addon, source).cuts:
        assert not pairs(cut) & pairs(other.edges)


@pytest.mark.parametrize("data_type", ["BOOLEAN", "INT8", "INT", "FLOAT"])
def test_a_painted_model_leaves_no_way(data_type):
    paint(grid("Bump", bump), data_type)
    sentence = 'no room for a dart.*Nor may a seam run where "wirewarp_no_seam" is painted'
    with pytest.raises(RuntimeError, match=sentence):
        SUGGEST["DARTS"]()
