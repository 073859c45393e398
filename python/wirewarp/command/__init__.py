# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the command line, which makes reports and patterns from files of models. docs/command.md describes it."""
