# SPDX-License-Identifier: GPL-3.0-or-later
"""WireWarp: flat pieces with exact seam and wire lengths.

Marking:    operators/mark -> edit_marks -> marking, wire_chains; the marks are edge attributes (wire_attributes).
Flattening: operators/flatten -> read_models: targets (may it be written?), mesh_to_arrays -> solve_models, in a window
            in a thread (window_run): flatten_job (the core library), report, flat_mesh -> write_results: write_uv,
            write_flat_object, report_store. All is computed before anything is written.
Updating:   auto_update notes changes, operators/update flattens again what has flat pieces.
            Names and places of pieces stay from run to run by ids on their faces (pieces/); write_texts labels them.
Mending:    operators/take_proposal -> take_proposals writes what the report proposes (proposals) to the model.
Showing:    ui/, from wire_summary and report_store; overlay/ draws over models and flat pieces in the 3D view, and
            over their map in the UV editor.
Exporting:  operators/export_svg -> read_pattern (are the pieces still true?) -> pattern/: outlines, wires, notches and
            texts, in svg a file.
"""

from . import core, properties, registration

bl_info = {
    "name": "WireWarp",
    "description": "Flat patterns with exact seam and wire lengths",
    "author": "WireWarp contributors",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > WireWarp",
    "category": "Mesh",
}

# Blender deletes bl_info from extensions once they are imported.
VERSION = ".".join(map(str, bl_info["version"]))


def register() -> None:
    core.load(VERSION)
    registration.register_classes()
    properties.attach()
    registration.register_ui()


def unregister() -> None:
    registration.unregister_ui()
    properties.detach()
    registration.unregister_classes()
