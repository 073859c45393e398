# SPDX-License-Identifier: GPL-3.0-or-later
"""Uses every panel, overlay and operator in turn. In any file, each of them must work or report why it does not."""

from types import SimpleNamespace

import bpy
import numpy as np
from surfaces import read, select_only
from view_context import view_context

EDGE = {"edge": 0}
OURS = ("wirewarp_", "source_", "flat_", "piece")  # prefixes of the add-on's attributes and properties
KINDS = ("SEAM", "WIRE", "OUTLINE", "PIECE", "STRETCH", "EASE", "ISSUE", "HINT")
FIXES = ("SEAMS", "TOLERANCES", "MODIFIERS", "DISSOLVE", "MERGE", "NORMALS", "SUGGESTION", "APPLY")
COMMANDS = [  # Operators that change marks or pieces come last, so that the others meet the damaged data.
    ("object.wirewarp_copy_report", {}),
    ("mesh.wirewarp_select_issues", {}),
    *(("mesh.wirewarp_select_result", {"what": what, "index": 0}) for what in KINDS),
    ("mesh.wirewarp_select_wire", {"edge": -1}),
    ("mesh.wirewarp_select_wire", EDGE),
    ("object.wirewarp_export_svg", {}),
    ("object.wirewarp_export", {}),
    ("object.wirewarp_sewing", {}),
    ("object.wirewarp_suggest_seams", {"piece": 0}),
    ("object.wirewarp_simplify_seams", {}),
    ("object.wirewarp_suggest_darts", {}),
    ("object.wirewarp_choose_suggestion", {"index": 1}),
    ("mesh.wirewarp_take_proposal", {"what": "SEAMS", "issue": 0}),
    ("mesh.wirewarp_take_proposal", {"what": "TOLERANCES", "issue": 0}),
    *(("object.wirewarp_mend", {"what": what}) for what in FIXES),
    ("mesh.wirewarp_grain_wire", EDGE),
    ("mesh.wirewarp_change_wire", EDGE | {"kind": "ELASTIC"}),
    ("mesh.wirewarp_mark", {"kind": "RIGID"}),
    ("mesh.wirewarp_clear", {}),
    ("mesh.wirewarp_allowance", {"kind": "HEM"}),
    ("mesh.wirewarp_ease", {"sides": "ONE"}),
    ("mesh.wirewarp_seams_from_uv_islands", {}),
    ("object.wirewarp_flatten", {}),
    ("object.wirewarp_flatten", {"use_modifiers": True}),
]
# Together, these commands read all stored data: report, source faces, pieces, names, marks, and the whole model.
READERS = [
    ("mesh.wirewarp_select_result", {"what": "PIECE", "index": 0}),
    ("object.wirewarp_export_svg", {}),
    ("mesh.wirewarp_mark", {"kind": "RIGID"}),
    ("object.wirewarp_flatten", {}),
]


class AnyLayout:
    """Accepts everything that a panel draws, and keeps the texts and the names of operators."""

    def __init__(self, words, buttons):
        vars(self).update(words=words, buttons=buttons)

    def __getattr__(self, _name):
        return lambda *_, **__: AnyLayout(self.words, self.buttons)

    def operator(self, name, text="", **_):
        self.buttons.append(name)
        self.words.append(text)
        return AnyLayout(self.words, self.buttons)

    def __setattr__(self, _name, _value):
        pass

    def label(self, text="", **_):
        self.words.append(text)

    def menu(self, name, **_):
        kind = getattr(bpy.types, name)
        kind.draw(SimpleNamespace(layout=self), sidebar())

    def prop(self, owner, name, **_):
        self.words.append(str(getattr(owner, name)))

    def template_list(self, kind, _id, owner, name, *_, **__):
        for index, entry in enumerate(getattr(owner, name)):
            getattr(bpy.types, kind).draw_item(None, sidebar(), self, owner, entry, 0, owner, "", index)


def sidebar(width=300):
    """Return a stand-in for the context of a panel. Without a window, Blender has no such context."""
    view, own = view_context(), bpy.context
    names = ("active_object", "selected_objects", "objects_in_mode_unique_data", "tool_settings", "mode")
    system = SimpleNamespace(ui_scale=1.0)
    return SimpleNamespace(
        scene=view.scene,
        view_layer=view.view_layer,
        space_data=SimpleNamespace(overlay=view.space_data.overlay, mode="UV"),
        region=SimpleNamespace(width=width),
        preferences=SimpleNamespace(system=system, ui_styles=own.preferences.ui_styles),
        **{name: getattr(own, name) for name in names},
    )


def draw_panels(addon, buttons=None):
    """Draw all visible panels, narrow and wide. Return their texts, and add their operators to `buttons`."""
    addon.state.drawings.forget()  # otherwise, changes in quick succession would be drawn late
    words, buttons = [], [] if buttons is None else buttons
    for cls in addon.registration.CLASSES:
        if not issubclass(cls, bpy.types.Panel):
            continue
        parts = [vars(base) for base in reversed(cls.__mro__) if base.__module__.startswith(addon.__name__)]
        own = {name: part for each in parts for name, part in each.items() if not name.startswith(("__", "bl_rna"))}
        # Only Blender can create panels, so a stand-in is drawn.
        panel = type(cls.__name__, (), own | {"layout": AnyLayout(words, buttons)})()
        for width in (200, 600):
            context = sidebar(width)
            if "poll" not in own or cls.poll(context):
                panel.draw(context)
                if "draw_header_preset" in own:
                    panel.draw_header_preset(context)
    return " ".join(words)


