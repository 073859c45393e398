# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on registers and unregisters completely. Operators, properties and menus have their texts and defaults."""

import inspect
import sys
import threading
from types import SimpleNamespace

import bpy
import pytest
from flattening import fails, flattened
from surfaces import bump, flat_of, grid, select_only

pytestmark = pytest.mark.api


def handlers_of(addon) -> list[tuple[str, str]]:
    """Return the add-on's handlers in Blender: for each, the names of its list and of its function."""
    return [
        (name, function.__qualname__)
        for name, functions in inspect.getmembers(bpy.app.handlers, lambda member: isinstance(member, list))
        for function in functions
        if function.__module__.startswith(addon.__name__)
    ]


def all_that_blender_knows() -> dict:
    """Return the names in the parts of Blender that the add-on extends, by kind."""
    kinds = ("Scene", "Object", "Mesh", "Collection", "WindowManager", "AddonPreferences")
    known = {kind: set(getattr(bpy.types, kind).bl_rna.properties.keys()) for kind in kinds}
    known["types"] = {name for name in dir(bpy.types) if hasattr(bpy.types, name)}
    known["operators"] = {f"{module}.{name}" for module in dir(bpy.ops) for name in dir(getattr(bpy.ops, module))}
    known["handlers"] = {
        name: list(each) for name, each in inspect.getmembers(bpy.app.handlers) if isinstance(each, list)
    }
    known["drawn"] = {
        name: list(getattr(bpy.types, name)._dyn_ui_initialize())
        for name in ("VIEW3D_MT_edit_mesh_edges", "TOPBAR_MT_file_export", "VIEW3D_MT_object", "VIEW3D_HT_header")
    }
    known["path"] = list(sys.path)
    known["threads"] = threading.enumerate()
    return known


def test_nothing_is_left_behind_and_registering_again_restores_all_handlers(addon):
    handlers = handlers_of(addon)
    addon.unregister()
    before = all_that_blender_knows()
    addon.register()
    during = all_that_blender_knows()
    addon.unregister()
    assert all_that_blender_knows() == before and handlers_of(addon) == []
    addon.register()
    assert handlers and sorted(handlers_of(addon)) == sorted(handlers)
    assert during["types"] - before["types"] and during["drawn"] != before["drawn"]
    assert during["path"] == before["path"] and during["threads"] == before["threads"]


def test_unregistering_works_after_another_add_on_cleared_the_handlers(addon):
    bpy.app.handlers.load_pre.clear()
    addon.unregister()
    assert handlers_of(addon) == []
    addon.register()


def test_a_registration_that_fails_leaves_nothing(addon, monkeypatch):
    addon.unregister()
    before = set(dir(bpy.types))

    def fail():
        raise RuntimeError("no keymap")

    with monkeypatch.context() as patch:
        patch.setattr(addon.flatten.auto_update, "attach", fail)
        fails(addon.register, "no keymap")
    assert set(dir(bpy.types)) <= before
    assert not hasattr(bpy.types.Scene, "wirewarp")
    assert handlers_of(addon) == []
    addon.register()


def test_a_second_copy_of_the_add_on_is_refused(addon):
    fails(addon.register, "already enabled")
    assert hasattr(bpy.types.Scene, "wirewarp")


def test_every_class_of_the_add_on_is_registered(addon):
    menus = addon.ui.menus.ADDED
    assert all(draw in getattr(bpy.types, name)._dyn_ui_initialize() for name, draw in menus.items())
    kinds = ("AddonPreferences", "Menu", "Operator", "Panel", "PropertyGroup", "UIList")
    bases = tuple(getattr(bpy.types, kind) for kind in kinds)
    modules = [module for name, module in sys.modules.items() if name.startswith(f"{addon.__name__}.")]
    found = {
        cls
        for module in modules
        for _, cls in inspect.getmembers(module, inspect.isclass)
        if issubclass(cls, bases) and cls.__module__ == module.__name__
    }
    assert found == set(addon.registration.CLASSES)


def test_the_panels_of_the_sidebar_come_in_the_order_of_the_work(addon):
    """Blender shows panels in the order of registration."""
    panels = [cls for cls in addon.registration.CLASSES if issubclass(cls, bpy.types.Panel)]
    first = "Mark, Allowance and Ease, Flatten, Settings, Advanced, Export, Pieces, Wires, Report, Mark Sides"
    own = [cls.bl_label for cls in panels if getattr(cls, "bl_parent_id", "") != "VIEW3D_PT_wirewarp_report"]
    assert own == [*first.split(", "), "Overlay", "Overlay"]  # The last panel is in the UV Editor.


