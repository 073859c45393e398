# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pieces of a pattern: from flat pieces to cut lines, notches and folds."""
