# SPDX-License-Identifier: GPL-3.0-or-later
"""Waits for the end of processes that other processes have started."""

import time

import psutil


def wait_until_gone(pid):
    end = time.monotonic() + 60
    while not _is_gone(pid):
        assert time.monotonic() < end
        time.sleep(0.01)


def _is_gone(pid):
    try:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE  # in a container, zombies may stay
    except psutil.NoSuchProcess:
        return True
