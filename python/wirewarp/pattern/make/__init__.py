# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pieces of a pattern from flat pieces, with cutting lines, notches and folds."""
