# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tours in Blender's window on a virtual screen. The tours of a script share one Blender."""

from pathlib import Path

import pytest

from tools.blender_window import run_tours

SECONDS = 400.0  # limit for each tour; most take about ten seconds, but some machines are slow


TOURS = {
    "tours": [
        "panel_button",
        "one_undo_step",
        "one_undo_step_in_edit_mode",
        "auto_update",
        "auto_update_waits_for_a_tool",
        "settings_can_be_adjusted_after_a_run",
        "report_shows_the_place",
        "report_turns_the_view_to_elements_on_the_back",
        "copies_the_report",
    ],
    "run_tours": [
        "escape_cancels",
        "only_one_run",
        "a_changed_model_is_not_written",
        "a_failed_piece_opens_no_window",
        "a_fault_of_the_core_is_reported",
        "cancel_button",
        "fixing_is_one_undo_step",
    ],
    "update_tours": [
        "a_tool_begun_during_an_update_goes_on",
        "an_update_does_not_end_in_another_mode",
        "an_update_does_not_end_in_another_scene",
    ],
    "overlay_tours": [
        "lines_are_on_the_screen",
        "lines_are_whole_in_a_large_scene",
        "lines_are_in_the_uv_editor",
        "marks_are_undone",
        "frame_button",
    ],
    "export_tours": [
        "the_dialog_says_the_size_and_follows_its_settings",
        "escape_leaves_the_file_as_it_was",
        "four_clicks_lead_from_an_opened_garment_to_paper",
    ],
    "suggest_tours": [
        "a_suggestion_is_taken_and_undone_with_one_click_each",
        "a_smooth_dart_is_cut_and_undone_with_one_click_each",
        "a_smooth_set_is_cut_and_undone_with_one_click_each",
        "seams_are_simplified_and_undone_with_one_click_each",
        "the_list_appears_below_the_button_that_was_pressed",
        "buttons_keep_their_places_during_a_run",
        "escape_ends_the_search",
        "a_model_that_changes_during_the_search_gets_no_suggestion",
        "a_search_ends_under_a_tool",
        "a_fault_of_the_core_ends_the_search",
    ],
    "pages_tours": ["pages_are_on_the_screen"],
    "view_tours": [
        "pieces_are_seen_in_local_view",
        "the_first_pieces_are_brought_into_view",
        "buttons_keep_their_places_in_edit_mode",
        "search_finds_commands_by_the_add_on_s_name",
    ],
}


# Each of these tours has its own Blender, because it loads another file, registers the add-on again, or quits.
ALONE = ["another_file_ends_the_run", "unregistering_ends_the_run", "quitting_ends_the_run"]


@pytest.mark.parametrize(("script", "names"), [*TOURS.items(), *(("run_tours", [name]) for name in ALONE)])
def test_window(script, names, tmp_path):
    file = Path(__file__).with_name(f"{script}.py")
    # The processor draws all pixels. With one sample per pixel, this takes a quarter of the time of eight samples.
    code, output = run_tours(file, names, tmp_path, SECONDS * len(names), WIREWARP_VIEWPORT_AA="OFF")
    assert code == 0, output
