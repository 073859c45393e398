# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: from files of models to reports and patterns. docs/command.md describes it."""
