# SPDX-License-Identifier: GPL-3.0-or-later
"""A button as a bar while its run goes on, and beside it what stops the run."""

import bpy

from ..run.window_run import Task, shown_progress


def draw_progress(row: bpy.types.UILayout, task: Task, operator: str) -> bool:
    """Whether a run of this kind goes on; else nothing is drawn. operator: that the button runs.

    Before Blender 4.0 there is no bar, but the button, gray.
    """
    done = shown_progress(task)
    if done is None:
        return False
    text = f"{task.doing} {100 * done:.0f}%" if done < 1 else f"{task.finishing}..."
    if hasattr(row, "progress"):
        row.progress(factor=done, text=text)
    else:
        bar = row.row(align=True)
        bar.enabled = False
        bar.operator(operator, text=text)
    row.operator("object.wirewarp_cancel", text="", icon="X")
    return True
