# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists the view of each sample: its rotation to the left and its tilt toward the viewer, in degrees."""

VIEWS = {
    "fitted_top": (-28, 8),
    "quarter_sphere": (-62, 10),
    "ball_of_six_gores": (-20, 22),
    "half_cylinder": (-62, 20),
    "lampshade": (-52, 14),
    "cushion": (-30, 28),
    "hat": (-40, 20),
    "carnival_mask": (-18, 6),
    "jeans": (152, 8),
    "wetsuit_collar": (-28, 16),
    "wetsuit_upper_body": (-30, 10),
    "toy": (-28, 14),
    "armchair_cover": (-32, 20),
    "swimsuit": (-28, 8),
    "set-in_sleeve": (-24, 8),
    "gathered_skirt": (-28, 14),
}
