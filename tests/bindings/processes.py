# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes that others have started."""

import time

import psutil


def wait_until_gone(pid):
    """A system that has much to do takes a while to end it."""
    end = time.monotonic() + 60
    while not _is_gone(pid):
        assert time.monotonic() < end
        time.sleep(0.01)


def _is_gone(pid):
    try:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE  # in containers nobody may ask for its code
    except psutil.NoSuchProcess:
        return True
