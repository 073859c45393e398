# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers, their content, and the look of lines in every format."""
