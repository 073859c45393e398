# SPDX-License-Identifier: GPL-3.0-or-later
"""Waits for processes that other processes have started."""

import time

import psutil


def wait_until_gone(pid):
    """Wait until the process has ended, which takes a while on a busy system."""
    end = time.monotonic() + 60
    while not _is_gone(pid):
        assert time.monotonic() < end
        time.sleep(0.01)


def _is_gone(pid):
    try:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE  # in containers, its exit code may never be read
    except psutil.NoSuchProcess:
        return True