def drawn_buttons(addon):
    """Return the names of the operators in all visible panels, each drawn narrow and wide."""
    buttons = []
    draw_panels(addon, buttons)
    return buttons


def draw_overlays(addon, shown_map):
    bpy.context.scene.wirewarp.shown_map = "NONE"
    list(addon.overlay.shown.drawings(view_context()))
    bpy.context.scene.wirewarp.shown_map = shown_map
    shown = list(addon.overlay.shown.drawings(view_context()))
    color_map = addon.overlay.shown.shown_map(view_context())
    addon.overlay.shown.map_notes(shown, color_map)
    addon.overlay.shown.highest_value(shown, color_map)
    list(addon.overlay.shown.uv_drawings(sidebar()))


def answer(command, **settings):
    """Call an operator, and return its result or error as text. The text must not contain a traceback."""
    group, name = command.split(".")
    try:
        said = str(getattr(getattr(bpy.ops, group), name)(**settings))
    except RuntimeError as error:
        said = str(error)
    assert "Traceback" not in said, f"{command} {settings}: {said}"
    return said


def to_object_mode():
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")


def stored():
    """Return marks, names and reports of all meshes. Only successful operators may change them. Needs Object Mode."""
    return {each.name_full: _stored_on(each) for each in bpy.data.objects if each.type == "MESH"}


def _stored_on(target):
    mesh = target.data
    return (
        # The values are sorted, because Edit Mode may reorder the attributes.
        sorted(_values(each) for each in mesh.attributes if each.name.startswith(OURS)),
        read(mesh.edges, "use_seam", bool).tobytes(),
        [(entry.wire_id, entry.name) for entry in mesh.wirewarp_names],
        mesh.wirewarp_grain,
        [(entry.piece_id, entry.name) for entry in target.wirewarp_pieces],
        [(entry.seam_id, entry.name) for entry in target.wirewarp_seams],
        [(name, _value(value)) for owner in (target, mesh) for name, value in owner.items() if name.startswith(OURS)],
    )


def _value(stored):
    return stored if isinstance(stored, str | int | float) else type(stored)


def _values(attribute):
    """Return name, type, domain and values of an attribute. Values are bytes, because NaN does not equal itself."""
    dtype = {"INT": np.int32, "FLOAT": np.float32}.get(attribute.data_type)
    values = read(attribute.data, "value", dtype).tobytes() if dtype else b""
    return attribute.name, attribute.data_type, attribute.domain, values


def place():
    context = bpy.context
    return context.mode, context.active_object, set(context.selected_objects), set(context.objects_in_mode)


def call(command, settings, before):
    """Call a command, and check that it changes nothing unless it finishes. before: stored() before the call."""
    where = place()
    said = answer(command, **settings)
    # Flatten and repairs may fail for some pieces only, so nothing is checked after them.
    if said == "{'FINISHED'}" or "flatten" in command or "mend" in command:
        return
    assert place() == where, f"{command} {settings}: {said}"
    to_object_mode()
    assert stored() == before, f"{command} {settings}: {said}"


def use_everything(addon, name, mode, folder, commands):
    """Draw everything with this object active, and call these commands in this mode.

    folder: folder for the pattern and the .blend file.
    """
    shown_map = "STRETCH_COLOR" if mode == "OBJECT" else "WEFT_STRAIN_COLOR"
    for command, settings in [(None, {}), *commands]:
        to_object_mode()
        target = bpy.context.view_layer.objects.get(name)
        if target is None or not target.visible_get():
            break
        select_only(target)
        before = stored()
        if mode == "EDIT" and target.type == "MESH" and not (target.data.library or target.data.override_library):
            bpy.ops.object.mode_set(mode="EDIT")
            bpy.ops.mesh.select_all(action="SELECT")
        if command is None:
            draw_panels(addon)
            draw_overlays(addon, shown_map)
        else:
            path = {"filepath": str(folder / "pattern.svg")} if "export" in command else {}
            call(command, settings | path, before)
    to_object_mode()
    draw_panels(addon)
    draw_overlays(addon, shown_map)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "hostile.blend"))


def export_dialog(addon, **settings):
    """Return a stand-in for the export dialog with these settings. All others have their defaults."""
    module, properties = addon.export, bpy.ops.object.wirewarp_export.get_rna_type().properties
    defaults = {each.identifier: each.default for each in properties if hasattr(each, "default")}
    defaults["drawn"] = module.operators.ALL_DRAWN
    bases = vars(module.steps.PatternExport) | vars(module.operators.OBJECT_OT_wirewarp_export)
    return type("Dialog", (), {**bases, **defaults, **settings})()
