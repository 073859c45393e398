# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Iterator
from contextlib import contextmanager

import gpu


@contextmanager
def blending() -> Iterator[None]:
    """Draws see-through colors as such; leaves the state as it was."""
    before = gpu.state.blend_get()
    gpu.state.blend_set("ALPHA")
    try:
        yield
    finally:
        gpu.state.blend_set(before)
