# SPDX-License-Identifier: GPL-3.0-or-later
"""Data as text after its digest, for custom properties: text that a user or a script has changed is not read."""

import hashlib
import json
from typing import Any

DIGITS = 24  # of the digest


def sealed(data: dict[str, Any]) -> str:
    text = json.dumps(data)
    return _digest(text) + text


def unsealed(stored: object) -> dict[str, Any] | None:
    """Returns the data; None if sealed() has not made this text."""
    if not isinstance(stored, str) or stored[:DIGITS] != _digest(stored[DIGITS:]):
        return None
    return json.loads(stored[DIGITS:])


def _digest(text: str) -> str:
    return hashlib.blake2b(text.encode(errors="replace"), digest_size=DIGITS // 2).hexdigest()
