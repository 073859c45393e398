# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers, what is printed on them, and how lines look in every format."""
