# SPDX-License-Identifier: GPL-3.0-or-later
"""Catches errors of the library."""

import pytest
from wirewarp import ErrorCode, FlattenError


def error_of(call) -> FlattenError:
    """Return the error that the call raises. If it raises none, the test fails."""
    with pytest.raises(FlattenError) as caught:
        call()
    return caught.value


def code_of(call) -> ErrorCode:
    return error_of(call).code
