# SPDX-License-Identifier: GPL-3.0-or-later
"""The flat pieces as things of their own: what they are called, and how they are known again in the next run."""