def test_every_operator_and_its_properties_have_tooltips(addon):
    for cls in addon.registration.CLASSES:
        if not issubclass(cls, bpy.types.Operator):
            continue
        assert cls.__doc__
        own = {name for base in cls.__mro__ for name in base.__dict__.get("__annotations__", {})}
        group, name = cls.bl_idname.split(".")
        properties = getattr(getattr(bpy.ops, group), name).get_rna_type().properties
        assert own <= set(properties.keys())
        for name in own:
            assert properties[name].description, f"{cls.__name__}.{name}"
    kinds = ("RIGID", "ELASTIC", "SUPER_ELASTIC")
    describe = addon.marks.mark_operators.MESH_OT_wirewarp_mark.description
    texts = [describe(bpy.context, SimpleNamespace(kind=kind)) for kind in kinds]
    assert ["rigid" in texts[0], "elastic" in texts[1], "free" in texts[2]] == [True] * 3 and len(set(texts)) == 3


def test_the_methods_are_those_of_the_library(addon):
    method = bpy.ops.object.wirewarp_flatten.get_rna_type().properties["method"]
    assert method.default == bpy.context.scene.wirewarp.method == "REFINED"
    library = addon.core.library()
    methods = addon.state.settings.LIBRARY_METHODS
    assert methods.keys() == set(method.enum_items.keys())
    assert methods[method.default] == library.Options().method
    for name in methods.values():
        assert library.Options(method=name).method == name and name in addon.core.METHOD_NAMES
    fairness = bpy.ops.object.wirewarp_flatten.get_rna_type().properties["fairness"]
    assert fairness.default == pytest.approx(library.Options().fairness)


def test_papers_keep_the_numbers_that_files_store():
    items = bpy.context.scene.wirewarp.bl_rna.properties["paper"].enum_items
    numbers = {item.value: item.identifier for item in items}
    names = ("A4", "LETTER", "A4_LETTER", "A3", "TABLOID", "A0", "36IN", "24IN", "ROLL", "PROJECTOR")
    assert numbers == dict(enumerate(names))
    assert items[-1].identifier == "ROLL"


def test_missing_arguments_come_from_the_scene(addon):
    settings = bpy.context.scene.wirewarp
    settings.mirror, settings.spacing = True, 0.5
    given = SimpleNamespace(is_property_set=lambda name: name == "spacing")
    operator = SimpleNamespace(properties=given, spacing=0.25)
    addon.properties.take_settings(operator, settings)
    assert (operator.mirror, operator.spacing, operator.method) == (True, 0.25, "REFINED")
    grid("Bump", bump)
    bpy.ops.object.wirewarp_flatten()  # A script's call uses defaults, not settings of the scene.
    assert bpy.data.objects["Bump Flat"].data.polygons[0].normal.z > 0
    assert addon.properties.preferences(bpy.context).moves_view


class MenuLayout(SimpleNamespace):
    """Records the entries of a menu. At first, it has the operator context that Blender's own entries have set."""

    def __init__(self):
        super().__init__(operator_context="EXEC_REGION_WIN", contexts=[], menus=[], entries=[])

    def separator(self):
        pass

    def menu(self, name):
        self.menus.append(name)

    def operator(self, name, **_):
        self.contexts.append(self.operator_context)
        self.entries.append((name, SimpleNamespace()))
        return self.entries[-1][1]


def test_menu_entries_use_the_settings_of_the_scene_and_are_under_the_name_of_the_add_on(addon):
    """The search (F3) finds the entries by the name of the add-on."""
    tools = SimpleNamespace(mesh_select_mode=(False, True, False))
    menus = addon.ui.menus
    for name, draw in menus.ADDED.items():
        layout = MenuLayout()
        draw(SimpleNamespace(layout=layout), SimpleNamespace(tool_settings=tools))
        assert set(layout.contexts) <= {"INVOKE_DEFAULT"}
        assert len(layout.menus) == (0 if name == "TOPBAR_MT_file_export" else 1)
        assert all(getattr(bpy.types, menu).bl_label == "WireWarp" for menu in layout.menus)
    grid("Bump", bump)
    for cls in addon.registration.classes_of(menus):
        layout = MenuLayout()
        cls.draw(SimpleNamespace(layout=layout), bpy.context)
        assert set(layout.contexts) == {"INVOKE_DEFAULT"}


def test_on_flat_pieces_the_edge_menu_offers_only_marks_of_one_side(addon):
    source = flattened("Bump", bump)
    offered = []
    for target in (source, flat_of(source)):
        select_only(target)
        layout = MenuLayout()
        addon.ui.menus.VIEW3D_MT_wirewarp_edges.draw(SimpleNamespace(layout=layout), bpy.context)
        offered.append(layout.entries)
    on_model, on_pieces = ([each.sides for name, each in found if name == "mesh.wirewarp_ease"] for found in offered)
    assert (on_model, on_pieces) == (["ALL", "ONE", "NONE"], ["ONE", "NONE"])
    assert {name for name, _ in offered[1]} == {"mesh.wirewarp_ease", "mesh.wirewarp_allowance"}
